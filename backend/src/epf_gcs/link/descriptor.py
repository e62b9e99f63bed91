"""A link over any non-blocking descriptor: serial port, pseudo-terminal or TCP socket."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Final

from epf_gcs.errors import LinkError
from epf_gcs.link.base import Device, LinkCallbacks, Tap
from epf_gcs.link.failures import lost_error

# More than a second of the fastest line; older data would be useless to the board.
_MAX_PENDING_BYTES: Final = 131072
# A terminal returns no more per read, and each read into a larger buffer costs a memory mapping.
_READ_BYTES: Final = 4096
# The most bytes that a terminal can be told to wait for.
_MOST_AWAITED: Final = 255
# If the line falls silent while we wait for more bytes, those already there are read after one to two times this.
_PATIENCE_S: Final = 0.1


def _nobody(_: object) -> None:
    """The callback before `start`: ignore."""


def _unknown() -> int:
    return 0


class DescriptorLink:
    """Reads in the event loop's callback when the descriptor is readable: without a thread and its delay.

    A frame comes in many pieces, and only the last one completes it. Where the system supports it, we are woken for
    the last one only. Made on a running loop. Implements `Link`.
    """

    def __init__(self, device: Device) -> None:
        self._device = device
        self._on_bytes: Callable[[bytes], None] = _nobody
        self._on_lost: Callable[[LinkError], None] = _nobody
        self._tap: Tap | None = None
        self._loop = asyncio.get_running_loop()
        self._pending = bytearray()
        self._closed = False
        self._missing_bytes: Callable[[], int] = _unknown
        self._wait_for = device.wait_for
        self._awaited = 1
        self._has_read = False
        self._patience: asyncio.TimerHandle | None = None

    def start(self, callbacks: LinkCallbacks) -> None:
        """Begin to read; bytes that came before wait in the operating system's buffer."""
        self._on_bytes = callbacks.on_bytes
        self._on_lost = callbacks.on_lost
        self._tap = callbacks.tap
        self._missing_bytes = callbacks.missing_bytes
        self._loop.add_reader(self._device.fd, self._readable)

    @property
    def baud(self) -> int:
        """Bits per second of the line."""
        return self._device.baud

    @property
    def backlog(self) -> int:
        """Bytes in our queue and in the kernel's that have not left yet."""
        if self._closed:
            return 0
        return len(self._pending) + self._device.kernel_backlog()

    def write(self, data: bytes) -> bool:
        """Write at once what the system takes and queue the rest; False if the whole of it does not fit."""
        if self._closed or len(self._pending) + len(data) > _MAX_PENDING_BYTES:
            return False
        if self._awaited > 1 and self._missing_bytes() < 1:
            # The bytes that we waited for are no longer expected; the answer to this write may be shorter.
            self._await_any()
        written = 0
        if not self._pending:
            try:
                written = self._device.write(data)
            except (BlockingIOError, InterruptedError):
                written = 0
            except OSError as error:
                self._lose(error.strerror or str(error))
                return False
        if self._tap is not None:
            self._tap.sent(data)
        if written < len(data):
            if not self._pending:
                self._loop.add_writer(self._device.fd, self._writable)
            self._pending += data[written:]
        return True

    def close(self) -> None:
        """Close the device; what is still queued is dropped."""
        if self._closed:
            return
        self._closed = True
        self._loop.remove_reader(self._device.fd)
        self._loop.remove_writer(self._device.fd)
        if self._patience is not None:
            self._patience.cancel()
        self._device.close()

    def _readable(self) -> None:
        try:
            data = self._device.read(_READ_BYTES)
        except (BlockingIOError, InterruptedError):
            return
        except OSError as error:
            self._lose(error.strerror or str(error))
            return
        if not data:
            self._lose("the other side closed it")
            return
        tap = self._tap
        if tap is not None:
            tap.received(data)
        self._on_bytes(data)
        if self._wait_for is not None:
            self._await_rest(self._wait_for)

    def _await_rest(self, wait_for: Callable[[int], None]) -> None:
        """Be woken only when all bytes missing to a frame can be there, not for each piece of it."""
        self._has_read = True
        missing = self._missing_bytes()
        awaited = 1 if missing < 1 else min(missing, _MOST_AWAITED)
        if awaited == self._awaited or self._closed:
            return
        self._awaited = awaited
        wait_for(awaited)
        if self._patience is None:
            self._patience = self._loop.call_later(_PATIENCE_S, self._look_for_silence)

    def _look_for_silence(self) -> None:
        """If nothing was read since the last look, stop waiting and read what is there: the rest may never come."""
        self._patience = None
        if self._awaited == 1:
            return
        if self._has_read:
            self._has_read = False
            self._patience = self._loop.call_later(_PATIENCE_S, self._look_for_silence)
            return
        self._await_any()

    def _await_any(self) -> None:
        self._awaited = 1
        if self._wait_for is not None:
            self._wait_for(1)

    def _writable(self) -> None:
        try:
            written = self._device.write(self._pending)
        except (BlockingIOError, InterruptedError):
            return
        except OSError as error:
            self._lose(error.strerror or str(error))
            return
        del self._pending[:written]
        if not self._pending:
            self._loop.remove_writer(self._device.fd)

    def _lose(self, reason: str) -> None:
        if self._closed:
            return
        self.close()
        self._on_lost(lost_error(self._device.name, reason))
