"""Signals are thinned without losing an extreme."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.flights.signals import gaps_of, thin, usual_period_s

TWO_HOURS = np.arange(360_000, dtype=np.float64) * 0.02


@given(
    spike=st.integers(0, len(TWO_HOURS) - 1),
    points=st.integers(10, 3000),
    zoom=st.floats(0, 1),
    up=st.booleans(),
)
def test_a_spike_of_one_sample_is_seen_at_every_zoom(spike: int, points: int, zoom: float, up: bool) -> None:
    values = np.sin(TWO_HOURS)
    values[spike] = 50.0 if up else -50.0
    at_s = TWO_HOURS[spike]
    from_s, to_s = at_s * zoom, at_s + (TWO_HOURS[-1] - at_s) * zoom
    found = thin(TWO_HOURS, values, from_s, to_s, points, 0.02)
    assert len(found.at_s) <= points
    place = int(np.argmax(found.high if up else -found.low))
    assert (found.high if up else found.low)[place] == values[spike]
    assert abs(found.at_s[place] - at_s) <= (to_s - from_s) / points + 0.02


def test_few_samples_are_given_as_they_are() -> None:
    t_s, values = np.array([0.0, 1.0, 2.0]), np.array([5.0, np.nan, 7.0])
    found = thin(t_s, values, 0.0, 2.0, 10, None)
    assert found.at_s.tolist() == [0.0, 1.0, 2.0]
    np.testing.assert_array_equal(found.low, values)
    np.testing.assert_array_equal(found.high, values)
    assert (found.mean, found.known) == (6.0, 2)


def test_a_value_that_the_board_did_not_have_hides_no_other_in_its_step() -> None:
    t_s = np.arange(1000, dtype=np.float64) * 0.1
    values = np.full(1000, np.nan)
    values[501] = 3.0
    found = thin(t_s, values, 0.0, 100.0, 10, 0.1)
    assert np.nanmax(found.high) == np.nanmin(found.low) == 3.0
    assert np.count_nonzero(np.isfinite(found.high)) == 1
    assert (found.mean, found.known) == (3.0, 1)


def test_a_gap_breaks_the_line_however_many_points_are_drawn() -> None:
    t_s = np.concatenate((np.arange(500, dtype=np.float64) * 0.1, 100.0 + np.arange(500, dtype=np.float64) * 0.1))
    for points in (50, 5000):
        found = thin(t_s, np.ones(1000), 0.0, 150.0, points, usual_period_s(t_s))
        (place,) = np.flatnonzero(np.isnan(found.low))
        assert 49.9 < found.at_s[place] < 100.0
        assert np.all(np.diff(found.at_s) > 0)
    assert gaps_of(t_s, usual_period_s(t_s)) == [(49.900000000000006, 100.0)]


def test_the_mean_is_that_of_the_stretch_and_not_of_the_steps() -> None:
    t_s = np.concatenate((np.arange(900, dtype=np.float64) * 0.01, 9.0 + np.arange(10)))
    values = np.concatenate((np.zeros(900), np.ones(10)))
    assert thin(t_s, values, 0.0, 20.0, 10, None).mean == 10 / 910
    assert thin(t_s, values, 9.0, 20.0, 10, None).mean == 1.0


def test_a_stretch_without_samples_is_empty() -> None:
    found = thin(TWO_HOURS, np.sin(TWO_HOURS), 8000.0, 9000.0, 100, 0.02)
    assert (len(found.at_s), found.mean, found.known) == (0, None, 0)
