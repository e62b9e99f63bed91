"""Bytes that were read late, and when each of them came.

A serial line carries a byte in ten bits' time and no faster. Where as many bytes came as a line without a gap brings in
the time since the last read, each came when its turn was.
"""

from __future__ import annotations

from typing import Final

_BITS_OF_A_BYTE: Final = 10.0
# A line that was silent for longer than this in the time between two reads has a gap, at an unknown place. Bytes are
# placed in the middle of what is possible, so that none is more than half of this away from its true time.
_GAP_S: Final = 0.002


class ByteTimes:
    """Judges one line by its baud rate."""

    def __init__(self, baud: int) -> None:
        self.byte_s: Final = _BITS_OF_A_BYTE / baud

    def holds(self, count: int, lasted_s: float) -> bool:
        """Whether so many bytes in this time are a line without a gap. More than it can carry are no such line."""
        return abs(lasted_s - count * self.byte_s) <= _GAP_S

    def ago_s(self, later: int, count: int, lasted_s: float) -> float:
        """How long before the read a byte came that `later` others followed, of `count` that came in `lasted_s`."""
        gap_s = max(0.0, lasted_s - count * self.byte_s)
        if gap_s > _GAP_S:
            # It fell silent: the bytes came right after those of the read before.
            return lasted_s - (count - later) * self.byte_s
        return later * self.byte_s + 0.5 * gap_s
