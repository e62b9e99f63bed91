"""The time of the loop, where nothing is numbered and some is lost."""

from __future__ import annotations

import pytest

from epf_gcs.vehicle.round_trip import RoundTrip


def _fly(trip: RoundTrip, frames: int, delay_s: float, *, lost: frozenset[int] = frozenset()) -> None:
    """50 Hz, each answered after the delay, but for the lost ones."""
    events: list[tuple[float, bool]] = []
    for index in range(frames):
        events.append((index * 0.02, True))
        if index not in lost:
            events.append((index * 0.02 + delay_s, False))
    for at_s, asked in sorted(events):
        (trip.asked if asked else trip.answered)(at_s)


@pytest.mark.parametrize("delay_s", [0.001, 0.035, 0.15])
def test_the_delay_is_found_also_where_several_are_under_way(delay_s: float) -> None:
    trip = RoundTrip()
    _fly(trip, 200, delay_s)
    summary = trip.summary()
    assert summary.p50 == pytest.approx(delay_s * 1000)
    assert summary.newest == pytest.approx(delay_s * 1000)


def test_lost_frames_do_not_shift_the_others() -> None:
    trip = RoundTrip()
    _fly(trip, 400, 0.035, lost=frozenset({50, 51, 120, 260}))
    assert trip.summary().p50 == pytest.approx(35.0)
    assert trip.summary().newest == pytest.approx(35.0)


def test_before_the_first_answer_there_is_nothing() -> None:
    trip = RoundTrip()
    trip.asked(1.0)
    assert trip.summary().newest is None


def test_an_answer_to_nothing_is_no_time() -> None:
    trip = RoundTrip()
    trip.answered(1.0)
    assert trip.summary().newest is None


def test_what_was_asked_long_ago_is_not_answered_any_more() -> None:
    trip = RoundTrip()
    trip.asked(1.0)
    trip.asked(9.0)
    trip.answered(9.01)
    assert trip.summary().newest == pytest.approx(10.0)


def test_a_new_loop_begins_with_nothing() -> None:
    trip = RoundTrip()
    _fly(trip, 50, 0.035)
    trip.clear()
    assert trip.summary().p50 is None


def test_the_slowest_hundredth_is_seen() -> None:
    trip = RoundTrip()
    for index in range(100):
        trip.asked(float(index))
        trip.answered(index + (0.2 if index >= 98 else 0.01))
    assert trip.summary().p50 == pytest.approx(10.0)
    assert trip.summary().p99 == pytest.approx(200.0)


def test_the_newest_answer_is_the_last_ones_time_and_none_before_the_first() -> None:
    trip = RoundTrip()
    assert trip.newest_ms is None
    for index, delay_s in enumerate((0.01, 0.02, 0.03, 0.04)):
        trip.asked(float(index))
        trip.answered(index + delay_s)
        assert trip.newest_ms == pytest.approx(delay_s * 1000)
    assert trip.answers == 4
    trip.clear()
    assert (trip.newest_ms, trip.answers) == (None, 0)


def test_a_question_is_open_for_half_a_second() -> None:
    trip = RoundTrip()
    trip.asked(1.0)
    trip.answered(1.49)
    assert trip.newest_ms == pytest.approx(490.0)
    trip.asked(2.0)
    trip.answered(2.51)
    assert trip.newest_ms == pytest.approx(490.0)
    assert trip.answers == 1


def test_after_a_new_loop_the_silence_before_it_loses_no_question() -> None:
    trip = RoundTrip()
    _fly(trip, 50, 0.035)
    trip.clear()
    trip.asked(10.0)
    trip.asked(10.02)
    trip.answered(10.035)
    assert trip.newest_ms == pytest.approx(35.0)


def test_the_median_and_the_slowest_hundredth_are_found_in_whatever_order_answers_came() -> None:
    trip = RoundTrip()
    for index in range(101):
        trip.asked(float(index))
        trip.answered(index + 0.001 * (1 + index * 37 % 101))
    assert trip.summary().p50 == pytest.approx(51.0)
    assert trip.summary().p99 == pytest.approx(100.0)


def test_the_newest_512_answers_count_and_no_other() -> None:
    trip = RoundTrip()
    for index in range(1112):
        trip.asked(float(index))
        trip.answered(index + (0.2 if index < 600 else 0.01))
        if index == 604:
            assert trip.summary().p99 == pytest.approx(200.0)
    assert trip.summary().p99 == pytest.approx(10.0)
    assert trip.answers == 1112


def test_an_answer_after_a_long_gap_is_to_the_newest_question_however_many_were_lost() -> None:
    trip = RoundTrip()
    for asked_s in (0.0, 0.02):
        trip.asked(asked_s)
        trip.answered(asked_s + 0.01)
    trip.asked(0.04)
    trip.answered(0.11)
    assert trip.answers == 3
    assert trip.newest_ms == pytest.approx(70.0)


def test_an_answer_to_a_question_of_the_loop_before_is_no_time() -> None:
    trip = RoundTrip()
    trip.asked(1.0)
    trip.clear()
    trip.answered(1.1)
    assert (trip.answers, trip.newest_ms) == (0, None)


def test_answers_in_a_pause_are_left_out_and_shift_nothing_after_it() -> None:
    trip = RoundTrip()
    events = sorted(
        [(index * 0.02, True) for index in range(400)] + [(index * 0.02 + 0.035, False) for index in range(400)]
    )
    for at_s, asked in events:
        if asked:
            trip.asked(at_s)
        else:
            trip.answered(at_s, is_counted=not 2.0 < at_s < 6.0)
    assert trip.answers == 200
    assert trip.summary().newest == pytest.approx(35.0)
    assert trip.summary().p99 == pytest.approx(35.0)
