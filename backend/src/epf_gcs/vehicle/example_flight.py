"""A computed example flight for the emulation without a board: a gentle circuit off Gran Canaria's airport.

Everything follows from one steady turn, so that no instrument contradicts another: the bank gives the radius, the
radius the turn rate, the height the pressure. Time is the caller's, in seconds from the start of the flight.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

from epf_gcs import earth
from epf_gcs.earth import GRAVITY_M_S2
from epf_gcs.units import M_PER_FT, MPS_PER_KT

# Over the sea, 2 km east of the runway of GCLP.
CENTRE_LATITUDE_DEG: Final = 27.9319
CENTRE_LONGITUDE_DEG: Final = -15.3660
SPEED_KT: Final = 60.0
BANK_DEG: Final = 10.0
ALPHA_DEG: Final = 3.0
MEAN_ALTITUDE_FT: Final = 1000.0
TEMPERATURE_DEGC: Final = 19.0
WAYPOINTS: Final = 4

_SWELL_FT: Final = 80.0
_SWELL_PERIOD_S: Final = 50.0
# The earth's field there: the needle points 38 degrees down.
_DIP: Final = math.radians(38.0)

_SPEED_M_S: Final = SPEED_KT * MPS_PER_KT
RADIUS_M: Final = _SPEED_M_S**2 / (GRAVITY_M_S2 * math.tan(math.radians(BANK_DEG)))
TURN_RATE_RAD_S: Final = _SPEED_M_S / RADIUS_M


@dataclass(frozen=True, slots=True)
class ExampleMoment:
    """The aircraft at one time. Right turn: heading grows, roll is positive."""

    t_s: float
    latitude_deg: float
    longitude_deg: float
    altitude_ft: float
    vvi_ft_min: float
    heading_deg: float
    pitch_deg: float
    roll_deg: float

    @property
    def altitude_m(self) -> float:
        """Above mean sea level."""
        return self.altitude_ft * M_PER_FT

    @property
    def rates_rad_s(self) -> tuple[float, float, float]:
        """P, Q, R of a steady turn."""
        pitch, roll = math.radians(self.pitch_deg), math.radians(self.roll_deg)
        return (
            -TURN_RATE_RAD_S * math.sin(pitch),
            TURN_RATE_RAD_S * math.sin(roll) * math.cos(pitch),
            TURN_RATE_RAD_S * math.cos(roll) * math.cos(pitch),
        )

    @property
    def forces_m_s2(self) -> tuple[float, float, float]:
        """Specific force in body axes; the side component is 0 in a coordinated turn."""
        load = 1.0 / math.cos(math.radians(self.roll_deg))
        return GRAVITY_M_S2 * math.sin(math.radians(self.pitch_deg)), 0.0, -GRAVITY_M_S2 * load

    @property
    def field(self) -> tuple[float, float, float]:
        """The earth's magnetic field in body axes, of length 1."""
        yaw, pitch, roll = (math.radians(angle) for angle in (self.heading_deg, self.pitch_deg, self.roll_deg))
        north, down = math.cos(_DIP), math.sin(_DIP)
        ahead, right = north * math.cos(yaw), -north * math.sin(yaw)
        forward = ahead * math.cos(pitch) - down * math.sin(pitch)
        level_down = ahead * math.sin(pitch) + down * math.cos(pitch)
        return (
            forward,
            right * math.cos(roll) + level_down * math.sin(roll),
            level_down * math.cos(roll) - right * math.sin(roll),
        )

    @property
    def pressure_hpa(self) -> float:
        """Static pressure of the standard atmosphere."""
        return float(1013.25 * (1.0 - 2.25577e-5 * self.altitude_m) ** 5.25588)

    @property
    def pitot_pa(self) -> float:
        """Differential pressure at this calibrated airspeed."""
        return 0.5 * 1.225 * _SPEED_M_S**2

    def to_waypoint(self, ahead: int = 0) -> tuple[float, float, int]:
        """Bearing in degrees, distance in metres and index of the next waypoint, or of one further on.

        The waypoints are the north, east, south and west of the circuit.
        """
        # Heading 90 is in the north of a right turn, 180 in the east.
        flown = (self.heading_deg - 90.0) % 360.0
        step = 360.0 / WAYPOINTS
        index = (int(flown // step) + 1 + ahead) % WAYPOINTS
        here, there = math.radians(flown), math.radians(index * step)
        north = RADIUS_M * (math.cos(there) - math.cos(here))
        east = RADIUS_M * (math.sin(there) - math.sin(here))
        return math.degrees(math.atan2(east, north)) % 360.0, math.hypot(north, east), index


def moment(t_s: float) -> ExampleMoment:
    """Where the aircraft is `t_s` seconds after its start in the north of the circuit."""
    heading = math.radians(90.0) + TURN_RATE_RAD_S * t_s
    north, east = RADIUS_M * math.sin(heading), -RADIUS_M * math.cos(heading)
    swell = 2.0 * math.pi / _SWELL_PERIOD_S
    climb_ft_s = _SWELL_FT * swell * math.cos(swell * t_s)
    climb_angle_deg = math.degrees(math.asin(climb_ft_s * M_PER_FT / _SPEED_M_S))
    latitude_deg = CENTRE_LATITUDE_DEG + math.degrees(north / earth.RADIUS_M)
    return ExampleMoment(
        t_s=t_s,
        latitude_deg=latitude_deg,
        longitude_deg=CENTRE_LONGITUDE_DEG
        + math.degrees(east / (earth.RADIUS_M * math.cos(math.radians(CENTRE_LATITUDE_DEG)))),
        altitude_ft=MEAN_ALTITUDE_FT + _SWELL_FT * math.sin(swell * t_s),
        vvi_ft_min=60.0 * climb_ft_s,
        heading_deg=math.degrees(heading) % 360.0,
        pitch_deg=climb_angle_deg + ALPHA_DEG,
        roll_deg=BANK_DEG,
    )
