"""The quick loop flies the flight of the loop over datagrams."""

from __future__ import annotations

import numpy as np
import pytest

from epf_gcs.codec.messages_gen import ROUTES
from epf_gcs.lab.closed_loop import ClosedLoop
from epf_gcs.lab.lock_step import LockStep
from epf_gcs.lab.truth import Truth
from epf_gcs.simulator.link import LinkQuality
from epf_gcs.simulator.simulation import SimulationOptions
from epf_gcs.simulator.situation import Situation, Start, Turbulence, Wind

ROUGH = Situation(wind=Wind(330.0, 20.0), turbulence=Turbulence.MODERATE, seed=7)


@pytest.mark.parametrize(
    "options",
    [
        pytest.param(SimulationOptions(), id="calm"),
        pytest.param(
            SimulationOptions(situation=ROUGH, link=LinkQuality(delay_ms=40.0, jitter_ms=30.0, loss=0.1)), id="rough"
        ),
        pytest.param(SimulationOptions(situation=Situation(start=Start.RUNWAY), throttle=1.0), id="from the runway"),
        pytest.param(SimulationOptions(aircraft="c172p", rate_hz=30), id="another aircraft at another rate"),
    ],
)
def test_it_flies_the_same_flight_to_the_last_bit(options: SimulationOptions) -> None:
    with ClosedLoop(options) as slow, LockStep(options) as quick:
        for loop in (slow, quick):
            loop.command("hil_load_gando")
            loop.command("autopilot_on")
        expected = Truth.of(slow.fly(60.0))
        flown = quick.fly(ROUTES["gando"].waypoints, 60.0)
    assert slow.crashes == []
    for name, column in zip(("time", "latitude", "longitude"), flown.columns(), strict=False):
        assert len(column) == 60 * options.rate_hz, name
    for mine, other in zip(flown.columns(), expected.columns(), strict=True):
        np.testing.assert_array_equal(mine, other)


def test_an_aircraft_that_is_lost_ends_the_flight_with_the_cause() -> None:
    with LockStep(SimulationOptions(situation=Situation(turbulence=Turbulence.SEVERE))) as loop:
        loop.command("hil_load_gando")
        loop.set_gains({"k_pitch": 0.0})
        loop.command("autopilot_on")
        flown = loop.fly(ROUTES["gando"].waypoints, 900.0)
    assert loop.upset is not None
    assert "g (limit 15 g)" in loop.upset.cause
    assert flown.time_s[-1] == pytest.approx(loop.upset.time_s - 0.02)
