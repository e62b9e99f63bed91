"""A link over any non-blocking descriptor: serial port, pseudo-terminal or TCP socket."""

from __future__ import annotations

import asyncio
import os
from collections.abc import Callable
from typing import Final

from epf_gcs.errors import LinkError
from epf_gcs.link.base import Device, LinkCallbacks, Tap
from epf_gcs.link.failures import lost_error

# More than a second of the fastest line; what is older than that helps nobody.
_MAX_PENDING_BYTES: Final = 131072
# A terminal gives no more at a time, and a larger buffer costs a new mapping for every few bytes.
_READ_BYTES: Final = 4096


def _nobody(_: object) -> None:
    """Before `start` nobody listens."""


class DescriptorLink:
    """Reads when the descriptor is readable, straight from the event loop: no thread, no extra hop.

    Made on a running loop. Implements `Link`.
    """

    def __init__(self, device: Device) -> None:
        self._device = device
        self._on_bytes: Callable[[bytes], None] = _nobody
        self._on_lost: Callable[[LinkError], None] = _nobody
        self._tap: Tap | None = None
        self._loop = asyncio.get_running_loop()
        self._pending = bytearray()
        self._closed = False

    def start(self, callbacks: LinkCallbacks) -> None:
        """Begin to read; until now the bytes waited in the system."""
        self._on_bytes = callbacks.on_bytes
        self._on_lost = callbacks.on_lost
        self._tap = callbacks.tap
        self._loop.add_reader(self._device.fd, self._readable)

    @property
    def baud(self) -> int:
        """Bits per second of the line."""
        return self._device.baud

    @property
    def backlog(self) -> int:
        """Bytes of ours and of the kernel's queue that have not left yet."""
        if self._closed:
            return 0
        return len(self._pending) + self._device.kernel_backlog()

    def write(self, data: bytes) -> bool:
        """Write at once what the system takes and queue the rest, whole messages only."""
        if self._closed or len(self._pending) + len(data) > _MAX_PENDING_BYTES:
            return False
        written = 0
        if not self._pending:
            try:
                written = os.write(self._device.fd, data)
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
        """Let the device go; what is still queued is dropped."""
        if self._closed:
            return
        self._closed = True
        self._loop.remove_reader(self._device.fd)
        self._loop.remove_writer(self._device.fd)
        self._device.close()

    def _readable(self) -> None:
        try:
            data = os.read(self._device.fd, _READ_BYTES)
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

    def _writable(self) -> None:
        try:
            written = os.write(self._device.fd, self._pending)
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
