"""The interface of every byte link, for any kind of device."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from typing import Protocol

from epf_gcs.errors import LinkError


class Tap(Protocol):
    """Sees every byte of a link before it is decoded; the recorder is one."""

    def received(self, data: bytes, ago_s: float = 0.0) -> None:
        """Bytes as they came from the other side; the last of them came so long ago."""

    def sent(self, data: bytes) -> None:
        """Bytes that were accepted for the other side."""


class Link(Protocol):
    """An open byte stream to the board. Calls never block and never raise on a lost device."""

    @property
    def baud(self) -> int:
        """Bits per second of the line (a byte takes 10 bits); the reference for its load in percent."""

    @property
    def backlog(self) -> int:
        """Bytes written that have not left this machine yet, as far as the operating system reports it."""

    def start(self, callbacks: LinkCallbacks) -> None:
        """Begin to read; bytes that came before wait in the operating system's buffer."""

    def deliver(self) -> None:
        """Deliver at once what came and may have waited: what comes after this call is newer than it."""

    def write(self, data: bytes) -> bool:
        """Send now, or queue what the system does not take. False: the queue is full, nothing was taken."""

    def close(self) -> None:
        """Close the device. No callback comes after this."""


def _unknown(_: bytes) -> int:
    return 0


def _never() -> bool:
    return False


@dataclass(frozen=True, slots=True)
class LinkCallbacks:
    """The callbacks of a link, all called on the event loop; `on_lost` at most once, after the link has closed.

    `missing_bytes` is asked after each `on_bytes`: how many bytes are still needed for a frame; 0 if unknown. A link
    may wait until so many are there, and deliver fewer only when the line falls silent. Its argument are the next
    bytes, as far as they are known.

    While `may_wait` says that nobody needs the bytes as they come, a link on which they come without a gap may deliver
    them some milliseconds late and with their times; all that one read brought inside `together`.
    """

    on_bytes: Callable[[bytes], None]
    on_lost: Callable[[LinkError], None]
    tap: Tap | None = None
    missing_bytes: Callable[[bytes], int] = _unknown
    may_wait: Callable[[], bool] = _never
    together: Callable[[], AbstractContextManager[None]] = nullcontext


@dataclass(frozen=True, slots=True)
class Device:
    """An opened, non-blocking descriptor and the functions that belong to it.

    `read(most)` and `write(data)` take what is there, or raise BlockingIOError; they raise OSError once it is lost.
    `wait_for` makes the descriptor readable only when so many bytes are there (1 to 255); None if not supported.
    `is_serial`: bytes come no faster than `baud`, and none waits anywhere on its way.
    """

    name: str
    fd: int
    baud: int
    close: Callable[[], None]
    kernel_backlog: Callable[[], int]
    read: Callable[[int], bytes]
    write: Callable[[bytes | bytearray], int]
    wait_for: Callable[[int], None] | None = None
    is_serial: bool = False
