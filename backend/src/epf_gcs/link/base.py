"""What every byte link can do, whatever carries it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from epf_gcs.errors import LinkError


class Tap(Protocol):
    """Sees every byte of a link before anybody interprets it."""

    def received(self, data: bytes) -> None:
        """Bytes as they came from the other side."""

    def sent(self, data: bytes) -> None:
        """Bytes that were accepted for the other side."""


class Link(Protocol):
    """An open byte stream to the board. Calls never block and never raise on a lost device."""

    @property
    def baud(self) -> int:
        """Bits per second of the line, 10 of them a byte; the reference for its use in percent."""

    @property
    def backlog(self) -> int:
        """Bytes written that have not left this machine yet, as far as the system tells."""

    def start(self, callbacks: LinkCallbacks) -> None:
        """Begin to read; until now the bytes waited in the system."""

    def write(self, data: bytes) -> bool:
        """Send now, or queue what the system does not take. False: the queue is full, nothing was taken."""

    def close(self) -> None:
        """Let the device go. No callback comes after this."""


@dataclass(frozen=True, slots=True)
class LinkCallbacks:
    """Whom a link tells. All are called on the event loop; `on_lost` at most once, and the link is closed by then."""

    on_bytes: Callable[[bytes], None]
    on_lost: Callable[[LinkError], None]
    tap: Tap | None = None


@dataclass(frozen=True, slots=True)
class Device:
    """An opened, non-blocking descriptor and how to look after it."""

    name: str
    fd: int
    baud: int
    close: Callable[[], None]
    kernel_backlog: Callable[[], int]
