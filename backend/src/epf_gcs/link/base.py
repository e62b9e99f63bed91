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


def _unknown() -> int:
    return 0


@dataclass(frozen=True, slots=True)
class LinkCallbacks:
    """Whom a link tells. All are called on the event loop; `on_lost` at most once, and the link is closed by then.

    `missing_bytes` is asked after each `on_bytes`: how many bytes must still come before it is worth being told of
    them; 0 where nobody knows. A link may wait for them, and hand over less only when the line falls silent.
    """

    on_bytes: Callable[[bytes], None]
    on_lost: Callable[[LinkError], None]
    tap: Tap | None = None
    missing_bytes: Callable[[], int] = _unknown


@dataclass(frozen=True, slots=True)
class Device:
    """An opened, non-blocking descriptor and how to look after it.

    `wait_for` has the system say "readable" only when so many bytes are there (1 to 255); None where it cannot.
    """

    name: str
    fd: int
    baud: int
    close: Callable[[], None]
    kernel_backlog: Callable[[], int]
    wait_for: Callable[[int], None] | None = None
