"""The reference figures, measured once with these laws and gains on the rc aircraft at 55 kt and 50 Hz.

A step response has to come within a fifth of its figure; the limits of a route are wider than its figures.
"""

from dataclasses import dataclass
from typing import Final

WITHIN: Final = 1.2

# +300 ft: overshoot, and time until the altitude stays within 30 ft.
CLIMB_OVERSHOOT_FT: Final = 12.0
CLIMB_SETTLING_S: Final = 33.0
SETTLED_FT: Final = 30.0

# +90 degrees: no overshoot, time until the track stays within 3 degrees.
TURN_SETTLING_S: Final = 17.0
SETTLED_DEG: Final = 3.0

# Airspeed +15 %: time until it stays within 1 kt.
FASTER_SETTLING_S: Final = 18.0
SETTLED_KT: Final = 1.0

# Every route flown in calm air keeps its altitude so well.
ALTITUDE_LIMIT_FT: Final = 20.0
# The circuit, whose legs are short, keeps to its lines so well.
CROSS_TRACK_LIMIT_M: Final = 60.0


@dataclass(frozen=True, slots=True)
class RouteReference:
    """A route in calm air with default gains."""

    waypoints: int
    time_s: float
    altitude_rms_ft: float | None = None
    cross_track_rms_m: float | None = None


ROUTE_REFERENCES: Final = {
    "gando": RouteReference(8, 575.0, altitude_rms_ft=14.0, cross_track_rms_m=45.0),
    "vuelo": RouteReference(10, 27.0 * 60.0),
    "alternativa": RouteReference(11, 45.0 * 60.0),
    "ruta_isla": RouteReference(20, 92.0 * 60.0),
}
