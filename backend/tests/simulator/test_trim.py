"""The trimmed states in the file, and what flies from them."""

from dataclasses import asdict

import pytest

from epf_gcs.simulator.airframe import STEP_HZ, Airframe
from epf_gcs.simulator.models import AIRCRAFT
from epf_gcs.simulator.situation import AIR_ALTITUDE_FT, Situation, Start
from epf_gcs.simulator.trim import fly_trim, trimmed

EVERY_START = [(name, start) for name in AIRCRAFT for start in Start]


@pytest.mark.parametrize(("name", "start"), EVERY_START)
def test_the_file_holds_what_a_fresh_computation_finds(name: str, start: Start) -> None:
    fresh = fly_trim(AIRCRAFT[name], start)
    stored = trimmed(AIRCRAFT[name], start)
    assert asdict(stored.motion) == pytest.approx(asdict(fresh.motion), abs=0.01)
    assert asdict(stored.controls) == pytest.approx(asdict(fresh.controls), abs=0.001)


@pytest.mark.parametrize("name", list(AIRCRAFT))
def test_in_the_air_the_aircraft_flies_straight_on_with_nobody_at_the_controls(name: str) -> None:
    model = AIRCRAFT[name]
    trim = trimmed(model, Start.AIR)
    craft = Airframe(model, Situation(), trim.motion, trim.controls)
    craft.step(10 * STEP_HZ)
    state = craft.state()
    assert state.altitude_ft == pytest.approx(AIR_ALTITUDE_FT, abs=5.0)
    assert state.airspeed_indicated_kt == pytest.approx(model.cruise_kt, abs=0.5)
    assert abs(state.roll_deg) < 1.0
    assert state.load_normal_g == pytest.approx(1.0, abs=0.01)


@pytest.mark.parametrize("name", list(AIRCRAFT))
def test_on_the_runway_it_stands_still(name: str) -> None:
    model = AIRCRAFT[name]
    trim = trimmed(model, Start.RUNWAY)
    situation = Situation(start=Start.RUNWAY)
    craft = Airframe(model, situation, trim.motion, trim.controls)
    craft.step(10 * STEP_HZ)
    state = craft.state()
    assert state.on_ground
    assert state.speed_ground_kt < 0.1
    assert (state.latitude_deg, state.longitude_deg) == pytest.approx(situation.place(), abs=1e-6)
    assert state.altitude_agl_ft < model.wheels_height_ft


@pytest.mark.parametrize("name", list(AIRCRAFT))
def test_on_final_it_descends_at_three_degrees(name: str) -> None:
    model = AIRCRAFT[name]
    trim = trimmed(model, Start.FINAL)
    craft = Airframe(model, Situation(start=Start.FINAL), trim.motion, trim.controls)
    craft.step(5 * STEP_HZ)
    state = craft.state()
    assert state.path_deg == pytest.approx(-3.0, abs=0.2)
    assert state.airspeed_indicated_kt == pytest.approx(model.approach_kt, abs=0.5)
