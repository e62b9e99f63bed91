"""What sees the bytes of both lines first: gives them their time, and hands them to the recorder."""

from __future__ import annotations

from collections import deque
from typing import Final

from epf_gcs.flight.clock.line_clock import LineClock
from epf_gcs.recordings.topics import BOARD_RECEIVED, BOARD_SENT, SIMULATOR_RECEIVED, SIMULATOR_SENT

# Entries, about a minute of a full line and a simulator: a disk this far behind will not catch up.
_MAX_QUEUED: Final = 100_000

# What waits for the writer: (topic, or NOTE; Unix time in ns; bytes). None ends the session.
Entry = tuple[int, int, bytes] | None
NOTE: Final = 0


class LineTap:
    """Hands the bytes of one line to the recorder; see `epf_gcs.link.base.Tap`. Never blocks.

    This runs first for every chunk of a line, so it does no more than look at the clock and append. With no queue it
    records nothing, and what is decoded has the same times.
    """

    __slots__ = ("_clock", "_queue", "_received", "_sent", "lost")

    def __init__(self, clock: LineClock, queue: deque[Entry] | None, received: int, sent: int) -> None:
        self._clock = clock
        self._queue = queue
        self._received = received
        self._sent = sent
        self.lost = 0

    def received(self, data: bytes, ago_s: float = 0.0) -> None:
        """Take bytes that arrived, the last of them so long ago."""
        self._put(self._received, self._clock.received(self._received, ago_s), data)

    def sent(self, data: bytes) -> None:
        """Take bytes that were sent."""
        self._put(self._sent, self._clock.sent(self._sent), data)

    def _put(self, topic: int, t_ns: int, data: bytes) -> None:
        queue = self._queue
        if queue is None:
            return
        if len(queue) < _MAX_QUEUED:
            queue.append((topic, t_ns, data))
        else:
            self.lost += len(data)


def line_taps(clock: LineClock, queue: deque[Entry] | None) -> tuple[LineTap, LineTap]:
    """The taps of the board's and of the simulator's line."""
    return (
        LineTap(clock, queue, BOARD_RECEIVED, BOARD_SENT),
        LineTap(clock, queue, SIMULATOR_RECEIVED, SIMULATOR_SENT),
    )
