"""Step responses of the autopilot on the rc aircraft at 55 kt, within a fifth of the reference figures."""

from collections.abc import Iterator

import pytest

from board_tests.closed_loop.manoeuvres import (
    CLIMB,
    CRUISE_FT,
    CRUISE_KT,
    FASTER,
    STRAIGHT_ON,
    TURN,
    climb_error_ft,
    cruise,
    speed_error_kt,
    step,
    turn_error_deg,
)
from board_tests.closed_loop.reference import (
    CLIMB_OVERSHOOT_FT,
    CLIMB_SETTLING_S,
    FASTER_SETTLING_S,
    SETTLED_DEG,
    SETTLED_FT,
    SETTLED_KT,
    TURN_SETTLING_S,
    WITHIN,
)
from epf_gcs.lab.closed_loop import ClosedLoop
from epf_gcs.lab.figures import settling_s


@pytest.fixture
def steady() -> Iterator[ClosedLoop]:
    with cruise() as loop:
        now = loop.samples[-1]
        assert now.waypoint == STRAIGHT_ON
        assert now.state.altitude_ft == pytest.approx(CRUISE_FT, abs=3.0)
        assert now.state.airspeed_indicated_kt == pytest.approx(CRUISE_KT, abs=0.2)
        yield loop


def test_300_ft_up(steady: ClosedLoop) -> None:
    samples = step(steady, CLIMB, 90.0)
    assert samples[-1].waypoint == CLIMB
    assert climb_error_ft(samples[0]) == pytest.approx(-300.0, abs=5.0)
    assert settling_s(samples, climb_error_ft, SETTLED_FT) <= CLIMB_SETTLING_S * WITHIN
    assert max(map(climb_error_ft, samples)) <= CLIMB_OVERSHOOT_FT * WITHIN
    assert abs(climb_error_ft(samples[-1])) < 5.0


def test_90_degrees_to_the_right(steady: ClosedLoop) -> None:
    samples = step(steady, TURN, 60.0)
    assert samples[-1].waypoint == TURN
    assert turn_error_deg(samples[0]) == pytest.approx(-90.0, abs=5.0)
    assert settling_s(samples, turn_error_deg, SETTLED_DEG) <= TURN_SETTLING_S * WITHIN
    assert max(map(turn_error_deg, samples)) <= 0.0
    # The turn is flown with the full bank and no more, and costs no altitude to speak of.
    assert max(sample.state.roll_deg for sample in samples) == pytest.approx(30.0, abs=3.0)
    assert min(sample.state.altitude_ft for sample in samples) > CRUISE_FT - 60.0


def test_15_percent_faster(steady: ClosedLoop) -> None:
    samples = step(steady, FASTER, 60.0)
    assert samples[-1].waypoint == FASTER
    assert speed_error_kt(samples[0]) == pytest.approx(-0.15 * CRUISE_KT, abs=0.5)
    assert settling_s(samples, speed_error_kt, SETTLED_KT) <= FASTER_SETTLING_S * WITHIN
    assert max(map(speed_error_kt, samples)) < SETTLED_KT
    assert all(abs(sample.state.altitude_ft - CRUISE_FT) < 40.0 for sample in samples)
