"""The board's own estimate over the Gando circuit, against the simulator's truth, through sensors that err.

The circuit is flown by the firmware's laws in lock-step; the estimator sees each of its frames (50 a second).
"""

import math

import pytest

from board_tests.closed_loop.circuit import LONGEST_S, Circuit
from board_tests.closed_loop.estimation import NO_GAP, Error, Gap, estimate_flight, root_mean_squares
from epf_gcs.lab.closed_loop import Sample

STRAIGHT = Gap(200.0, 210.0)
TURNING = Gap(60.0, 70.0)
RUBBISH = Gap(200.0, 210.0, rubbish=math.nan)
RECOVERED_AFTER_S = 5.0


@pytest.fixture
def flight(circuit: Circuit) -> list[Sample]:
    assert circuit.crashes == []
    return circuit.samples


def worst_tilt_deg(errors: list[Error], begin_s: float, end_s: float) -> float:
    part = [error.tilt_deg() for error in errors if begin_s <= error.time_s < end_s]
    assert len(part) > 10
    return max(part)


def worst_heading_deg(errors: list[Error], begin_s: float, end_s: float) -> float:
    part = [abs(error.heading_deg) for error in errors if begin_s <= error.time_s < end_s]
    assert len(part) > 10
    return max(part)


@pytest.mark.parametrize("seed", [1, 2])
def test_attitude_and_heading_stay_near_the_truth_over_the_whole_circuit(flight: list[Sample], seed: int) -> None:
    errors, refused = estimate_flight(flight, seed)
    figures = root_mean_squares(errors)
    assert refused == 0
    assert len(errors) > 25_000
    assert figures["pitch_deg"] < 2.0
    assert figures["roll_deg"] < 2.0
    assert figures["heading_deg"] < 4.0
    # The circuit has turns of 30 degrees of bank all along: none tilts the horizon.
    assert max(abs(sample.state.roll_deg) for sample in flight) > 25.0
    assert worst_tilt_deg(errors, 60.0, LONGEST_S) < 4.0


def test_altitude_climb_and_airspeed_stay_near_the_truth_over_the_whole_circuit(flight: list[Sample]) -> None:
    errors, _ = estimate_flight(flight, seed=1)
    figures = root_mean_squares(errors)
    assert figures["altitude_ft"] < 10.0
    assert figures["vvi_ft_min"] < 60.0
    assert figures["speed_kt"] < 1.0


@pytest.mark.parametrize(
    "gap",
    [
        pytest.param(STRAIGHT, id="in straight flight"),
        pytest.param(TURNING, id="while turning"),
        pytest.param(RUBBISH, id="as samples that are not finite"),
    ],
)
def test_ten_seconds_without_the_gyro_are_survived_and_recovered_from(flight: list[Sample], gap: Gap) -> None:
    errors, refused = estimate_flight(flight, seed=1, gap=gap)
    undisturbed, _ = estimate_flight(flight, seed=1, gap=NO_GAP)
    assert refused == (500 if gap.rubbish is not None else 0)

    # Gravity and compass carry it through.
    assert worst_tilt_deg(errors, gap.begin_s, gap.end_s) < 10.0
    assert worst_heading_deg(errors, gap.begin_s, gap.end_s) < 15.0

    # Soon after it nothing is left of it.
    recovered_s = gap.end_s + RECOVERED_AFTER_S
    assert worst_tilt_deg(errors, recovered_s, recovered_s + 60.0) < 4.0
    assert worst_heading_deg(errors, recovered_s, recovered_s + 60.0) < 6.0
    after = root_mean_squares([error for error in errors if error.time_s >= recovered_s])
    without_gap = root_mean_squares([error for error in undisturbed if error.time_s >= recovered_s])
    for figure in ("pitch_deg", "roll_deg", "heading_deg"):
        assert abs(after[figure] - without_gap[figure]) < 0.2
