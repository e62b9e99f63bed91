"""How old is too old, and how often something comes."""

from __future__ import annotations

import re

import pytest

from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.vehicle.health import TASK_OF_TOPIC, TopicHealth
from epf_gcs.vehicle.wanted import RATE_COMMANDS


def _heard_every(period_s: float, samples: int) -> TopicHealth:
    health = TopicHealth()
    for index in range(samples):
        health.heard(100.0 + index * period_s, ())
    return health


def test_nothing_heard_has_no_rate_and_no_age() -> None:
    health = TopicHealth()
    assert (health.count, health.last_s, health.rate_hz(5.0), health.stale_after_s(None)) == (0, None, 0.0, None)


def test_three_periods_of_the_measured_stream_are_too_old() -> None:
    assert _heard_every(0.5, 10).stale_after_s(0.1) == pytest.approx(1.5)


def test_the_commanded_period_counts_until_enough_was_measured() -> None:
    assert _heard_every(0.1, 3).stale_after_s(2.0) == pytest.approx(6.0)


def test_a_fast_stream_may_jitter() -> None:
    assert _heard_every(0.02, 10).stale_after_s(0.02) == pytest.approx(0.2)


def test_one_late_sample_changes_nothing() -> None:
    health = _heard_every(0.1, 10)
    health.heard(105.0, ())
    assert health.stale_after_s(None) == pytest.approx(0.3)


def test_a_changed_rate_is_followed() -> None:
    health = _heard_every(0.1, 500)
    for index in range(10):
        health.heard(150.0 + index, ())
    assert health.stale_after_s(None) == pytest.approx(3.0)


def test_a_commanded_change_is_believed_at_once() -> None:
    health = _heard_every(0.1, 10)
    health.forget_rate()
    assert health.stale_after_s(10.0) == pytest.approx(30.0)


def test_a_stream_that_stopped_has_no_rate() -> None:
    health = _heard_every(0.1, 10)
    assert health.rate_hz(101.0) == pytest.approx(10.0)
    assert health.rate_hz(103.0) == 0.0


def test_implausible_values_are_counted_by_name() -> None:
    health = TopicHealth()
    health.heard(1.0, ("yaw_deg",))
    health.heard(2.0, ("yaw_deg", "roll_deg"))
    assert health.implausible == {"yaw_deg": 2, "roll_deg": 1}


def test_samples_of_one_moment_have_no_rate() -> None:
    assert _heard_every(0.0, 10).rate_hz(100.0) == 0.0


def test_a_rate_holds_for_three_periods_and_at_least_a_fifth_of_a_second() -> None:
    slow, fast = _heard_every(0.5, 10), _heard_every(0.02, 10)
    assert slow.last_s == 104.5
    assert fast.last_s == pytest.approx(100.18)
    assert slow.rate_hz(105.9) == pytest.approx(2.0)
    assert slow.rate_hz(106.1) == 0.0
    assert fast.rate_hz(100.37) == pytest.approx(50.0)
    assert fast.rate_hz(100.39) == 0.0


def test_the_commanded_period_gives_way_to_five_measured_intervals() -> None:
    assert _heard_every(0.1, 5).period_s(2.0) == 2.0
    assert _heard_every(0.1, 6).period_s(2.0) == pytest.approx(0.1)
    assert _heard_every(0.1, 2).period_s(None) == pytest.approx(0.1)
    assert _heard_every(0.1, 1).period_s(None) is None


def test_a_state_that_was_kept_goes_on_with_its_rate_and_its_counts() -> None:
    health = _heard_every(0.1, 10)
    health.heard(101.0, ("yaw_deg",))
    again = TopicHealth.restored(*health.kept())
    assert (again.count, again.last_s, again.implausible) == (11, 101.0, {"yaw_deg": 1})
    assert again.rate_hz(101.0) == pytest.approx(10.0)


@pytest.mark.parametrize("command", RATE_COMMANDS)
def test_each_topic_belongs_to_the_task_that_sends_it_as_the_protocol_says(command: str) -> None:
    said = COMMANDS[command].doc.removeprefix("Period of the task that sends ").removesuffix(".")
    sent = {topic for topic, of_task in TASK_OF_TOPIC.items() if of_task == command}
    assert sent == set(re.split(", | and ", said))


def test_what_was_kept_is_not_changed_by_what_comes_later() -> None:
    health = _heard_every(0.1, 3)
    kept = health.kept()
    health.heard(105.0, ("yaw_deg",))
    count, last_s, intervals, implausible = kept
    assert (count, len(intervals), implausible) == (3, 2, {})
    assert last_s == pytest.approx(100.2)
