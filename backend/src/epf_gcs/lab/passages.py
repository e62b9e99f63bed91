"""Where the aircraft passed each waypoint under a law that turns before it: the plan goes on to the next one there."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

import numpy as np

from epf_gcs.lab.figures import REACHED_M, Capture, Leg, metres
from epf_gcs.lab.truth import Truth

WITHIN_RADII: Final = 1.2
"""How near an honest capture is, in radii of the turn at the ground speed flown."""
_GRAVITY_M_S2: Final = 9.80665


def passages(legs: Sequence[Leg], reached: int, bank_deg: float) -> tuple[Capture, ...]:
    """Where the aircraft was nearest to each of the first `reached` waypoints, on the leg to it or the one from it.

    The flight ends near the last one (`REACHED_M`), which counts as being there.
    """
    return tuple(
        _nearest(number, legs[number : number + 2], bank_deg, is_last=number == len(legs) - 1)
        for number in range(reached)
    )


def _nearest(number: int, legs: Sequence[Leg], bank_deg: float, *, is_last: bool) -> Capture:
    waypoint = legs[0].waypoint
    place = (waypoint.latitude_deg, waypoint.longitude_deg)
    truth = Truth(*(np.concatenate(parts) for parts in zip(*(leg.truth.columns() for leg in legs), strict=True)))
    offsets = [metres(place, one) for one in zip(truth.latitude_deg, truth.longitude_deg, strict=True)]
    distances = np.hypot(*np.array(offsets).T)
    nearest = int(np.argmin(distances))
    before = max(nearest - 1, 0)
    way_m = math.dist(offsets[before], offsets[before + 1])
    speed_m_s = way_m / float(truth.time_s[before + 1] - truth.time_s[before])
    radius_m = speed_m_s**2 / (_GRAVITY_M_S2 * math.tan(math.radians(bank_deg)))
    within_m = WITHIN_RADII * radius_m
    return Capture(
        number,
        float(truth.time_s[nearest]),
        float(distances[nearest]),
        float(truth.altitude_ft[nearest]) - waypoint.altitude_ft,
        max(within_m, REACHED_M) if is_last else within_m,
    )
