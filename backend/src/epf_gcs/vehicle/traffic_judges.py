"""What comes in on the lines that should not: more than a board sends, and datagrams of others."""

from __future__ import annotations

from collections import deque
from typing import Final

from epf_gcs.vehicle.judges import HICCUP_S, Finding

_STRANGERS_WINDOW_S: Final = 10.0
# One a second over the whole window: more than a program sends that was started by mistake and ended again.
_STRANGERS_LEAST: Final = 10


class FloodJudge:
    """Whether the board's line sends more than is read from it."""

    def __init__(self) -> None:
        self._count = 0
        self._until_s: float | None = None

    def look(self, now_s: float, held_back: int, most_bytes_per_s: float) -> Finding | None:
        """`held_back` counts the pauses of reading; another link begins at 0 again."""
        if held_back > self._count:
            self._until_s = now_s + HICCUP_S
        self._count = held_back
        if self._until_s is None or now_s > self._until_s:
            return None
        kb_per_s = round(most_bytes_per_s / 1000.0)
        text = (
            f"The board's line sends more than any board's line carries: {kb_per_s} kB/s are read, the rest waits "
            "at the other end, so what is shown is late. Look at what is connected there."
        )
        return Finding("line_floods", "warning", text, {"kb_per_s": kb_per_s})


class StrangersJudge:
    """The datagrams that other programs than the simulator sent to our receive port in the last ten seconds."""

    def __init__(self, now_s: float) -> None:
        self._counts = deque([(now_s, 0)])

    def look(self, now_s: float, dropped: int, sender: str | None) -> Finding | None:
        """`dropped` is a counter that only grows; `sender` is the address that sent the newest of them."""
        self._counts.append((now_s, dropped))
        while self._counts[0][0] < now_s - _STRANGERS_WINDOW_S:
            self._counts.popleft()
        count = dropped - self._counts[0][1]
        if count < _STRANGERS_LEAST:
            return None
        per_s = round(count / _STRANGERS_WINDOW_S)
        text = (
            f"Others than the simulator send to its port, {per_s} datagrams a second, the last from {sender}: they are "
            "dropped. End what sends them, or correct the simulator's address if it moved."
        )
        return Finding("foreign_datagrams", "warning", text, {"per_s": per_s, "host": sender})
