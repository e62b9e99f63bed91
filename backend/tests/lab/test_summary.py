"""What a campaign's rows come to, on rows made up so that the answer is known."""

from __future__ import annotations

import math
from dataclasses import asdict
from typing import Any

import pytest

from epf_gcs.lab.conditions import Conditions
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.rows import Row
from epf_gcs.lab.summary import Share, compare, summary


def row(number: int, *, near_rms_m: float | None = 10.0, is_safe: bool = True, **others: Any) -> Row:
    return {
        "number": number,
        **asdict(Conditions()),
        "is_safe": is_safe,
        "near_rms_m": near_rms_m,
        "lost_by": None,
        "error": None,
        **others,
    }


def test_the_interval_of_a_share_is_wilsons() -> None:
    # By hand: 90 of 100.
    assert Share(90, 100).interval() == pytest.approx((0.8256, 0.9448), abs=1e-4)
    low, high = Share(100, 100).interval()
    assert low == pytest.approx(0.9630, abs=1e-4)
    assert high == 1.0
    assert math.isnan(Share(0, 0).share)
    assert Share(0, 0).interval() == (0.0, 1.0)


def test_the_condition_that_matters_comes_first() -> None:
    rows = [
        row(n, wind_kt=float(n), mass_factor=1.0 + 0.001 * (n * 7 % 30), near_rms_m=2.0 * n, is_safe=n < 20)
        for n in range(30)
    ]
    found = summary(rows)
    assert (found.flights, found.safe) == (30, Share(20, 30))
    assert [effect.name for effect in found.effects] == ["wind_kt", "mass_factor"]
    wind = found.effects[0]
    assert wind.correlation > 0.95
    assert (wind.low, wind.high) == (Share(10, 10), Share(0, 10))
    assert abs(found.effects[1].correlation) < 0.4


def test_a_flight_that_could_not_be_flown_is_neither_safe_nor_unsafe() -> None:
    found = summary([row(0), row(1, is_safe=False, near_rms_m=None, error="no such thing")])
    assert (found.flights, found.not_flown, found.safe) == (2, 1, Share(1, 1))


def test_the_worst_are_the_lost_then_the_unsafe_then_those_far_off() -> None:
    rows = [
        row(0),
        row(1, near_rms_m=99.0),
        row(2, is_safe=False, near_rms_m=1.0),
        row(3, is_safe=False, near_rms_m=5.0, lost_by="the nose touched the ground"),
    ]
    assert [one["number"] for one in summary(rows).worst] == [3, 2, 1, 0]


def test_two_campaigns_are_compared_flight_by_flight() -> None:
    before = [row(n, near_rms_m=40.0 + n, is_safe=n > 5) for n in range(20)]
    after = [row(n, near_rms_m=30.0 + n + 0.1 * (n % 2)) for n in range(20)]
    found = compare(before, after)
    assert (found.pairs, found.better, found.worse) == (20, 6, 0)
    assert found.by_chance == pytest.approx(2 / 2**6)
    assert found.change == pytest.approx(-9.95)
    low, high = found.change_interval
    assert low < -9.95 < high < -9.9


def test_flights_in_other_conditions_are_not_compared() -> None:
    with pytest.raises(LabError, match="flight 1 was flown in other conditions"):
        compare([row(0), row(1)], [row(0), row(1, wind_kt=3.0)])
    with pytest.raises(LabError, match="no flight in common"):
        compare([row(0)], [row(1)])
