"""Steps of altitude, course and speed out of steady flight, as the reference answers them, within a fifth."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Final

import pytest

from epf_gcs.lab.bounds import Bounds
from epf_gcs.lab.plugin import Lab
from epf_gcs.lab.routes import HIL_PLAN, Route
from epf_gcs.lab.suites.places import CRUISE_FT, CRUISE_KT, waypoint
from epf_gcs.lab.watched import Watch, Watched

# So far away that the bearing hardly changes on the way.
_FAR_M: Final = 60_000.0
_FASTER: Final = 1.15
_STRAIGHT, _CLIMB, _TURN, _SPEED = range(4)
_PLAN: Final = (
    waypoint(0.0, _FAR_M),
    waypoint(0.0, _FAR_M, CRUISE_FT + 300.0),
    waypoint(90.0, _FAR_M),
    waypoint(0.0, _FAR_M, CRUISE_FT, CRUISE_KT * _FASTER),
)
_SETTLE_S: Final = 25.0


@contextmanager
def _steady(lab: Lab, rate_hz: int = 50) -> Iterator[Watched]:
    """In steady flight straight on, with the steps as further waypoints."""
    with lab.watch(rate_hz=rate_hz) as loop:
        for name, values in Route("steps", _PLAN).commands():
            loop.command(name, *values)
        loop.command("autopilot_on")
        loop.go(_SETTLE_S)
        yield loop


@pytest.fixture
def steady(lab: Lab) -> Iterator[Watched]:
    """At the usual rate."""
    with _steady(lab) as loop:
        yield loop


def _step(loop: Watched, index: int, seconds: float) -> Watch:
    loop.command("go_to_waypoint", HIL_PLAN, index)
    return loop.go(seconds)


def test_300_ft_up(steady: Watched, bounds: Bounds) -> None:
    flown = _step(steady, _CLIMB, 60.0)
    error_ft = flown.altitude_ft - (CRUISE_FT + 300.0)
    bounds.below("settling time", flown.settling_s(error_ft, 30.0), 40.0, "s")
    bounds.below("overshoot", error_ft.max(), 14.4, "ft")
    bounds.below("bank on the way", abs(flown.roll_deg).max(), 5.0, "deg")


def test_90_degrees_to_the_right(steady: Watched, bounds: Bounds) -> None:
    flown = _step(steady, _TURN, 40.0)
    begin_deg = flown.track_deg[0]
    error_deg = (flown.track_deg - begin_deg - 90.0 + 180.0) % 360.0 - 180.0
    bounds.below("settling time", flown.settling_s(error_deg, 4.0), 20.4, "s")
    bounds.below("overshoot", error_deg.max(), 3.0, "deg")
    bounds.below("bank", flown.roll_deg.max(), 33.0, "deg")
    bounds.above("bank", flown.roll_deg.max(), 24.0, "deg")
    bounds.below("loss of altitude", CRUISE_FT - flown.altitude_ft.min(), 60.0, "ft")


@pytest.mark.parametrize("rate_hz", [50, 25])
def test_15_percent_faster(lab: Lab, bounds: Bounds, rate_hz: int) -> None:
    with _steady(lab, rate_hz) as loop:
        flown = _step(loop, _SPEED, 35.0)
    error_kt = flown.airspeed_kt - CRUISE_KT * _FASTER
    bounds.below("settling time", flown.settling_s(error_kt, 1.0), 21.6, "s")
    bounds.below("overshoot", error_kt.max(), 1.0, "kt")
    bounds.below("change of altitude", abs(flown.altitude_ft - CRUISE_FT).max(), 40.0, "ft")
