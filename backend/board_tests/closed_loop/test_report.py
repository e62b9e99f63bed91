"""The report's figures of flights that the board's own laws flew are those that are read off their samples."""

from __future__ import annotations

import pytest

from board_tests.closed_loop.report_flights import fly_steps
from epf_gcs.simulator.situation import Situation, Turbulence

WITHIN = 0.05


@pytest.mark.parametrize("seed", [1, 2])
def test_rise_overshoot_and_error_of_every_step_are_those_of_its_samples(seed: int) -> None:
    for truth, one in fly_steps(seed).pairs():
        assert one is not None, truth
        assert one.size == pytest.approx(truth.size, rel=WITHIN)
        assert one.rise_s == pytest.approx(truth.rise_s, rel=WITHIN), truth
        if one.overshoot_percent is not None:
            assert one.overshoot_percent == pytest.approx(truth.overshoot_percent, abs=100 * WITHIN), truth
        assert one.is_cut or one.steady_error == pytest.approx(truth.end_error, abs=WITHIN * truth.size), truth
        assert one.is_cut or one.overshoot_percent is not None


def test_in_turbulence_too_nothing_is_told_that_was_not_flown() -> None:
    told = 0
    for truth, one in fly_steps(3, Situation(turbulence=Turbulence.LIGHT)).pairs():
        assert one is not None, truth
        if one.rise_s is not None and truth.rise_s is not None:
            assert one.rise_s == pytest.approx(truth.rise_s, rel=0.25), truth
            told += 1
        assert one.is_cut or one.steady_error == pytest.approx(truth.end_error, abs=WITHIN * truth.size), truth
    assert told >= 4
