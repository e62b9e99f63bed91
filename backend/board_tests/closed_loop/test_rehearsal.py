"""The model that plans are flown in before they are sent, beside JSBSim under the board's own code: leg by leg."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from board_tests.closed_loop.circuit import LONGEST_S, Circuit
from epf_gcs.codec.messages_gen import ROUTES
from epf_gcs.codec.tables import Waypoint
from epf_gcs.lab.closed_loop import ClosedLoop, Sample
from epf_gcs.lab.figures import RouteEnd, split
from epf_gcs.lab.truth import Truth
from epf_gcs.rehearsal.flight_model import Start, SteadyWind
from epf_gcs.rehearsal.flown_plan import SAMPLE_S, fly, metres
from epf_gcs.simulator.simulation import SimulationOptions
from epf_gcs.simulator.situation import Situation, Wind
from tests.rehearsal.plans import REVERSAL, STRAIGHT, plan

_HIL_PLAN = 1
BEFORE_DEG = 0.015
GANDO = list(ROUTES["gando"].waypoints)
UP_AND_DOWN = plan((0, 0), (3000, 0, 1900, 50), (6000, 1500, 600, 65), (9000, 0, 600, 40), (9000, -1500, 1000, 55))


def flown_by_board(waypoints: Sequence[Waypoint], wind: SteadyWind) -> list[Sample]:
    situation = Situation(
        latitude_deg=waypoints[0].latitude_deg - BEFORE_DEG,
        longitude_deg=waypoints[0].longitude_deg,
        wind=Wind(wind.from_deg, wind.speed_kt),
    )
    with ClosedLoop(SimulationOptions(situation=situation)) as loop:
        loop.command("mission_begin", _HIL_PLAN, len(waypoints))
        for index, at in enumerate(waypoints):
            loop.command(
                "mission_item", _HIL_PLAN, index, at.latitude_deg, at.longitude_deg, at.altitude_ft, at.speed_kt
            )
        loop.command("mission_commit", _HIL_PLAN)
        loop.command("autopilot_on")
        samples = loop.fly(LONGEST_S, RouteEnd(waypoints).reached)
        assert loop.crashes == []
        assert samples[-1].time_s < LONGEST_S
        return samples


def differences(
    samples: Sequence[Sample], waypoints: Sequence[Waypoint], wind: SteadyWind
) -> list[tuple[float, float, float]]:
    """Of each leg: share of its time that the model takes longer, the most metres between both ways, and the most feet
    between both altitudes at the same moment of the leg."""
    first = samples[0].state
    start = Start(
        first.latitude_deg, first.longitude_deg, first.altitude_ft, first.track_deg, first.airspeed_indicated_kt
    )
    flown = fly(waypoints, 0, start, wind)
    found = []
    for real, model in zip(split(Truth.of(samples), waypoints), flown.legs, strict=True):
        assert model.end is not None
        if model.samples == 0:
            continue
        begin = next(index for index, sample in enumerate(flown.samples) if sample.row == model.row)
        modelled = flown.samples[begin : begin + model.samples]
        origin = real.begin
        flown_deg = zip(real.truth.latitude_deg[::10], real.truth.longitude_deg[::10], strict=True)
        path = np.array([metres(origin, place) for place in flown_deg])
        places = np.array([metres(origin, at[1:3]) for at in modelled])
        apart_m = np.hypot(*(places[:, None] - path[None]).T).min(axis=0).max()
        every = round(SAMPLE_S * 50)
        altitudes = zip(modelled, real.truth.altitude_ft[::every], strict=False)
        apart_ft = max(abs(one.altitude_ft - other_ft) for one, other_ft in altitudes)
        took_s = real.truth.time_s[-1] - real.truth.time_s[0]
        found.append((float((model.end.time_s - model.begin_s) / took_s - 1.0), float(apart_m), float(apart_ft)))
    return found


def test_the_gando_circuit_is_flown_as_the_board_flies_it(circuit: Circuit) -> None:
    found = differences(circuit.samples, GANDO, SteadyWind())
    assert len(found) == len(GANDO)
    assert max(abs(late) for late, _, _ in found) < 0.03
    assert max(apart_m for _, apart_m, _ in found) < 60.0
    assert max(apart_ft for _, _, apart_ft in found) < 80.0


@pytest.mark.parametrize(
    ("waypoints", "wind"),
    [
        pytest.param(UP_AND_DOWN, SteadyWind(300.0, 20.0), id="climbs, descents and speeds in 20 kt"),
        pytest.param(REVERSAL, SteadyWind(270.0, 30.0), id="a turn back in 30 kt across"),
        pytest.param(STRAIGHT[:2], SteadyWind(0.0, 40.0), id="against 40 kt"),
    ],
)
def test_other_plans_and_winds_too(waypoints: list[Waypoint], wind: SteadyWind) -> None:
    found = differences(flown_by_board(waypoints, wind), waypoints, wind)
    assert max(abs(late) for late, _, _ in found) < 0.05
    assert max(apart_m for _, apart_m, _ in found) < 130.0
    assert max(apart_ft for _, _, apart_ft in found) < 120.0
