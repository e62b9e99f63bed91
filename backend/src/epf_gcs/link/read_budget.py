"""How fast a line is read: no faster than any board's line carries, whatever the other end sends."""

from __future__ import annotations

from typing import Final

MOST_BYTES_PER_S: Final = 320_000.0
"""The fastest serial lines carry 300,000 (3 Mbaud). Decoding and recording this takes a third of a core."""
AT_ONCE_BYTES: Final = 131_072.0
"""What may come at once after a while of silence: more than a second of a line of 921,600 baud."""
# Shorter pauses would cost more than the reads between them.
_SHORTEST_PAUSE_S: Final = 0.02


class ReadBudget:
    """Bytes that may be read; they come back with time. Times are a steady clock's."""

    def __init__(self, now_s: float) -> None:
        self._left = AT_ONCE_BYTES
        self._at_s = now_s

    def take(self, count: int, now_s: float) -> float:
        """So many bytes were read; returns for how many seconds nothing more may be read, mostly 0."""
        self._left = min(AT_ONCE_BYTES, self._left + (now_s - self._at_s) * MOST_BYTES_PER_S) - count
        self._at_s = now_s
        return 0.0 if self._left >= 0.0 else max(_SHORTEST_PAUSE_S, -self._left / MOST_BYTES_PER_S)
