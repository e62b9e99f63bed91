"""What counts as a crash."""

import math
from dataclasses import replace

import pytest

from epf_gcs.simulator.airframe import Airframe
from epf_gcs.simulator.crash import crash_cause
from epf_gcs.simulator.models import AIRCRAFT
from epf_gcs.simulator.situation import Situation, Start
from epf_gcs.simulator.state import FlightState
from epf_gcs.simulator.trim import trimmed


@pytest.fixture(scope="module")
def level_flight() -> FlightState:
    trim = trimmed(AIRCRAFT["rc"], Start.AIR)
    return Airframe(AIRCRAFT["rc"], Situation(), trim.motion, trim.controls).state()


def test_level_flight_is_no_crash(level_flight: FlightState) -> None:
    assert crash_cause(level_flight) is None


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, 1e30])
def test_a_value_that_is_not_finite_is_a_crash(level_flight: FlightState, value: float) -> None:
    assert "not finite" in str(crash_cause(replace(level_flight, pitch_deg=value)))


@pytest.mark.parametrize(("load_g", "crashed"), [(14.9, False), (15.1, True), (-15.1, True)])
def test_more_than_15_g_is_a_crash(level_flight: FlightState, load_g: float, crashed: bool) -> None:
    cause = crash_cause(replace(level_flight, load_normal_g=load_g))
    assert (cause is not None) == crashed


def test_a_part_that_must_not_touch_is_named(level_flight: FlightState) -> None:
    assert crash_cause(replace(level_flight, touching="left tip")) == "the left tip touched the ground"
