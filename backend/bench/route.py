"""A flight of any length as a function of time alone: circuits that never coincide, with gusts."""

from __future__ import annotations

import math
from typing import NamedTuple

from epf_gcs.xplane.datagram import Record, build

_LATITUDE_DEG = 27.93
_LONGITUDE_DEG = -15.38
_FT_PER_M = 1.0 / 0.3048
_STEP_S = 0.01
_M_PER_DEG = 111_195.0


class Moment(NamedTuple):
    """Position and attitude of the aircraft; altitude in metres above mean sea level, angles in degrees."""

    latitude_deg: float
    longitude_deg: float
    altitude_m: float
    heading_deg: float
    pitch_deg: float
    roll_deg: float


def place(t_s: float) -> tuple[float, float, float]:
    """Latitude, longitude and altitude at this time: circuits of eight minutes at 50 to 90 m/s, gusts of seconds."""
    turn, drift = t_s / 75.0, t_s / 1700.0
    gust_m = 0.6 * math.sin(1.3 * t_s) + 0.3 * math.sin(3.1 * t_s)
    return (
        _LATITUDE_DEG + 0.045 * math.sin(turn) + 0.02 * math.sin(drift) + 0.4 * gust_m / _M_PER_DEG,
        _LONGITUDE_DEG + 0.045 * math.cos(turn) + 0.02 * math.cos(0.7 * drift) + gust_m / _M_PER_DEG,
        450.0 + 220.0 * math.sin(0.41 * turn) + 0.5 * gust_m,
    )


def moment(t_s: float) -> Moment:
    """Position at this time, with a matching attitude."""
    latitude_deg, longitude_deg, altitude_m = place(t_s)
    before = place(t_s - _STEP_S)
    east = (longitude_deg - before[1]) * math.cos(math.radians(latitude_deg))
    heading_deg = math.degrees(math.atan2(east, latitude_deg - before[0])) % 360.0
    return Moment(latitude_deg, longitude_deg, altitude_m, heading_deg, 3.0 * math.sin(0.7 * t_s), -24.0)


def datagram(t_s: float) -> bytes:
    """The simulator's datagram at this time."""
    at = moment(t_s)
    values: dict[int, tuple[float, ...]] = {
        3: (130.0, 130.0, 130.0, 130.0),
        4: (0.0, 0.0, 100.0, 0.0, 1.0),
        17: (at.pitch_deg, at.roll_deg, at.heading_deg),
        18: (3.0, 0.0, at.heading_deg, 3.0),
        20: (at.latitude_deg, at.longitude_deg, at.altitude_m * _FT_PER_M, 0.0, 0.0, at.altitude_m * _FT_PER_M),
    }
    return build(
        [Record(row, tuple(map(float, (*given, *(0.0,) * (8 - len(given)))))) for row, given in values.items()]
    )
