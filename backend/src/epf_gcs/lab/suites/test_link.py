"""Delay and loss between simulator and board: the plan is flown all the same."""

from __future__ import annotations

from typing import Any

import pytest

from epf_gcs.lab.bounds import Bounds
from epf_gcs.lab.plugin import Lab
from epf_gcs.lab.suites.places import SHORT


@pytest.mark.parametrize(
    "link",
    [
        pytest.param({"round_trip_ms": 160.0}, id="160 ms"),
        pytest.param({"loss_percent": 20.0}, id="20 % lost"),
        pytest.param({"round_trip_ms": 40.0, "jitter_ms": 40.0, "loss_percent": 5.0}, id="40 ms, jitter, 5 % lost"),
    ],
)
def test_a_worse_link(lab: Lab, bounds: Bounds, link: dict[str, Any]) -> None:
    flight = lab.fly(SHORT, **link)
    bounds.equal("waypoints at which the aircraft was", flight.captured_honestly, len(SHORT))
    bounds.below("off the way, rms", flight.near.rms_m, 25.0, "m")
    bounds.below("altitude, rms", flight.altitude.settled.rms_ft, 14.0, "ft")


@pytest.mark.parametrize("rate_hz", [30, 100])
def test_another_rate_of_frames(lab: Lab, bounds: Bounds, rate_hz: int) -> None:
    flight = lab.fly(SHORT, rate_hz=rate_hz)
    bounds.equal("waypoints at which the aircraft was", flight.captured_honestly, len(SHORT))
    bounds.below("off the way, rms", flight.near.rms_m, 25.0, "m")
    bounds.below("altitude, rms", flight.altitude.settled.rms_ft, 14.0, "ft")
