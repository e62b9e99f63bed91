"""The figure of the earth: a sphere, which is enough for every distance that is told or judged here."""

from __future__ import annotations

import math
from typing import Final

RADIUS_M: Final = 6_371_008.8
"""Mean radius, of WGS 84."""
M_PER_DEG: Final = 111_195.0
"""Metres of a degree of latitude; within 0.6 % anywhere."""
GRAVITY_M_S2: Final = 9.80665
"""Standard gravity; exact."""


def distance_m(latitude_deg: float, longitude_deg: float, to_latitude_deg: float, to_longitude_deg: float) -> float:
    """By the great circle, in metres; also over the date line."""
    phi, to_phi = math.radians(latitude_deg), math.radians(to_latitude_deg)
    half_turn = math.radians(to_longitude_deg - longitude_deg) / 2.0
    haversine = math.sin((to_phi - phi) / 2.0) ** 2 + math.cos(phi) * math.cos(to_phi) * math.sin(half_turn) ** 2
    return 2.0 * RADIUS_M * math.asin(math.sqrt(min(1.0, haversine)))
