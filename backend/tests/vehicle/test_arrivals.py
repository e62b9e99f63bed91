"""How often and how evenly messages come."""

from __future__ import annotations

from statistics import pstdev

import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.vehicle.arrivals import Arrivals


def heard(*times_s: float) -> Arrivals:
    arrivals = Arrivals()
    for t_s in times_s:
        arrivals.heard(t_s, {"at": t_s})
    return arrivals


def evenly(count: int, period_s: float, start_s: float = 100.0) -> list[float]:
    return [start_s + place * period_s for place in range(count)]


def test_before_the_first_nothing_is_known() -> None:
    summary = Arrivals().summary(5.0)
    assert (summary.count, summary.rate_hz, summary.jitter_ms, summary.age_s) == (0, 0.0, None, None)
    assert Arrivals().last_s is None


def test_one_message_has_an_age_and_no_rate() -> None:
    arrivals = heard(4.0)
    summary = arrivals.summary(5.0)
    assert (summary.count, summary.rate_hz, summary.jitter_ms, summary.age_s) == (1, 0.0, None, 1.0)
    assert (arrivals.last_s, arrivals.values) == (4.0, {"at": 4.0})


@pytest.mark.parametrize("period_s", [0.02, 0.1, 1.0, 10.0])
def test_an_even_stream_has_its_rate_and_no_jitter(period_s: float) -> None:
    times_s = evenly(20, period_s)
    summary = heard(*times_s).summary(times_s[-1])
    assert summary.rate_hz == pytest.approx(1 / period_s)
    assert summary.jitter_ms == pytest.approx(0.0, abs=1e-6)


@given(st.lists(st.floats(0.015, 0.025), min_size=2, max_size=400))
def test_jitter_is_the_deviation_of_the_newest_256_intervals(intervals: list[float]) -> None:
    arrivals, t_s = heard(50.0), 50.0
    for interval in intervals:
        t_s += interval
        arrivals.heard(t_s, None)
    summary = arrivals.summary(t_s)
    assert summary.count == len(intervals) + 1
    assert summary.jitter_ms == pytest.approx(1000 * pstdev(intervals[-256:]), abs=1e-6)


def test_the_rate_is_of_the_last_seconds_and_not_of_the_whole_flight() -> None:
    slow = evenly(100, 0.1)
    fast = evenly(250, 0.02, slow[-1] + 0.02)
    assert heard(*slow, *fast).summary(fast[-1]).rate_hz == pytest.approx(50.0, rel=0.01)


def test_a_stream_that_stopped_has_no_rate_but_keeps_count_and_age() -> None:
    times_s = evenly(50, 0.02)
    summary = heard(*times_s).summary(times_s[-1] + 0.51)
    assert (summary.count, summary.rate_hz) == (50, 0.0)
    assert summary.age_s == pytest.approx(0.51)


def test_a_slow_stream_has_not_stopped_before_three_of_its_periods() -> None:
    times_s = evenly(5, 10.0)
    assert heard(*times_s).summary(times_s[-1] + 29).rate_hz == pytest.approx(0.1)
    assert heard(*times_s).summary(times_s[-1] + 31).rate_hz == 0.0


def test_a_pause_is_no_jitter() -> None:
    before = evenly(50, 0.02)
    after = evenly(20, 0.02, before[-1] + 600)
    summary = heard(*before, *after).summary(after[-1])
    assert summary.rate_hz == pytest.approx(50.0)
    assert summary.jitter_ms == pytest.approx(0.0, abs=1e-6)


def test_after_another_rate_was_commanded_the_old_one_does_not_count() -> None:
    arrivals = heard(*evenly(50, 0.02))
    last_s = arrivals.last_s
    assert last_s is not None
    arrivals.forget_rate()
    assert arrivals.last_s == last_s
    assert arrivals.summary(last_s).rate_hz == 0.0
    for t_s in evenly(10, 0.1, last_s + 0.1):
        arrivals.heard(t_s, None)
    assert arrivals.summary(last_s + 1.0).rate_hz == pytest.approx(10.0)


def test_a_copy_stays_as_it_was() -> None:
    arrivals = heard(*evenly(10, 0.1))
    before = arrivals.summary(102.0)
    same = arrivals.copy()
    arrivals.heard(101.5, {"at": 101.5})
    assert same.summary(102.0) == before
    assert same.last_s == pytest.approx(100.9)
    assert same.values == {"at": same.last_s}


@given(st.lists(st.floats(0, 1e6), max_size=300), st.floats(0, 1e6))
def test_no_times_make_it_raise_or_say_what_cannot_be(times_s: list[float], now_s: float) -> None:
    summary = heard(*sorted(times_s)).summary(now_s)
    assert summary.rate_hz >= 0
    assert summary.jitter_ms is None or summary.jitter_ms >= 0
    assert summary.age_s is None or summary.age_s >= 0


def test_a_single_interval_after_a_pause_has_no_jitter() -> None:
    two = heard(1.0, 1.1)
    assert two.summary(1.1).jitter_ms is None
    assert two.summary(1.1).rate_hz == pytest.approx(10.0)
    assert heard(*evenly(50, 0.02), 700.0, 700.02).summary(700.02).jitter_ms is None
    assert heard(1.0, 1.1, 1.2).summary(1.2).jitter_ms == pytest.approx(0.0, abs=1e-6)


def test_a_state_that_was_kept_goes_on_with_its_rate() -> None:
    arrivals = heard(*evenly(50, 0.02))
    last_s = arrivals.last_s
    assert last_s is not None
    again = Arrivals.restored(*arrivals.kept())
    assert again.summary(last_s).rate_hz == pytest.approx(50.0)
    assert (again.count, again.last_s, again.values) == (50, last_s, arrivals.values)
    assert len(arrivals.kept()[1]) == 9, "enough for a rate, and no more"


def test_what_came_before_the_newest_256_intervals_is_forgotten() -> None:
    uneven = [50.0, 50.01, 50.05, 50.06]
    arrivals = heard(*uneven, *evenly(257, 0.02, uneven[-1] + 0.02))
    assert arrivals.summary(60.0).jitter_ms == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize(
    ("period_s", "gap_s", "is_pause"), [(0.02, 0.9, False), (0.02, 1.1, True), (1.0, 9.0, False), (1.0, 11.0, True)]
)
def test_a_gap_is_a_pause_where_it_is_longer_than_a_second_and_than_ten_periods(
    period_s: float, gap_s: float, is_pause: bool
) -> None:
    before = evenly(20, period_s)
    after = evenly(20, period_s, before[-1] + gap_s)
    jitter_ms = heard(*before, *after).summary(after[-1]).jitter_ms
    assert jitter_ms is not None
    assert (jitter_ms < 1e-6) == is_pause
