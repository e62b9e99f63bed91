"""The line law in lock-step with the simulated aircraft: how it holds a leg, and that no change of it is a bump."""

import random

import pytest

from epf_gcs.codec.tables import Waypoint
from epf_gcs.lab.closed_loop import ClosedLoop
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.flying import fly_wanted
from epf_gcs.simulator.simulation import SimulationOptions
from epf_gcs.simulator.situation import Situation, Wind

CORNER = (
    Waypoint(27.9500, -15.3740, 1000.0, 55.0),
    Waypoint(27.9490, -15.3500, 1100.0, 60.0),
    Waypoint(27.9300, -15.3500, 1100.0, 60.0),
)
CHANGES = 60


def test_in_a_cross_wind_it_keeps_the_leg_and_captures_each_waypoint() -> None:
    flight = fly_wanted(CORNER, {"law": "line", "wind_kt": 25, "wind_from_deg": 200})
    assert flight.is_safe, flight
    assert flight.leg.rms_m < 6.0
    assert flight.near.rms_m < 12.0
    assert flight.altitude.settled.rms_ft < 9.0
    assert flight.airspeed.settled.rms_kt < 1.0


def test_its_gains_are_set_by_name_and_refused_out_of_range() -> None:
    gentle = fly_wanted(CORNER[:2], {"law": "line"}, {"line_bank_limit": 15})
    usual = fly_wanted(CORNER[:2], {"law": "line"})
    assert gentle.near.rms_m != usual.near.rms_m
    with pytest.raises(LabError, match="takes no gain line_bank_limit of 90"):
        fly_wanted(CORNER, {"law": "line"}, {"line_bank_limit": 90})
    with pytest.raises(LabError, match="takes no gain line_tail of 1"):
        fly_wanted(CORNER, {"law": "line"}, {"line_tail": 1})


def test_changing_law_plan_waypoint_and_bank_limit_in_flight_moves_no_surface_by_a_twentieth_of_its_travel() -> None:
    dice = random.Random(20261128)
    with ClosedLoop(SimulationOptions(situation=Situation(wind=Wind(200.0, 20.0)))) as loop:
        loop.command("hil_load_gando")
        loop.command("autopilot_on")
        law = "bearing"
        loop.fly(2.0)
        for number in range(CHANGES):
            before, law_before = loop.surfaces, law
            match dice.randrange(4):
                case 0:
                    law = "line" if law == "bearing" else "bearing"
                    loop.own_gains.select(law)
                case 1:
                    loop.command(f"hil_load_{dice.choice(('gando', 'alternativa', 'vuelo'))}")
                case 2:
                    loop.command("go_to_waypoint", 1, dice.randrange(8))
                case _:
                    loop.own_gains.set("line_bank_limit", dice.uniform(20.0, 45.0))
            loop.fly(0.02)
            after = loop.surfaces
            assert before is not None
            assert after is not None
            # The deployed law jumps at a new waypoint, and its bytes are to stay.
            if "line" in (law, law_before):
                steps = [abs(one - other) for one, other in zip(before, after, strict=True)]
                assert max(steps[:3]) <= 0.1, (number, before, after)
                assert steps[3] <= 0.05, (number, before, after)
            loop.fly(dice.uniform(0.0, 2.0))
        assert not loop.crashes
