"""Faults: each does to the flight what it says, shows that it did, and a flight without the one asked for fails."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from epf_gcs.codec.tables import Waypoint
from epf_gcs.contract.simulator_faults import KINDS, Fault
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.faults import read
from epf_gcs.lab.flight import Flight
from epf_gcs.lab.flying import fly_wanted

BEGIN_S = 4.0
LENGTH_S = 2.0
END_S = 8.0
NOT_IN_HIL = {
    ("receiver", "dropout"),
    *((place, "dropout") for place in ("gyro", "attitude", "pitot", "barometer", "gps")),
}
ALL = [(place, kind) for place, kinds in KINDS.items() for kind in kinds]


def flown(*faults: Any, longest_s: float = END_S, **conditions: Any) -> Flight:
    return fly_wanted("gando", {"turbulence": "light", **conditions}, faults=faults, longest_s=longest_s)


@pytest.mark.parametrize(("place", "kind"), ALL)
def test_every_fault_is_shown_to_have_been_there(place: str, kind: str) -> None:
    length = "" if place in ("simulator", "board") else f"+{LENGTH_S:g}"
    fault = f"{place}.{kind}@{BEGIN_S:g}{length}"
    # No light gust asks for more than the usual limit of a slow one in a frame.
    fault += "=0.01" if kind == "slow" else "=0.2" if kind == "jammed" else ""
    (shown,) = flown(fault, loop="aircraft" if (place, kind) in NOT_IN_HIL else "hil").evidence
    assert shown.startswith(f"{fault}: {place} {KINDS[place][kind].says}, shown in ")


def test_the_same_seed_flies_the_same_to_the_last_bit() -> None:
    faults = ("gyro.noise@1", "gps.jump@1", "line.loss@1", "line.flipped@2", "line.jitter@3", "board.reset@5+0.4")
    one, other = flown(*faults), flown(*faults)
    assert one.evidence == other.evidence
    for mine, others in zip(one.truth.columns(), other.truth.columns(), strict=True):
        np.testing.assert_array_equal(mine, others)


def test_until_it_begins_a_fault_changes_nothing_and_from_then_on_it_does() -> None:
    never, there = flown("gps.stuck@7.9"), flown(f"aileron.weak@{BEGIN_S:g}=0")
    same = never.truth.latitude_deg == there.truth.latitude_deg
    first = int(np.flatnonzero(~same)[0])
    assert BEGIN_S <= there.truth.time_s[first] < BEGIN_S + 1.0


def test_another_seed_has_another_noise() -> None:
    one, other = (flown("gyro.noise@4.9=0.3", seed=seed, turbulence="none") for seed in (1, 2))
    assert (one.truth.latitude_deg[:240] == other.truth.latitude_deg[:240]).all()
    assert not (one.truth.latitude_deg == other.truth.latitude_deg).all()


def test_a_fault_after_the_flights_end_fails_it_with_that_sentence() -> None:
    with pytest.raises(LabError, match=r"gyro.bias@50 was asked for and was not there: the flight ended after 8.0 s"):
        flown("gyro.bias@50")


def test_a_fault_that_changes_no_value_fails_the_flight_with_that_sentence() -> None:
    with pytest.raises(LabError, match="was not there: what arrived is what was sent"):
        flown("aileron.slow@4+2=20")


@pytest.fixture(scope="module")
def right() -> Flight:
    return flown("pitot.bias@39.9=1", longest_s=40.0, turbulence="none")


def test_a_wrong_airspeed_is_flown_by_the_truth_at_another_speed(right: Flight) -> None:
    fast = flown("pitot.bias@1=-8", longest_s=40.0, turbulence="none")
    assert fast.truth.airspeed_kt[-1] - right.truth.airspeed_kt[-1] == pytest.approx(8.0, abs=2.0)


def test_a_wrong_altitude_is_flown_by_the_truth_at_another_altitude(right: Flight) -> None:
    low = flown("barometer.bias@1=40", longest_s=40.0, turbulence="none")
    assert low.truth.altitude_ft[-1] - right.truth.altitude_ft[-1] == pytest.approx(-40.0, abs=10.0)


@pytest.mark.parametrize("kind", ["pause", "silent"])
def test_during_a_pause_of_the_simulator_the_aircraft_stands_and_flies_on_after_it(kind: str, right: Flight) -> None:
    flight = flown(f"simulator.{kind}@{BEGIN_S:g}+20", longest_s=40.0, turbulence="none")
    np.testing.assert_array_equal(flight.truth.time_s, right.truth.time_s)
    assert np.abs(flight.truth.altitude_ft - right.truth.altitude_ft).max() < 30.0


def test_a_board_that_starts_anew_has_forgotten_its_plan_and_lets_the_aircraft_glide() -> None:
    flight = flown(f"board.reset@{BEGIN_S:g}", longest_s=30.0)
    assert set(flight.truth.waypoint[flight.truth.time_s > BEGIN_S + 0.1]) == {-1}
    assert flight.truth.altitude_ft[-1] < flight.truth.altitude_ft[int(BEGIN_S * 50)] - 100.0


def test_the_real_aircrafts_loop_flies_to_a_waypoint_by_its_sensors() -> None:
    flight = fly_wanted([Waypoint(27.9380, -15.3830, 1000.0, 55.0)], {"loop": "aircraft"})
    assert flight.captured_honestly == 1
    assert flight.altitude.settled.rms_ft < 20.0


@pytest.mark.parametrize(
    ("fault", "said"),
    [
        ("accelerometer.bias@3", "carries no accelerations; what they spoil is `attitude`"),
        ("magnetometer.noise@3", "carries no magnetic field"),
        ("battery.low@3", "carries no voltage"),
        ("tail.off@3", "there is no fault of tail: choose of gyro"),
        ("gyro.jammed@3", "there is no fault gyro.jammed: choose of stuck"),
        ("gyro", "is no fault: PLACE.KIND@START"),
        ("gyro.bias@soon", "is no fault: could not convert"),
        ("gyro.bias@3+0", "must begin in the flight and last for a time"),
        ("gyro.stuck@3=2", "gyro.stuck has no strength"),
        ("engine.weak@3=1.2", "its strength must be 0 to 1"),
        ("gyro.dropout@3", "command 50 has no word for a value that was not measured"),
        ({"place": "gyro", "kind": "bias", "begin_s": 3}, "is no fault"),
    ],
)
def test_a_fault_that_cannot_be_flown_is_refused_in_words(fault: Any, said: str) -> None:
    with pytest.raises(LabError, match=r".") as refused:
        flown(fault)
    assert said in str(refused.value)


def test_the_real_aircraft_has_no_line_that_could_fail() -> None:
    with pytest.raises(LabError, match="flies by its sensors, without line or simulator"):
        flown("line.cut@3", loop="aircraft")
    with pytest.raises(LabError, match="has no link to be delayed"):
        flown(loop="aircraft", round_trip_ms=100.0)


@pytest.mark.parametrize("text", ["gyro.drift@60+30=0.002", "engine.out@5", "aileron.jammed@60=-0.2", "line.cut@9+0.5"])
def test_a_fault_is_written_as_it_is_read(text: str) -> None:
    (fault,) = read([text])
    assert str(fault) == text
    assert read([str(fault), fault]) == (fault, fault)
    assert isinstance(fault, Fault)
