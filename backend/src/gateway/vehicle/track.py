"""Where an aircraft has been: every new position, in bounded memory, for as long as it flies."""

from __future__ import annotations

import math
from array import array
from collections.abc import Iterator
from itertools import pairwise
from typing import Final

MAX_POINTS: Final = 200_000
"""An hour of a simulator's 50 Hz. Beyond it the older half keeps every second point, again and again."""

Position = tuple[float, float, float]
"""Latitude and longitude in degrees, altitude in metres above mean sea level."""

# Further apart than this and nobody knows what was between: another route was loaded, or the receiver was lost.
_LONGEST_GAP_S: Final = 10.0
_FASTEST_M_S: Final = 350.0
_LEAST_JUMP_M: Final = 100.0
_M_PER_DEG: Final = 111_195.0


class Track:
    """Positions in the order of time, in pieces where it was interrupted."""

    def __init__(self, max_points: int = MAX_POINTS) -> None:
        self._max_points = max_points
        self._t_s = array("d")
        self._latitude_deg = array("d")
        self._longitude_deg = array("d")
        self._altitude_m = array("d")
        # Index of the first point of each piece.
        self._starts: list[int] = []

    def __len__(self) -> int:
        return len(self._t_s)

    def add(self, t_s: float, position: Position) -> None:
        """The aircraft was here at this time; the same place again is no new point."""
        last = len(self) - 1
        if last >= 0 and position == self.at(last):
            return
        if last < 0 or self._is_interrupted(last, t_s, position):
            self._starts.append(last + 1)
        self._t_s.append(t_s)
        self._latitude_deg.append(position[0])
        self._longitude_deg.append(position[1])
        self._altitude_m.append(position[2])
        if len(self) > self._max_points:
            self._thin()

    def at(self, index: int) -> Position:
        """A position by its index."""
        return self._latitude_deg[index], self._longitude_deg[index], self._altitude_m[index]

    def append(self, later: Track) -> None:
        """What was flown after all of this, as a piece of its own."""
        before = len(self)
        self._t_s += later._t_s
        self._latitude_deg += later._latitude_deg
        self._longitude_deg += later._longitude_deg
        self._altitude_m += later._altitude_m
        self._starts += [before + start for start in later._starts]
        while len(self) > self._max_points:
            self._thin()

    def pieces(self, most_points: int | None = None, since_s: float = -math.inf) -> list[range]:
        """Indices of the points of each piece that is a line, from `since_s` on.

        With `most_points` some are left out evenly, never the newest of a piece.
        """
        first = self._first_since(since_s)
        spans = [(max(start, first), end) for start, end in pairwise((*self._starts, len(self)))]
        lines = [(start, end) for start, end in spans if end - start > 1]
        total = sum(end - start for start, end in lines)
        step = 1 if most_points is None else max(1, math.ceil(total / max(1, most_points)))
        return [_spread(start, end, step) for start, end in lines]

    def points(self, piece: range) -> Iterator[Position]:
        """The positions of a piece as they are now, whatever becomes of the track while they are read."""
        chosen = slice(piece.start, piece.stop, piece.step)
        return zip(self._latitude_deg[chosen], self._longitude_deg[chosen], self._altitude_m[chosen], strict=True)

    def _first_since(self, since_s: float) -> int:
        low, high = 0, len(self)
        while low < high:
            middle = (low + high) // 2
            if self._t_s[middle] < since_s:
                low = middle + 1
            else:
                high = middle
        return low

    def _is_interrupted(self, last: int, t_s: float, position: Position) -> bool:
        elapsed_s = t_s - self._t_s[last]
        latitude_deg, longitude_deg, _ = self.at(last)
        north_m = (position[0] - latitude_deg) * _M_PER_DEG
        # The short way round where the date changes.
        east_deg = (position[1] - longitude_deg + 180.0) % 360.0 - 180.0
        east_m = east_deg * _M_PER_DEG * math.cos(math.radians(latitude_deg))
        moved_m = math.hypot(north_m, east_m)
        return elapsed_s > _LONGEST_GAP_S or moved_m > max(_LEAST_JUMP_M, _FASTEST_M_S * elapsed_s)

    def _thin(self) -> None:
        """Every second point of the older half goes; slices, for this happens between two control frames."""
        half = len(self) // 2
        for values in (self._t_s, self._latitude_deg, self._longitude_deg, self._altitude_m):
            values[:half] = values[:half:2]
        gone = half // 2
        moved = [(start + 1) // 2 if start < half else start - gone for start in self._starts]
        self._starts = [start for index, start in enumerate(moved) if moved[index + 1 : index + 2] != [start]]


def _spread(start: int, end: int, step: int) -> range:
    """Counted back from the newest point, which is the one that is looked at; a line has two at the least."""
    newest_first = range(end - 1, start - 1, -step)
    return newest_first[::-1] if len(newest_first) > 1 else range(start, end, end - 1 - start)
