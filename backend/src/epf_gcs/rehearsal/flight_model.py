"""An aircraft under the board's laws as a point with mass: fast enough to fly hours in a second.

The laws are those of `firmware/src/control/autopilot.c` with default gains: bank for the course, climb for the
altitude, throttle for the speed, each with its limits. Roll and climb follow them with a lag, and speed follows from
the power that is left. The figures are those of the simulator's `rc` aircraft (12 kg, electric), measured in the closed
loop with the board's own code; `board_tests/closed_loop/test_rehearsal.py` compares both on whole routes. It knows no
take-off, no ground and no turbulence.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

from epf_gcs.earth import GRAVITY_M_S2, M_PER_DEG
from epf_gcs.units import ft_from_m, mps_from_kt

STEP_S: Final = 0.1

# Of the laws, with default gains.
_ROLL_PER_COURSE: Final = 0.8
_STEEPEST_ROLL_DEG: Final = 30.0
_CLIMB_DEG_PER_FT: Final = 0.06
_LEAD_FT_PER_FT_MIN: Final = 0.1
_LOWEST_PITCH_DEG, _HIGHEST_PITCH_DEG = -20.0, 15.0
_KT_S_PER_THROTTLE: Final = 700.0
# Of the aircraft. It reaches this share of the bank that is asked for, and turns with this share of the rate of a
# coordinated turn.
_ROLL_SHARE: Final = 0.92
_TURN_SHARE: Final = 0.945
_ROLL_LAG_S: Final = 0.75
_CLIMB_LAG_S: Final = 1.2
_SLOWEST_KT: Final = 30.0
# True airspeed grows over the indicated one by this share a foot.
_THINNER_PER_FT: Final = 1.47e-5


@dataclass(frozen=True, slots=True)
class Start:
    """Where a flight begins: degrees, feet above the sea, true track, indicated knots."""

    latitude_deg: float
    longitude_deg: float
    altitude_ft: float
    track_deg: float
    speed_kt: float


@dataclass(frozen=True, slots=True)
class SteadyWind:
    """True direction that it blows from, and speed."""

    from_deg: float = 0.0
    speed_kt: float = 0.0


class FlightModel:
    """One aircraft. Angles in degrees: `roll_deg` + right wing down, `climb_deg` through the air, + up."""

    def __init__(self, start: Start, wind: SteadyWind) -> None:
        self.time_s = 0.0
        self.latitude_deg, self.longitude_deg = start.latitude_deg, start.longitude_deg
        self.altitude_ft = start.altitude_ft
        # A take-off run is not modelled: an aircraft that stands begins at its slowest.
        self.speed_kt = max(_SLOWEST_KT, start.speed_kt)
        self.throttle = _level_throttle(self.speed_kt)
        self.roll_deg = self.climb_deg = 0.0
        towards, wind_mps = math.radians(wind.from_deg + 180.0), mps_from_kt(wind.speed_kt)
        self._wind_north_mps, self._wind_east_mps = wind_mps * math.cos(towards), wind_mps * math.sin(towards)
        self.track_deg = start.track_deg
        self._heading = math.radians(start.track_deg)

    def step(self, course_deg: float, altitude_ft: float, speed_kt: float) -> None:
        """Fly on for STEP_S towards this ground track, altitude above the sea and indicated airspeed."""
        air_mps = mps_from_kt(self.speed_kt * (1.0 + _THINNER_PER_FT * max(0.0, self.altitude_ft)))
        climb_mps = self._climb(altitude_ft, air_mps)
        self._turn(course_deg, air_mps)
        self._speed(speed_kt, climb_mps, air_mps)
        level_mps = math.sqrt(max(0.0, air_mps * air_mps - climb_mps * climb_mps))
        north_mps = level_mps * math.cos(self._heading) + self._wind_north_mps
        east_mps = level_mps * math.sin(self._heading) + self._wind_east_mps
        self.track_deg = math.degrees(math.atan2(east_mps, north_mps))
        across = max(0.01, math.cos(math.radians(self.latitude_deg)))
        self.latitude_deg = min(90.0, max(-90.0, self.latitude_deg + north_mps * STEP_S / M_PER_DEG))
        longitude_deg = self.longitude_deg + east_mps * STEP_S / M_PER_DEG / across
        self.longitude_deg = (longitude_deg + 180.0) % 360.0 - 180.0
        self.altitude_ft += ft_from_m(climb_mps * STEP_S)
        self.time_s += STEP_S

    def _climb(self, altitude_ft: float, air_mps: float) -> float:
        climb_mps = air_mps * math.sin(math.radians(self.climb_deg))
        error_ft = altitude_ft - (self.altitude_ft + _LEAD_FT_PER_FT_MIN * ft_from_m(climb_mps) * 60.0)
        # The slower it flies, the more of its pitch is angle of attack.
        attack_deg = 2.92 * ((55.0 / self.speed_kt) ** 2 - 1.0)
        wanted_deg = _limited(_CLIMB_DEG_PER_FT * error_ft, _LOWEST_PITCH_DEG, _HIGHEST_PITCH_DEG - attack_deg)
        self.climb_deg += (wanted_deg - self.climb_deg) * STEP_S / _CLIMB_LAG_S
        return climb_mps

    def _turn(self, course_deg: float, air_mps: float) -> None:
        error_deg = wrap_180(course_deg - self.track_deg)
        wanted_deg = _limited(_ROLL_PER_COURSE * error_deg, -_STEEPEST_ROLL_DEG, _STEEPEST_ROLL_DEG)
        self.roll_deg += (_ROLL_SHARE * wanted_deg - self.roll_deg) * STEP_S / _ROLL_LAG_S
        self._heading += _TURN_SHARE * GRAVITY_M_S2 * math.tan(math.radians(self.roll_deg)) / air_mps * STEP_S

    def _speed(self, speed_kt: float, climb_mps: float, air_mps: float) -> None:
        self.throttle = _limited(self.throttle + (speed_kt - self.speed_kt) / _KT_S_PER_THROTTLE * STEP_S, 0.0, 1.0)
        # Climb, m/s, for each part of the throttle that level flight does not need.
        power_mps = 0.47 * self.speed_kt * (self.throttle - _level_throttle(self.speed_kt))
        gain_kt = GRAVITY_M_S2 * (power_mps - climb_mps) / air_mps * STEP_S / mps_from_kt(1.0)
        self.speed_kt = max(_SLOWEST_KT, self.speed_kt + gain_kt)


def wrap_180(angle_deg: float) -> float:
    """The same angle in -180 to 180 degrees."""
    return (angle_deg + 180.0) % 360.0 - 180.0


def _level_throttle(speed_kt: float) -> float:
    """Throttle that holds this indicated airspeed in level flight: 0.52 at 40 kt, 0.71 at 55, 1 at 74."""
    over_kt = speed_kt - 55.0
    return 0.71 + 0.01367 * over_kt + 0.0000667 * over_kt * over_kt


def _limited(value: float, lowest: float, highest: float) -> float:
    return min(highest, max(lowest, value))
