"""A link over any non-blocking descriptor: serial port, pseudo-terminal or TCP socket."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from time import monotonic
from typing import Final

from epf_gcs.errors import LinkError
from epf_gcs.link.base import Device, LinkCallbacks, Tap
from epf_gcs.link.failures import lost_error
from epf_gcs.link.read_budget import ReadBudget
from epf_gcs.link.unbroken import ByteTimes
from epf_gcs.repeating import Repeating

# More than a second of the fastest line; older data would be useless to the board.
_MAX_PENDING_BYTES: Final = 131072
# A terminal returns no more per read, and each read into a larger buffer costs a memory mapping.
_READ_BYTES: Final = 4096
# The most bytes that a terminal can be told to wait for.
_MOST_AWAITED: Final = 255
# If the line falls silent while we wait for more bytes, those already there are read after one to two times this.
_PATIENCE_S: Final = 0.1
# Time between two reads while nobody needs the bytes as they come: that between two pictures of a page.
_REST_S: Final = 1.0 / 60.0
# On a fast line less, so that half of what a terminal holds (4096 bytes) comes between two reads.
_REST_BYTES: Final = 2048
# Something was written: an answer is expected, which must not wait.
_AWAKE_S: Final = 1.0
# As many of the next bytes as tell how long a frame is.
_AHEAD_BYTES: Final = 8


def _nobody(_: object) -> None:
    """The callback before `start`: ignore."""


class DescriptorLink:
    """Reads in the event loop's callback when the descriptor is readable: without a thread and its delay.

    A frame comes in many pieces, and only the last one completes it. Where the system supports it, we are woken for
    the last one only. While nobody needs the bytes as they come, and they come without a gap, we rest: nothing wakes
    us, and we read 60 times a second. A line that sends more than any board's line carries is read no faster than
    `ReadBudget` allows: its bytes wait at the other end, none is lost. Made on a running loop. Implements `Link`.
    """

    def __init__(self, device: Device, now_s: Callable[[], float] = monotonic) -> None:
        self._now_s = now_s
        self._budget = ReadBudget(now_s())
        self._loop = asyncio.get_running_loop()
        self._pause = Repeating(self._loop, "a line held back", self._read_on)
        self.held_back = 0
        """How many times reading was paused because more came than is read."""
        self._device = device
        self._on_bytes: Callable[[bytes], None] = _nobody
        self._on_lost: Callable[[LinkError], None] = _nobody
        self._tap: Tap | None = None
        self._pending = bytearray()
        self._closed = False
        self._callbacks = LinkCallbacks(_nobody, _nobody)
        self._wait_for = device.wait_for
        self._awaited = 1
        self._has_read = False
        self._patience = Repeating(self._loop, "the end of an awaited frame", self._look_for_silence, _PATIENCE_S)
        self._unbroken = ByteTimes(device.baud) if device.is_serial else None
        self._rest_s = min(_REST_S, _REST_BYTES * 10.0 / device.baud)
        # Since when the bytes are counted that tell whether the line has a gap, and how many came.
        self._counted_from_s = 0.0
        self._count = 0
        self._awake_until_s = 0.0
        # What cannot be taken costs itself alone: the line is read on.
        self._rest = Repeating(self._loop, "the bytes of a line", self._look_late, self._rest_s)

    def start(self, callbacks: LinkCallbacks) -> None:
        """Begin to read; bytes that came before wait in the operating system's buffer."""
        self._on_bytes = callbacks.on_bytes
        self._on_lost = callbacks.on_lost
        self._tap = callbacks.tap
        self._callbacks = callbacks
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

    def deliver(self) -> None:
        """Deliver at once what came during a rest."""
        if self._rest.is_armed:
            self._rest.run_now()

    def write(self, data: bytes) -> bool:
        """Write at once what the system takes and queue the rest; False if the whole of it does not fit."""
        if not self._closed:
            self._wake_up()
        if self._closed or len(self._pending) + len(data) > _MAX_PENDING_BYTES:
            return False
        if self._awaited > 1 and self._callbacks.missing_bytes(b"") < 1:
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
        for timer in (self._patience, self._rest, self._pause):
            timer.stop()
        self._device.close()

    def _readable(self) -> None:
        data = self._read()
        if not data:
            return
        tap = self._tap
        if tap is not None:
            tap.received(data)
        self._on_bytes(data)
        pause_s = self._budget.take(len(data), self._now_s())
        if pause_s:
            self._hold_back(pause_s)
        elif self._unbroken is not None and self._may_rest(self._unbroken, len(data)):
            self._loop.remove_reader(self._device.fd)
            self._rest.arm(self._rest_s)
        elif self._wait_for is not None:
            self._await_rest(self._wait_for)

    def _hold_back(self, pause_s: float) -> None:
        if not self._closed:
            self.held_back += 1
            self._loop.remove_reader(self._device.fd)
            self._pause.arm(pause_s)

    def _read_on(self) -> None:
        self._loop.add_reader(self._device.fd, self._readable)

    def _read(self) -> bytes:
        """What is there; empty if there is nothing, or if the device was lost."""
        try:
            data = self._device.read(_READ_BYTES)
        except (BlockingIOError, InterruptedError):
            return b""
        except OSError as error:
            self._lose(error.strerror or str(error))
            return b""
        if not data:
            self._lose("the other side closed it")
        return data

    def _may_rest(self, unbroken: ByteTimes, count: int) -> bool:
        """Whether nobody needs the bytes as they come, and they came without a gap for as long as a rest takes."""
        now_s = monotonic()
        lasted_s = now_s - self._counted_from_s
        self._count += count
        if lasted_s < self._rest_s:
            return False
        was_unbroken = unbroken.holds(self._count, lasted_s)
        self._counted_from_s, self._count = now_s, 0
        return was_unbroken and not self._closed and now_s > self._awake_until_s and self._callbacks.may_wait()

    def _look_late(self) -> float | None:
        """Read after a rest and deliver with the time of each frame; go on resting if nothing speaks against it."""
        unbroken = self._unbroken
        if unbroken is None:
            return None
        now_s = monotonic()
        lasted_s = now_s - self._counted_from_s
        data = self._read()
        self._counted_from_s, self._count = now_s, 0
        if self._closed:
            return None
        with self._callbacks.together():
            self._deliver(data, unbroken, lasted_s)
        is_open = not self._closed
        if not is_open:
            return None
        if unbroken.holds(len(data), lasted_s) and now_s > self._awake_until_s and self._callbacks.may_wait():
            # On a fixed grid, so that the mean rate is exact; after a pause it starts anew.
            now_s = self._loop.time()
            return max(min(self._rest.due_s, now_s) + self._rest_s, now_s + 0.5 * self._rest_s) - now_s
        self._loop.add_reader(self._device.fd, self._readable)
        if self._wait_for is not None:
            self._await_rest(self._wait_for)
        return None

    def _wake_up(self) -> None:
        """Something is written: what came before is delivered, and so recorded, before it, and no answer waits."""
        self._awake_until_s = monotonic() + _AWAKE_S
        self.deliver()

    def _deliver(self, data: bytes, unbroken: ByteTimes, lasted_s: float) -> None:
        """Frame by frame, each with the time at which its last byte came, until the link is closed."""
        start, count, tap = 0, len(data), self._tap
        while start < count and not self._closed:
            missing = self._callbacks.missing_bytes(data[start : start + _AHEAD_BYTES])
            stop = min(count, start + missing) if missing > 0 else count
            piece, start = data[start:stop], stop
            if tap is not None:
                tap.received(piece, unbroken.ago_s(count - stop, count, lasted_s))
            self._on_bytes(piece)

    def _await_rest(self, wait_for: Callable[[int], None]) -> None:
        """Be woken only when all bytes missing to a frame can be there, not for each piece of it."""
        self._has_read = True
        missing = self._callbacks.missing_bytes(b"")
        awaited = 1 if missing < 1 else min(missing, _MOST_AWAITED)
        if awaited == self._awaited or self._closed:
            return
        self._awaited = awaited
        wait_for(awaited)
        self._patience.arm(_PATIENCE_S)

    def _look_for_silence(self) -> float | None:
        """If nothing was read since the last look, stop waiting and read what is there: the rest may never come."""
        if self._awaited == 1:
            return None
        if self._has_read:
            self._has_read = False
            return _PATIENCE_S
        self._await_any()
        return None

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
