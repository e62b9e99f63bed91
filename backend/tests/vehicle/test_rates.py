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
