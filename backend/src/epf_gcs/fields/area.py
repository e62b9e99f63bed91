"""The surroundings of a place or of a plan, and the tiles that touch them."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from typing import Final

import numpy as np
import numpy.typing as npt

from epf_gcs.earth import M_PER_DEG
from epf_gcs.errors import InvalidInputError
from epf_gcs.maps.layer import Bounds

MOST_TILES: Final = 200_000
"""Of one level; more are no field any more."""

# Web Mercator ends here.
_HIGHEST_LATITUDE_DEG: Final = 85.0511
# Distances are those of a plane at each tile: a little more is taken, never less.
_MARGIN: Final = 1.01

Places = npt.NDArray[np.int64]


@dataclass(frozen=True, slots=True)
class Area:
    """All within `radius_m` of the line through these points (latitude, longitude, in degrees); one point: a circle."""

    points: tuple[tuple[float, float], ...]
    radius_m: float

    @property
    def bounds(self) -> Bounds:
        """The rectangle around it; all longitudes if it crosses the date line."""
        line = _unwrapped(self.points)
        corners = [_around(a, b, self.radius_m) for a, b in _segments(line)]
        south_deg, north_deg = min(one[0] for one in corners), max(one[1] for one in corners)
        west_deg, east_deg = min(one[2] for one in corners), max(one[3] for one in corners)
        if west_deg < -180.0 or east_deg > 180.0:
            west_deg, east_deg = -180.0, 180.0
        return Bounds(west_deg, south_deg, east_deg, north_deg)

    def tiles(self, zoom: int) -> Places:
        """Columns and rows (from the north) of the tiles that touch it, one pair in each line, sorted.

        Raises InvalidInputError if they are too many.
        """
        found = [self._of_segment(a, b, zoom) for a, b in _segments(_unwrapped(self.points))]
        places: Places = np.unique(np.concatenate(found), axis=0)
        if len(places) > MOST_TILES:
            raise too_large()
        return places

    def degrees(self) -> Places:
        """Squares of one degree that touch it: longitude and latitude of the south-western corner, sorted."""
        found: set[tuple[int, int]] = set()
        for a, b in _segments(_unwrapped(self.points)):
            south_deg, north_deg, west_deg, east_deg = _around(a, b, self.radius_m)
            columns = range(math.floor(west_deg), math.ceil(east_deg))
            rows = range(max(-90, math.floor(south_deg)), min(90, math.ceil(north_deg)))
            if len(columns) * len(rows) > MOST_TILES:
                raise too_large()
            found |= {((column + 180) % 360 - 180, row) for column in columns for row in rows}
        return np.array(sorted(found), dtype=np.int64).reshape(-1, 2)

    def _of_segment(self, a: tuple[float, float], b: tuple[float, float], zoom: int) -> Places:
        south_deg, north_deg, west_deg, east_deg = _around(a, b, self.radius_m)
        count = 1 << zoom
        columns = np.arange(math.floor((west_deg + 180) / 360 * count), math.floor((east_deg + 180) / 360 * count) + 1)
        rows = np.arange(_row(north_deg, count), _row(south_deg, count) + 1)
        if len(columns) * len(rows) > 8 * MOST_TILES:
            raise too_large()
        column, row = (grid.ravel() for grid in np.meshgrid(columns, rows))
        longitude_deg = (column + 0.5) / count * 360 - 180
        latitude_deg, upper_deg = _latitude_deg((row + 0.5) / count), _latitude_deg(row / count)
        # In metres from the tile's centre.
        wide = M_PER_DEG * np.cos(np.radians(latitude_deg))
        ax, ay = (a[1] - longitude_deg) * wide, (a[0] - latitude_deg) * M_PER_DEG
        bx, by = (b[1] - longitude_deg) * wide, (b[0] - latitude_deg) * M_PER_DEG
        dx, dy = bx - ax, by - ay
        along = np.clip(-(ax * dx + ay * dy) / np.maximum(dx * dx + dy * dy, 1e-9), 0.0, 1.0)
        distance_m = np.hypot(ax + along * dx, ay + along * dy)
        half_m = np.hypot(wide * 180.0 / count, (upper_deg - latitude_deg) * M_PER_DEG)
        touched = distance_m <= (self.radius_m + half_m) * _MARGIN
        places: Places = np.unique(np.stack([column[touched] % count, row[touched]], axis=1), axis=0).astype(np.int64)
        return places


def too_large() -> InvalidInputError:
    """The error for an area that is more than a field."""
    return InvalidInputError(
        "field_too_large",
        f"This takes more than {MOST_TILES} tiles: choose a smaller area or a coarser level.",
        limit=MOST_TILES,
    )


def _segments(line: list[tuple[float, float]]) -> list[tuple[tuple[float, float], tuple[float, float]]]:
    return [(line[0], line[0])] if len(line) == 1 else list(itertools.pairwise(line))


def _unwrapped(points: tuple[tuple[float, float], ...]) -> list[tuple[float, float]]:
    """Longitudes that go on beyond 180, so that each leg takes the short way."""
    line = [points[0]]
    for latitude_deg, longitude_deg in points[1:]:
        step_deg = (longitude_deg - line[-1][1] + 180.0) % 360.0 - 180.0
        line.append((latitude_deg, line[-1][1] + step_deg))
    return line


def _around(a: tuple[float, float], b: tuple[float, float], radius_m: float) -> tuple[float, float, float, float]:
    """South, north, west, east of the rectangle around a leg and its surroundings."""
    up_deg = radius_m * _MARGIN / M_PER_DEG
    limit = _HIGHEST_LATITUDE_DEG
    south_deg, north_deg = max(-limit, min(a[0], b[0]) - up_deg), min(limit, max(a[0], b[0]) + up_deg)
    aside_deg = min(180.0, up_deg / math.cos(math.radians(max(abs(south_deg), abs(north_deg)))))
    return south_deg, north_deg, min(a[1], b[1]) - aside_deg, max(a[1], b[1]) + aside_deg


def _row(latitude_deg: float, count: int) -> int:
    mercator = math.asinh(math.tan(math.radians(latitude_deg)))
    return min(count - 1, max(0, math.floor((1.0 - mercator / math.pi) / 2.0 * count)))


def _latitude_deg(from_north: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Latitude of places on the Mercator map, 0 at its northern edge and 1 at its southern."""
    return np.degrees(np.arctan(np.sinh(np.pi * (1.0 - 2.0 * from_north))))
