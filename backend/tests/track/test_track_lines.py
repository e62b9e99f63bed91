"""The lines of a track as they are read from its blocks: all points, or fewer, whatever becomes of the track."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.track.track import Track
from epf_gcs.track.track_lines import lines_of

STEP_DEG = 0.0001


def flown(steps: int, start_s: float = 1000.0) -> Track:
    track = Track(1000.0, 1, 10_000, block_points=4)
    for step in range(steps):
        attitude = (step % 360.0, 1.5, -2.25) if step % 2 else None
        track.add(start_s + step, (27.0 + STEP_DEG * step, -15.0, 300.0 + step), attitude)
    return track


@given(st.integers(2, 60))
def test_every_point_comes_with_its_time_and_attitude(steps: int) -> None:
    (line,) = lines_of(flown(steps))
    parts = list(line)
    assert [t for part in parts for t in part.t_s] == [1000.0 + step for step in range(steps)]
    assert [a for part in parts for a in part.altitude_m] == [300.0 + step for step in range(steps)]
    headings = [heading for part in parts for heading in part.heading_deg]
    assert [None if math.isnan(heading) else heading for heading in headings] == [
        float(step) if step % 2 else None for step in range(steps)
    ]
    assert [roll for part in parts for roll in part.roll_deg if not math.isnan(roll)] == [-2.25] * (steps // 2)
    assert list(line.positions())[-1] == pytest.approx((27.0 + STEP_DEG * (steps - 1), -15.0, 299.0 + steps))
    assert line.span_s() == (1000.0, 999.0 + steps)
    assert line.last().t_s.tolist() == [999.0 + steps]


@given(st.integers(2, 300), st.integers(2, 50))
def test_fewer_points_are_spread_evenly_and_end_with_the_newest(steps: int, most: int) -> None:
    (line,) = lines_of(flown(steps), most)
    times = [t for part in line for t in part.t_s]
    assert 2 <= len(times) <= most + 1
    assert times[-1] == 999.0 + steps
    assert line.span_s() == (times[0], times[-1])
    assert len({round(second - first) for first, second in pairwise(times)}) == 1


def test_only_what_was_flown_since_is_read() -> None:
    (line,) = lines_of(flown(20), since_s=1013.0)
    assert [t for part in line for t in part.t_s] == [1013.0 + step for step in range(7)]
    assert lines_of(flown(10), since_s=1009.0) == []


def test_a_line_stays_as_it_was_while_the_aircraft_flies_on() -> None:
    track = flown(7)
    (line,) = lines_of(track)
    for step in range(7, 30):
        track.add(1000.0 + step, (27.0 + STEP_DEG * step, -15.0, 300.0))
    assert sum(len(part.t_s) for part in line) == 7
