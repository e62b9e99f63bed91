"""The path that the present track leads along."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np

from epf_gcs.earth import M_PER_DEG
from epf_gcs.surroundings.motion import Motion, Vector

STEP_S: Final = 0.5
_LEAST_TURN_RAD_S: Final = 1e-4


@dataclass(frozen=True, slots=True)
class Path:
    """Places from now on, `after_s` seconds from now; altitude above the sea, east and north from the aircraft."""

    after_s: Vector
    latitude_deg: Vector
    longitude_deg: Vector
    altitude_m: Vector
    east_m: Vector
    north_m: Vector


def path_ahead(motion: Motion, now_s: float, ahead_s: float) -> Path:
    """From `now_s` for `ahead_s`: the air carries the aircraft along, while it turns and climbs as it does now."""
    after_s = np.arange(0.0, ahead_s + STEP_S / 2, STEP_S)
    time_s = after_s + max(0.0, now_s - motion.t_s)
    air_east = motion.east_mps - motion.wind_east_mps
    air_north = motion.north_mps - motion.wind_north_mps
    airspeed_mps, heading = math.hypot(air_east, air_north), math.atan2(air_east, air_north)
    turn = motion.turn_rad_s
    if abs(turn) < _LEAST_TURN_RAD_S:
        east_m, north_m = air_east * time_s, air_north * time_s
    else:
        east_m = airspeed_mps / turn * (math.cos(heading) - np.cos(heading + turn * time_s))
        north_m = airspeed_mps / turn * (np.sin(heading + turn * time_s) - math.sin(heading))
    east_m = east_m + motion.wind_east_mps * time_s
    north_m = north_m + motion.wind_north_mps * time_s
    across = max(0.01, math.cos(math.radians(motion.latitude_deg)))
    longitude_deg = motion.longitude_deg + east_m / M_PER_DEG / across
    return Path(
        after_s,
        np.clip(motion.latitude_deg + north_m / M_PER_DEG, -90.0, 90.0),
        (longitude_deg + 180.0) % 360.0 - 180.0,
        motion.altitude_m + motion.climb_mps * time_s,
        east_m,
        north_m,
    )
