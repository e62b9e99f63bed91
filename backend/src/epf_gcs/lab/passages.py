"""Where the aircraft passed each waypoint under a law that turns before it: the plan goes on to the next one there."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import numpy as np

from epf_gcs.earth import GRAVITY_M_S2
from epf_gcs.lab.figures import REACHED_M, Capture, Figures, Leg, metres, split
from epf_gcs.lab.routes import Route
from epf_gcs.lab.truth import Truth

WITHIN_RADII: Final = 1.2
"""How near an honest capture is, in radii of the turn at the ground speed flown."""


def in_passing(figures: Figures, truth: Truth, route: Route, bank_deg: float) -> Figures:
    """The same figures with each capture where the aircraft was nearest to the waypoint, on the leg to it or the one
    from it. `bank_deg`: of the turns. The flight ends near the last one (`REACHED_M`), which counts as being there."""
    legs = split(truth, route.waypoints)
    captures = (
        _nearest(number, legs[number : number + 2], bank_deg, is_last=number == len(route.waypoints) - 1)
        for number in range(figures.waypoints_reached)
    )
    return replace(figures, captures=tuple(captures))


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
    radius_m = speed_m_s**2 / (GRAVITY_M_S2 * math.tan(math.radians(bank_deg)))
    within_m = WITHIN_RADII * radius_m
    return Capture(
        number,
        float(truth.time_s[nearest]),
        float(distances[nearest]),
        float(truth.altitude_ft[nearest]) - waypoint.altitude_ft,
        max(within_m, REACHED_M) if is_last else within_m,
    )
