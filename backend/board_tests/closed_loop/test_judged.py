"""What the station finds out from the rows of a simulator with real dynamics, and what it does before they hurt."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import cast

import pytest

from board_tests.closed_loop.station_loop import StationLoop
from epf_gcs.contract.base import SimulatorProfile
from epf_gcs.errors import ConflictError
from epf_gcs.simulator.link import LinkQuality
from epf_gcs.simulator.simulation import SimulationOptions
from epf_gcs.simulator.situation import Situation, Start, Turbulence, Wind
from epf_gcs.simulator.state import FlightState
from epf_gcs.vehicle.profile_judge import PROFILE_NAMES
from epf_gcs.xplane.datagram import Record, build, parse

CALM = SimulationOptions()
ROUGH = Situation(wind=Wind(330.0, 20.0), turbulence=Turbulence.SEVERE)
RUNWAY = Situation(start=Start.RUNWAY)
OTHER: dict[SimulatorProfile, SimulatorProfile] = {"xp10": "xp12", "xp12": "xp10"}
BOTH = pytest.mark.parametrize("sent", ["xp10", "xp12"])


def largest_bank_deg(states: list[FlightState]) -> float:
    return max(abs(state.roll_deg) for state in states)


@BOTH
@pytest.mark.parametrize(
    "options",
    [
        pytest.param(CALM, id="calm"),
        pytest.param(replace(CALM, situation=ROUGH), id="severe turbulence"),
        pytest.param(replace(CALM, rate_hz=20), id="20 Hz"),
        pytest.param(replace(CALM, one_row_per_datagram=True), id="one row a datagram"),
        pytest.param(replace(CALM, link=LinkQuality(delay_ms=20.0, jitter_ms=30.0, loss=0.1)), id="bad link"),
        pytest.param(replace(CALM, situation=RUNWAY, throttle=1.0), id="take-off"),
    ],
)
def test_on_the_wrong_profile_the_surfaces_are_taken_from_the_board_before_the_aircraft_banks_20_deg(
    sent: SimulatorProfile, options: SimulationOptions
) -> None:
    with StationLoop(replace(options, profile=sent), OTHER[sent]) as loop:
        loop.assist("gando")
        states = loop.fly(20.0, lambda _: loop.hil.path == "manual")
        assert loop.hil.path == "manual"
        assert largest_bank_deg(states) < 20.0
        assert loop.crashes == []
        loop.fly(0.2)
        assert "profile_wrong" in loop.active
        with pytest.raises(ConflictError, match=f"choose the profile {PROFILE_NAMES[sent]}"):
            loop.hil.check_profile()


@BOTH
def test_on_the_wrong_profile_the_board_is_refused_after_a_few_seconds_by_hand(
    sent: SimulatorProfile,
) -> None:
    with StationLoop(replace(CALM, profile=sent), OTHER[sent]) as loop:
        loop.fly(5.0)
        assert loop.active == {"profile_wrong"}
        with pytest.raises(ConflictError):
            loop.hil.check_profile()


@BOTH
def test_once_the_right_profile_is_chosen_the_board_flies_on(sent: SimulatorProfile) -> None:
    with StationLoop(replace(CALM, profile=sent), OTHER[sent]) as loop:
        loop.assist("gando")
        loop.fly(20.0, lambda _: loop.hil.path == "manual")
        loop.hil.begin(loop.hil.link, sent)
        loop.hil.check_profile()
        loop.hil.path = "assisted"
        assert largest_bank_deg(loop.fly(30.0)) < 45.0
        assert loop.active == set()
        assert loop.crashes == []


@BOTH
def test_parked_on_the_runway_nothing_is_known_and_nothing_is_refused(sent: SimulatorProfile) -> None:
    with StationLoop(replace(CALM, profile=sent, situation=RUNWAY, throttle=0.0), OTHER[sent]) as loop:
        loop.fly(3.0)
        loop.hil.begin(loop.hil.link, OTHER[sent])
        loop.fly(30.0)
        assert loop.hil.fitting_profile is None
        loop.hil.check_profile()
        assert loop.active == set()


@pytest.mark.parametrize(
    ("route", "options"),
    [
        pytest.param("gando", replace(CALM, profile="xp12"), id="gando"),
        pytest.param("ruta_isla", CALM, id="isla"),
        pytest.param("alternativa", replace(CALM, profile="xp12"), id="alternativa"),
        pytest.param("vuelo", CALM, id="vuelo"),
        pytest.param("gando", replace(CALM, situation=ROUGH), id="severe turbulence"),
        pytest.param("gando", replace(CALM, situation=ROUGH, profile="xp12", rate_hz=20), id="severe at 20 Hz"),
        pytest.param(
            "gando",
            replace(CALM, situation=ROUGH, link=LinkQuality(delay_ms=20.0, jitter_ms=30.0, loss=0.1)),
            id="severe over a bad link",
        ),
        pytest.param(
            "gando",
            replace(CALM, situation=replace(RUNWAY, turbulence=Turbulence.MODERATE), throttle=1.0),
            id="take-off",
        ),
    ],
)
def test_with_the_right_profile_a_whole_flight_raises_no_alarm(route: str, options: SimulationOptions) -> None:
    with StationLoop(options, cast(SimulatorProfile, options.profile)) as loop:
        loop.assist(route)
        loop.fly(250.0)
        assert loop.alarms == []
        assert loop.hil.fitting_profile == options.profile
        assert loop.hil.path == "assisted"
        assert loop.crashes == []


@pytest.mark.parametrize("pace", [0.5, 2.0, 4.0])
def test_time_at_another_pace_is_told_within_five_seconds_and_ends_with_it(pace: float) -> None:
    with StationLoop(CALM, "xp10") as loop:
        loop.assist("gando")
        loop.fly(20.0)
        assert loop.active == set()
        loop.pace = pace
        loop.fly(5.0)
        assert loop.active == {"simulator_pace"}
        assert loop.alarms[-1][2] == {"pace": pace}
        assert loop.hil.path == "assisted"
        loop.pace = 1.0
        loop.fly(5.0)
        assert loop.active == set()


def with_value(row: int, place: int, value: float) -> Callable[[bytes], bytes]:
    """The same datagram with another value in one place."""

    def change(datagram: bytes) -> bytes:
        records = parse(datagram)
        assert records is not None
        return build(
            Record(number, (*values[:place], value, *values[place + 1 :])) if number == row else Record(number, values)
            for number, values in records
        )

    return change


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, -999.0, 1e9])
@pytest.mark.parametrize(
    ("row", "place", "name"),
    [
        (3, 0, "indicated_airspeed_kt"),
        (4, 2, "vvi_ft_min"),
        (16, 1, "p_rad_s"),
        (17, 0, "pitch_deg"),
        (20, 5, "altitude_indicated_ft"),
    ],
)
def test_a_value_that_cannot_be_used_is_named_with_its_row_while_the_loop_is_open_for_it(
    row: int, place: int, name: str, value: float
) -> None:
    with StationLoop(CALM, "xp10") as loop:
        loop.assist("gando")
        loop.fly(3.0)
        loop.change = with_value(row, place, value)
        loop.fly(1.0)
        assert loop.active == {"hil_lost"}
        said = loop.alarms[-1][2]
        assert (said["row"], said["name"], said["value"]) == (row, name, f"{value:g}")
        loop.change = lambda datagram: datagram
        loop.fly(0.3)
        assert loop.active == set()
