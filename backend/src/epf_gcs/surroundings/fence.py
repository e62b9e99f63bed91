"""The fence: a polygon on the Earth, and how far places are from its border."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from epf_gcs.earth import M_PER_DEG
from epf_gcs.surroundings.motion import Vector


def inside_m(corners_deg: Sequence[tuple[float, float]], latitude_deg: Vector, longitude_deg: Vector) -> Vector:
    """Distance of each place from the border, positive inside. `corners_deg`: latitude and longitude, at least three.

    Counted in the plane at the first place; where the border crosses itself, what is enclosed twice is outside.
    """
    origin_deg = (float(latitude_deg[0]), float(longitude_deg[0]))
    corners = np.array(corners_deg, dtype=np.float64)
    border_x, border_y = _plane(origin_deg, corners[:, 0], corners[:, 1])
    x, y = _plane(origin_deg, latitude_deg, longitude_deg)
    next_x, next_y = np.roll(border_x, -1), np.roll(border_y, -1)
    along_x, along_y = next_x - border_x, next_y - border_y
    length2 = np.maximum(along_x**2 + along_y**2, 1e-9)
    from_x, from_y = x[:, None] - border_x, y[:, None] - border_y
    share = np.clip((from_x * along_x + from_y * along_y) / length2, 0.0, 1.0)
    distance = np.hypot(from_x - share * along_x, from_y - share * along_y).min(axis=1)
    # Borders that a line from the place to the east crosses.
    spans = (border_y > y[:, None]) != (next_y > y[:, None])
    safe_y = np.where(np.abs(along_y) < 1e-9, 1e-9, along_y)
    crossing_x = border_x + (y[:, None] - border_y) / safe_y * along_x
    is_inside: npt.NDArray[np.bool_] = (spans & (x[:, None] < crossing_x)).sum(axis=1) % 2 == 1
    found: Vector = np.where(is_inside, distance, -distance)
    return found


def _plane(origin_deg: tuple[float, float], latitude_deg: Vector, longitude_deg: Vector) -> tuple[Vector, Vector]:
    """East and north in metres from the origin."""
    across = max(0.01, math.cos(math.radians(origin_deg[0])))
    east_deg = (longitude_deg - origin_deg[1] + 180.0) % 360.0 - 180.0
    return east_deg * M_PER_DEG * across, (latitude_deg - origin_deg[0]) * M_PER_DEG
