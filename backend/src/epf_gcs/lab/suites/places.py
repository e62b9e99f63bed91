"""Where the suites fly: waypoints seen from the start in the air, over the runway and along it."""

from __future__ import annotations

import math
from typing import Final

from epf_gcs.codec.tables import Waypoint
from epf_gcs.earth import M_PER_DEG
from epf_gcs.simulator.situation import AIRPORT_LATITUDE_DEG, AIRPORT_LONGITUDE_DEG, RUNWAY_HEADING_DEG

CRUISE_FT: Final = 1000.0
CRUISE_KT: Final = 55.0


def waypoint(course_deg: float, way_m: float, altitude_ft: float = CRUISE_FT, speed_kt: float = CRUISE_KT) -> Waypoint:
    """So far from the airport, on a course from the runway's, + to the right."""
    course = math.radians(RUNWAY_HEADING_DEG + course_deg)
    shrink = math.cos(math.radians(AIRPORT_LATITUDE_DEG))
    return Waypoint(
        AIRPORT_LATITUDE_DEG + way_m * math.cos(course) / M_PER_DEG,
        AIRPORT_LONGITUDE_DEG + way_m * math.sin(course) / (M_PER_DEG * shrink),
        altitude_ft,
        speed_kt,
    )


SHORT: Final = (waypoint(0.0, 1400.0), waypoint(45.0, 2000.0, 1080.0), waypoint(90.0, 1600.0, 1080.0, 58.0))
"""Two turns to the right, a climb and a little more speed, in less than two minutes."""
