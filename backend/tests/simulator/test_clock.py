"""The frame schedule."""

import random

import pytest

from epf_gcs.simulator.clock import Schedule


def test_small_delays_do_not_add_up() -> None:
    dice = random.Random(1)
    schedule = Schedule(0.02, 100.0)
    for _ in range(50_000):
        schedule.done(schedule.due_s + dice.random() * 0.019)
    assert schedule.due_s == pytest.approx(100.0 + 50_000 * 0.02, abs=1e-6)
    assert schedule.shifts == 0


def test_after_a_stall_the_schedule_shifts_and_no_burst_follows() -> None:
    schedule = Schedule(0.02, 0.0)
    schedule.done(0.0)
    schedule.done(1.0)
    assert schedule.shifts == 1
    assert schedule.due_s == pytest.approx(1.02)
    schedule.done(1.021)
    assert schedule.due_s == pytest.approx(1.04)


def test_a_frame_that_is_late_by_less_than_a_period_is_caught_up() -> None:
    schedule = Schedule(0.02, 0.0)
    schedule.done(0.0199)
    assert schedule.due_s == pytest.approx(0.02)
    assert schedule.shifts == 0
