"""Flown lines with as few of their points as say the same: an hour at 50 Hz is a file that nothing opens."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Final

import numpy as np

from epf_gcs.earth import M_PER_DEG
from epf_gcs.flights.export.flown import FlownLine
from epf_gcs.flights.export.spread import Rows

DEVIATION_M: Final = 1.0
"""No sample is farther from the place that the thinned line has at its time."""
_TOLERANCE_M: Final = DEVIATION_M / math.sqrt(3.0)

_Place = tuple[float, float, float, float]
"""Time (s), north, east and up (m)."""


def thinned_lines(lines: list[FlownLine], path: Path) -> list[FlownLine]:
    """The lines without what lies between two kept points anyway, written to `path`. Raises OSError."""
    found: list[FlownLine] = []
    count = 0
    with path.open("wb") as file:
        for line in lines:
            first = count
            for rows in _kept(line):
                file.write(np.ascontiguousarray(rows, dtype="<f8").tobytes())
                count += len(rows)
            found.append(FlownLine(path, first, count))
    return found


class _Door:
    """The straight ways from a kept point that pass every sample since it within the tolerance."""

    def __init__(self, pivot: _Place) -> None:
        self._pivot = pivot
        self._low = [-math.inf] * 3
        self._high = [math.inf] * 3

    def passes(self, place: _Place) -> bool:
        """Whether the way to `place` is one of them; if so, it is a sample from now on."""
        elapsed_s = place[0] - self._pivot[0]
        slopes = [(place[axis] - self._pivot[axis]) / elapsed_s for axis in (1, 2, 3)]
        if not all(low <= slope <= high for low, slope, high in zip(self._low, slopes, self._high, strict=True)):
            return False
        spread = _TOLERANCE_M / elapsed_s
        self._low = [max(low, slope - spread) for low, slope in zip(self._low, slopes, strict=True)]
        self._high = [min(high, slope + spread) for high, slope in zip(self._high, slopes, strict=True)]
        return True


def _kept(line: FlownLine) -> Iterator[Rows]:
    """In pieces: the first point, each after which no straight way passes all samples, and the last."""
    door: _Door | None = None
    last: tuple[Rows, _Place] | None = None
    for samples in line:
        rows = np.column_stack(samples)
        kept: list[Rows] = []
        for row, place in zip(rows, _places(rows), strict=True):
            if door is None or last is None:
                kept.append(row)
                door = _Door(place)
            elif not door.passes(place):
                kept.append(last[0])
                door = _Door(last[1])
                door.passes(place)
            last = row, place
        if kept:
            yield np.stack(kept)
    if last is not None:
        yield last[0][None]


def _places(rows: Rows) -> Iterator[_Place]:
    north_m = rows[:, 1] * M_PER_DEG
    east_m = rows[:, 2] * M_PER_DEG * np.cos(np.radians(rows[:, 1]))
    yield from zip(rows[:, 0].tolist(), north_m.tolist(), east_m.tolist(), rows[:, 3].tolist(), strict=True)
