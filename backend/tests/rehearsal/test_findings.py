"""What a rehearsal finds in drawn plans, and what it leaves alone."""

from __future__ import annotations

from dataclasses import replace

import pytest

from epf_gcs.rehearsal.findings import Bounds
from tests.rehearsal.plans import FAULTY, GOOD, RUNWAY, SQUARE, STRAIGHT, Drawn, at, hill, plan


@pytest.mark.parametrize("drawn", FAULTY, ids=lambda drawn: drawn.name)
def test_a_planted_fault_is_found_on_its_leg(drawn: Drawn) -> None:
    assert drawn.fault in [(one.code, one.row) for one in drawn.found()]


@pytest.mark.parametrize("drawn", GOOD, ids=lambda drawn: drawn.name)
def test_nothing_is_found_in_a_good_plan(drawn: Drawn) -> None:
    assert drawn.found() == []


def test_there_are_twenty_of_each() -> None:
    assert (len(GOOD), len(FAULTY)) == (20, 20)


def test_a_finding_says_by_how_much() -> None:
    (found,) = Drawn("", STRAIGHT, ground=hill(4500, 0, 900.0), bounds=Bounds(margin_ft=150.0)).found()
    assert found.params == {"height_ft": pytest.approx(100.0, abs=40.0), "margin_ft": 150.0}
    (found,) = Drawn("", SQUARE, bounds=Bounds(endurance_s=180.0)).found()
    assert found.params == {"lasts_min": 3.0, "takes_min": pytest.approx(4.5, abs=0.5)}


def test_ground_that_nobody_knows_is_not_judged() -> None:
    assert Drawn("", STRAIGHT, ground=lambda *_: None, bounds=Bounds(margin_ft=500.0)).found() == []


def test_a_flight_that_never_climbs_away_is_low_on_every_leg_and_a_take_off_on_none() -> None:
    bounds = Bounds(margin_ft=150.0)
    assert Drawn("", STRAIGHT, RUNWAY, bounds=bounds).found() == []
    low = plan((0, 0, 100), (3000, 0, 100), (6000, 0, 1000))
    assert [(one.code, one.row) for one in Drawn("", low, RUNWAY, bounds=bounds).found()] == [
        ("low_ground", 0),
        ("low_ground", 1),
        ("low_ground", 2),
    ]


def test_an_aircraft_that_climbed_away_and_comes_down_again_is_warned_of_on_the_first_leg_too() -> None:
    down = plan((0, 0, 100), (3000, 0, 1000))
    found = Drawn("", down, at(-6000, 0, 1000.0), bounds=Bounds(margin_ft=150.0)).found()
    assert ("low_ground", 0) in [(one.code, one.row) for one in found]


def test_a_leg_that_is_not_flown_any_more_is_not_judged() -> None:
    one_way = next(drawn for drawn in FAULTY if drawn.name == "one leg against the wind")
    behind = replace(one_way, bounds=Bounds(endurance_s=1e6))
    assert {one.row for one in behind.found()} == {3}
