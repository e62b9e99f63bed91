"""The flight's clock, which ticks about once a microsecond. While the bytes of a read are decoded it stands at the time
that the recording has for them.

So a replay of the recording, told the record's time, gives each sample and event the very time that it had live.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Final, TypeVar

from epf_gcs.clock import Clock
from epf_gcs.recordings.topics import STREAMS

# Reads of a byte stream that begin within this time of the first share its time, and so a record.
_TOGETHER_NS: Final = 1_000_000
# This clock ticks every 1024 ns: no read can be timed better, and noise in the last bits of a time does not pack.
_TICK: Final = ~0x3FF

R = TypeVar("R")


class LineClock(Clock):
    """Belongs to the event loop; other threads may use only `unix_ns` and `offset_ns`."""

    def __init__(self) -> None:
        super().__init__()
        self._topic = 0
        self._stamp_ns = 0
        self._received_ns = 0
        self._held_ns: int | None = None

    def now_ns(self) -> int:
        """Unix nanoseconds; of the read whose bytes are being decoded, if any."""
        return super().now_ns() & _TICK if self._held_ns is None else self._held_ns

    def now_s(self) -> float:
        """Unix seconds; of the read whose bytes are being decoded, if any."""
        held_ns = self._held_ns
        return (self.now_ns() if held_ns is None else held_ns) * 1e-9

    def sent(self, topic: int, ago_s: float = 0.0) -> int:
        """Unix nanoseconds for bytes of this topic that are sent now; never less than an earlier stamp. `ago_s`: where
        they were read so long after they came.

        A topic's bytes share the time of the first if nothing of another topic came in between, so that what is
        recorded in the order of the stamps keeps cause before effect.
        """
        now_ns = (self._offset_ns + time.monotonic_ns()) & _TICK
        if ago_s:
            now_ns = max(self._stamp_ns, (now_ns - int(ago_s * 1e9)) & _TICK)
        if topic == self._topic and topic in STREAMS and now_ns - self._stamp_ns < _TOGETHER_NS:
            return self._stamp_ns
        self._topic, self._stamp_ns = topic, now_ns
        return now_ns

    def received(self, topic: int, ago_s: float = 0.0) -> int:
        """The same for bytes that were read now, and the time at which what is `decoding` them stands."""
        self._received_ns = self.sent(topic, ago_s)
        return self._received_ns

    def decoding(self, take: Callable[[bytes], R]) -> Callable[[bytes], R]:
        """`take`, with the clock standing at the newest `received` while it runs."""

        def decode(data: bytes) -> R:
            self._held_ns = self._received_ns
            try:
                return take(data)
            finally:
                self._held_ns = None

        return decode
