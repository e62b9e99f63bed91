"""Bytes a second."""

from __future__ import annotations

import pytest

from epf_gcs.vehicle.rates import ByteRate


def test_a_steady_line_has_its_rate() -> None:
    rate = ByteRate()
    for tick in range(20):
        rate.note(tick * 0.5, tick * 500)
    assert rate.per_s() == pytest.approx(1000.0)


def test_two_looks_that_are_no_second_apart_give_the_rate_of_a_second() -> None:
    rate = ByteRate()
    rate.note(10.0, 0)
    rate.note(10.25, 1000)
    assert rate.per_s() == pytest.approx(4000.0)


def test_a_line_that_stopped_has_none_after_a_second() -> None:
    rate = ByteRate()
    for tick in range(4):
        rate.note(tick * 0.5, tick * 500)
    for tick in range(4, 8):
        rate.note(tick * 0.5, 1500)
    assert rate.per_s() == 0.0


def test_one_look_says_nothing() -> None:
    rate = ByteRate()
    assert rate.per_s() == 0.0
    rate.note(0.0, 5)
    rate.note(0.0, 9)
    assert rate.per_s() == 0.0


def test_what_came_more_than_a_second_ago_does_not_count_and_all_that_came_since_does() -> None:
    rate = ByteRate()
    seen = []
    for now_s, total in ((0.0, 0), (0.5, 4000), (1.0, 4000), (1.5, 5000), (2.0, 5000)):
        rate.note(now_s, total)
        seen.append(rate.per_s())
    assert seen == [0.0, 8000.0, 4000.0, 1000.0, 1000.0]


def test_after_looks_that_were_far_apart_the_last_two_count() -> None:
    rate = ByteRate()
    for now_s, total in ((0.0, 0), (5.0, 9000), (10.0, 9000)):
        rate.note(now_s, total)
    assert rate.per_s() == 0.0


def test_a_rate_that_was_kept_goes_on() -> None:
    rate, again = ByteRate(), ByteRate()
    rate.note(0.0, 0)
    rate.note(0.5, 1000)
    again.restore(rate.kept())
    rate.note(0.75, 2500)
    assert again.per_s() == pytest.approx(2000.0), "on its own"
    again.note(1.0, 3000)
    assert again.per_s() == pytest.approx(3000.0)
