"""Finds in the samples where the simulator put its aircraft elsewhere.

The same is judged live (`vehicle/simulator_motion.py`) and noted a little later than it came.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from epf_gcs.flights.flight_data import FlightData, read_field
from epf_gcs.flights.over_ground import steps_m
from epf_gcs.units import M_PER_FT, MPS_PER_KT
from epf_gcs.vehicle.simulator_motion import FASTEST_RATIO, JUMP_M


class Reset(NamedTuple):
    """Unix times (ns) of the last sample before and the first after, and where that is, as `SimulatorJumpEvent`."""

    before_ns: int
    after_ns: int
    distance_m: int
    latitude_deg: float
    longitude_deg: float
    altitude_ft: float


def resets(flight: FlightData) -> list[Reset]:
    """All of a flight, in order. Raises OSError."""
    t_s, latitude = read_field(flight, "simulator", "latitude_deg")
    if len(t_s) < 2:
        return []
    longitude, altitude_ft, speed_kt = (
        read_field(flight, "simulator", name).values
        for name in ("longitude_deg", "altitude_indicated_ft", "indicated_airspeed_kt")
    )
    known = np.isfinite(latitude) & np.isfinite(longitude) & np.isfinite(altitude_ft)
    t_s, latitude, longitude, altitude_ft, speed_kt = (
        one[known] for one in (t_s, latitude, longitude, altitude_ft, speed_kt)
    )
    way_m = np.hypot(steps_m(latitude, longitude), np.diff(altitude_ft) * M_PER_FT)
    fastest_m_s = FASTEST_RATIO * MPS_PER_KT * np.maximum(np.nan_to_num(speed_kt[1:]), 0.0)
    places = np.flatnonzero(way_m > JUMP_M + fastest_m_s * np.diff(t_s))
    return [
        Reset(
            flight.start_ns + round(float(t_s[place]) * 1e9),
            flight.start_ns + round(float(t_s[place + 1]) * 1e9),
            round(float(way_m[place])),
            float(latitude[place + 1]),
            float(longitude[place + 1]),
            float(altitude_ft[place + 1]),
        )
        for place in places
    ]
