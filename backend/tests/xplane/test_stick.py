"""How long a sample of a far-away stick is flown by, and what flies after it."""

from __future__ import annotations

from typing import Any

import pytest

from epf_gcs.xplane.datagram import Surfaces
from epf_gcs.xplane.stick import SAMPLE_LASTS_S, THROTTLE_LASTS_S, GamepadInput, read_sample

TURN = Surfaces(0.25, -0.5, 0.125, 0.75)
LET_GO = Surfaces(0.0, 0.0, 0.0, 0.75)
NOBODY = Surfaces(0.0, 0.0, 0.0, 0.0)
# The sender's clock began at another time than ours.
AHEAD_S = 5000.0


def test_before_the_first_sample_the_stick_is_let_go_and_the_throttle_closed() -> None:
    hand = GamepadInput()
    assert not hand.is_live(0.0)
    assert hand.position(0.0) == NOBODY


def test_a_sample_is_flown_by_until_it_is_old_then_the_surfaces_are_centred_and_at_last_the_throttle_is_closed() -> (
    None
):
    hand = GamepadInput()
    assert hand.take(TURN, 100.0 + AHEAD_S, 100.0)
    assert hand.position(100.0 + SAMPLE_LASTS_S - 0.01) == TURN
    assert hand.position(100.0 + SAMPLE_LASTS_S + 0.01) == LET_GO
    assert hand.position(100.0 + THROTTLE_LASTS_S - 0.01) == LET_GO
    assert hand.position(100.0 + THROTTLE_LASTS_S + 0.01) == NOBODY


def test_samples_that_return_count_again() -> None:
    hand = GamepadInput()
    hand.take(TURN, 100.0, 100.0)
    assert not hand.is_live(110.0)
    assert hand.take(TURN, 110.0, 110.0)
    assert hand.position(110.0) == TURN


def test_what_was_held_up_by_the_line_is_not_used_and_what_follows_it_in_time_is() -> None:
    hand = GamepadInput()
    hand.take(LET_GO, 100.0 + AHEAD_S, 100.0)
    for sent_s in (100.02, 100.5, 101.6):
        assert not hand.take(TURN, sent_s + AHEAD_S, 102.0)
    assert not hand.is_live(102.0)
    assert hand.take(TURN, 101.9 + AHEAD_S, 102.0)
    assert hand.position(102.0) == TURN


def test_the_age_of_a_sample_counts_from_where_it_was_taken() -> None:
    hand = GamepadInput()
    hand.take(LET_GO, 100.0, 100.0)
    hand.take(TURN, 100.1, 100.3)
    assert hand.is_live(100.1 + SAMPLE_LASTS_S - 0.01)
    assert not hand.is_live(100.1 + SAMPLE_LASTS_S + 0.01)


@pytest.mark.parametrize("drift", [-1e-4, 1e-4])
def test_two_clocks_that_drift_apart_make_no_sample_late_in_hours(drift: float) -> None:
    hand = GamepadInput()
    assert all(hand.take(TURN, s * (1.0 + drift), float(s)) for s in range(4 * 3600))
    assert hand.is_live(4 * 3600 - 1 + SAMPLE_LASTS_S - 0.05)


def test_a_sender_that_is_gone_is_let_go_at_once_and_may_come_back_with_another_clock() -> None:
    hand = GamepadInput()
    hand.take(TURN, 100.0, 100.0)
    hand.let_go()
    assert hand.position(100.01) == LET_GO
    assert hand.take(TURN, 3.0, 101.0)
    assert hand.position(101.0) == TURN


SENT: dict[str, Any] = {"elevator": 0.25, "aileron": -0.5, "rudder": 0.125, "throttle": 0.75, "t_ms": 5500.0}


def test_a_sample_is_read_as_its_sender_means_it_clamped_and_in_seconds() -> None:
    assert read_sample(SENT) == (TURN, 5.5)
    assert read_sample({**SENT, "t_ms": -250}) == (TURN, -0.25), "clocks of pages may begin anywhere"
    beyond = {"elevator": 2, "aileron": -3, "rudder": 1.5, "throttle": -1, "t_ms": 0}
    assert read_sample(beyond) == (Surfaces(1.0, -1.0, 1.0, 0.0), 0.0)


@pytest.mark.parametrize("name", SENT)
@pytest.mark.parametrize("wrong", [None, True, "0.5", [0.5], float("nan"), float("inf"), -float("inf")])
def test_a_sample_with_a_field_that_is_no_finite_number_is_none(name: str, wrong: object) -> None:
    assert read_sample({**SENT, name: wrong}) is None
    assert read_sample({field: value for field, value in SENT.items() if field != name}) is None


def test_a_time_that_no_clock_can_have_is_no_sample() -> None:
    for t_ms in (1e15, -1e15, 1e300):
        assert read_sample({**SENT, "t_ms": t_ms}) is None
