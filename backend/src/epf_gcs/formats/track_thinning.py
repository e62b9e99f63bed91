"""A flown track as the few waypoints from which it differs least, by Douglas and Peucker's way of splitting."""

from __future__ import annotations

import heapq
import math
from collections.abc import Sequence
from typing import Final

import numpy as np
import numpy.typing as npt

from epf_gcs.earth import RADIUS_M
from epf_gcs.formats.mission_file import Point
from epf_gcs.units import m_from_ft

# Nearer than this nobody needs another waypoint: it is what a GPS scatters.
_NEAR_ENOUGH_M: Final = 5.0

Numbers = npt.NDArray[np.float64]


def thinned(points: Sequence[Point], most: int) -> tuple[list[Point], float]:
    """At most `most` (2 or more) of the points, first and last among them, and the largest distance in metres, in all
    three directions, of a point that was left out from the line between those beside it.
    """
    kept, deviation_m = thinned_places(
        np.array([point.latitude_deg for point in points]),
        np.array([point.longitude_deg for point in points]),
        np.array([m_from_ft(point.altitude_ft or 0.0) for point in points]),
        most,
    )
    return [points[index] for index in kept], deviation_m


def thinned_places(
    latitude_deg: Numbers, longitude_deg: Numbers, altitude_m: Numbers, most: int
) -> tuple[list[int], float]:
    """The same of arrays of n numbers: the indexes of the points that are kept, in order, and the largest distance.

    The line is split where a point is farthest from it, until all are near or there are `most`.
    """
    count = len(latitude_deg)
    if count < 3:
        return list(range(count)), 0.0
    places = _flat(latitude_deg, longitude_deg, altitude_m)
    kept = {0, count - 1}
    # Largest deviation first.
    open_stretches = [_stretch(places, 0, count - 1)]
    while open_stretches and -open_stretches[0][0] > _NEAR_ENOUGH_M and len(kept) < most:
        _, start, end, at = heapq.heappop(open_stretches)
        kept.add(at)
        for first, last in ((start, at), (at, end)):
            if last - first > 1:
                heapq.heappush(open_stretches, _stretch(places, first, last))
    deviation_m = -open_stretches[0][0] if open_stretches else 0.0
    return sorted(kept), deviation_m


def _flat(latitude_deg: Numbers, longitude_deg: Numbers, altitude_m: Numbers) -> Numbers:
    """Metres east, north and up from the first point, shape (n, 3)."""
    per_deg = math.radians(1.0) * RADIUS_M
    shrink = math.cos(math.radians(float(latitude_deg[0])))
    east_deg = (longitude_deg - longitude_deg[0] + 180.0) % 360.0 - 180.0
    return np.column_stack((east_deg * per_deg * shrink, (latitude_deg - latitude_deg[0]) * per_deg, altitude_m))


def _stretch(places: Numbers, start: int, end: int) -> tuple[float, int, int, int]:
    """Minus the largest deviation between two kept points, those points, and where it is."""
    if end - start < 2:
        return 0.0, start, end, start
    along = places[end] - places[start]
    off = places[start + 1 : end] - places[start]
    length_m2 = float(along @ along)
    shares = np.clip(off @ along / length_m2, 0.0, 1.0) if length_m2 > 0 else np.zeros(len(off))
    distances_m = np.linalg.norm(off - shares[:, np.newaxis] * along, axis=1)
    at = int(distances_m.argmax())
    return -float(distances_m[at]), start, end, start + 1 + at
