"""Bytes a second over the last second or so, from counters that only grow."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable
from typing import Final

_WINDOW_S: Final = 1.0


class ByteRate:
    """The growth rate of a counter over the last second, from its values passed to `note` now and then."""

    def __init__(self) -> None:
        self._points: deque[tuple[float, int]] = deque()

    def note(self, now_s: float, total: int) -> None:
        """The counter stands at `total`."""
        self._points.append((now_s, total))
        while len(self._points) > 2 and self._points[1][0] <= now_s - _WINDOW_S:
            self._points.popleft()

    def per_s(self) -> float:
        """Growth a second between the ends of the window."""
        if len(self._points) < 2:
            return 0.0
        (first_s, first), (last_s, last) = self._points[0], self._points[-1]
        return (last - first) / (last_s - first_s) if last_s > first_s else 0.0

    def kept(self) -> list[tuple[float, int]]:
        """The points, for `restore`."""
        return list(self._points)

    def restore(self, kept: Iterable[tuple[float, int]]) -> None:
        """Go on from points that `kept` gave."""
        self._points = deque((now_s, total) for now_s, total in kept)
