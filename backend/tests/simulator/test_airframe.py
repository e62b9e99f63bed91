"""Signs, units and pitfalls of the flying aircraft."""

from dataclasses import replace

import pytest

from epf_gcs.simulator.airframe import STEP_HZ, Airframe, AirframeError
from epf_gcs.simulator.models import AIRCRAFT, AircraftModel
from epf_gcs.simulator.situation import RUNWAY_HEADING_DEG, Situation, Start, Turbulence, Wind
from epf_gcs.simulator.state import Controls, FlightState
from epf_gcs.simulator.trim import trimmed

RC = AIRCRAFT["rc"]


def flying(situation: Situation | None = None, model: AircraftModel = RC) -> tuple[Airframe, Controls]:
    situation = situation or Situation()
    trim = trimmed(model, situation.start)
    return Airframe(model, situation, trim.motion, trim.controls), trim.controls


def after(craft: Airframe, controls: Controls, seconds: float) -> FlightState:
    craft.command(controls)
    craft.step(round(seconds * STEP_HZ))
    return craft.state()


@pytest.mark.parametrize("name", list(AIRCRAFT))
def test_elevator_up_lifts_the_nose(name: str) -> None:
    craft, trim = flying(model=AIRCRAFT[name])
    before = craft.state()
    state = after(craft, replace(trim, elevator=trim.elevator + 0.2), 0.4)
    assert state.surfaces.elevator == pytest.approx(trim.elevator + 0.2, abs=0.01)
    assert state.q_rad_s > 0.02
    assert state.pitch_deg > before.pitch_deg + 0.2


@pytest.mark.parametrize("name", list(AIRCRAFT))
def test_aileron_right_lowers_the_right_wing(name: str) -> None:
    craft, trim = flying(model=AIRCRAFT[name])
    state = after(craft, replace(trim, aileron=trim.aileron + 0.2), 0.4)
    assert state.surfaces.aileron == pytest.approx(trim.aileron + 0.2, abs=0.01)
    assert state.p_rad_s > 0.02
    assert state.roll_deg > 0.5


@pytest.mark.parametrize("name", list(AIRCRAFT))
def test_rudder_right_turns_the_nose_right(name: str) -> None:
    craft, trim = flying(model=AIRCRAFT[name])
    before = craft.state()
    state = after(craft, replace(trim, rudder=0.3), 0.4)
    assert state.surfaces.rudder == pytest.approx(0.3, abs=0.01)
    assert state.r_rad_s > 0.02
    assert state.heading_deg > before.heading_deg
    # The nose goes right of the way it flies, so the air comes from the left.
    assert state.beta_deg < before.beta_deg


def test_rudder_right_steers_right_on_the_runway() -> None:
    craft, _ = flying(Situation(start=Start.RUNWAY))
    heading_deg = craft.state().heading_deg
    state = after(craft, Controls(0.0, 0.0, 0.5, 0.5), 1.5)
    assert state.on_ground
    assert state.speed_ground_kt > 3.0
    assert state.heading_deg > heading_deg + 1.0


def test_throttle_accelerates_and_climbs() -> None:
    craft, trim = flying()
    state = after(craft, replace(trim, throttle=1.0), 0.5)
    assert state.load_axial_g > 0.02
    assert after(craft, replace(trim, throttle=1.0), 3.0).vvi_ft_min > 100.0


def test_latitude_is_geodetic_and_the_aircraft_begins_where_it_was_put() -> None:
    situation = Situation(latitude_deg=28.5, longitude_deg=-14.0, heading_deg=270.0)
    craft, _ = flying(situation)
    state = craft.state()
    assert state.latitude_deg == pytest.approx(28.5, abs=1e-5)
    assert state.longitude_deg == pytest.approx(-14.0, abs=1e-5)
    assert state.heading_deg == pytest.approx(270.0, abs=0.01)


def test_the_engine_pulls_from_the_first_instant() -> None:
    craft, _ = flying()
    speed_kt = craft.state().airspeed_indicated_kt
    craft.step(STEP_HZ)
    assert craft.state().airspeed_indicated_kt == pytest.approx(speed_kt, abs=0.1)


def test_the_atmosphere_is_the_standard_one() -> None:
    craft, _ = flying()
    state = craft.state()
    assert state.altitude_indicated_ft == pytest.approx(state.altitude_ft, abs=2.0)
    assert state.pressure_inhg == pytest.approx(28.856, abs=0.01)
    assert state.temperature_degc == pytest.approx(13.02, abs=0.05)
    assert state.altitude_agl_ft == pytest.approx(1000.0 - 78.0, abs=0.5)


def test_wind_carries_the_aircraft_but_leaves_its_airspeed() -> None:
    craft, _ = flying(Situation(heading_deg=0.0, wind=Wind(225.0, 20.0)))
    craft.step(1)
    state = craft.state()
    assert state.airspeed_indicated_kt == pytest.approx(55.0, abs=0.2)
    assert abs(state.beta_deg) < 0.5
    # Wind from the south-west: (55.8 + 14.1) kt to the north, 14.1 kt to the east.
    assert state.track_deg == pytest.approx(11.4, abs=0.2)
    assert state.speed_ground_kt == pytest.approx(71.3, abs=0.3)


def test_a_parked_aircraft_has_no_angle_of_attack_and_its_heading_as_track() -> None:
    breeze = Wind(RUNWAY_HEADING_DEG + 90.0, 4.0)
    craft, _ = flying(Situation(start=Start.RUNWAY, wind=breeze))
    craft.step(4)
    state = craft.state()
    assert (state.alpha_deg, state.beta_deg, state.path_deg) == (0.0, 0.0, 0.0)
    assert state.track_deg == state.heading_deg


def shaken(seed: int, turbulence: Turbulence = Turbulence.MODERATE) -> list[FlightState]:
    craft, _ = flying(Situation(turbulence=turbulence, seed=seed))
    states = []
    for _ in range(50):
        craft.step(4)
        states.append(craft.state())
    return states


def test_turbulence_shakes_and_its_seed_decides_how() -> None:
    first = shaken(seed=1)
    assert max(abs(state.load_normal_g - 1.0) for state in first) > 0.05
    assert shaken(seed=1) == first
    assert shaken(seed=2) != first


def test_calm_air_does_not_shake() -> None:
    assert max(abs(s.load_normal_g - 1.0) for s in shaken(1, Turbulence.NONE)) < 0.01


def test_a_wing_tip_on_the_ground_is_noticed() -> None:
    trim = trimmed(RC, Start.RUNWAY)
    rolled = replace(trim.motion, roll_deg=40.0)
    craft = Airframe(RC, Situation(start=Start.RUNWAY), rolled, trim.controls)
    craft.step(4)
    assert craft.state().touching == "right tip"


def test_an_aircraft_that_does_not_exist_is_named() -> None:
    unknown = replace(RC, name="zeppelin")
    trim = trimmed(RC, Start.AIR)
    with pytest.raises(AirframeError, match="zeppelin"):
        Airframe(unknown, Situation(), trim.motion, trim.controls)
