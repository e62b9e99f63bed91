"""The flown track: every new place, in order, in pieces, and never too much of it."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.track.track import ATTITUDE, MAX_POINTS, POINT, UNKNOWN_HEADING, Position, Track

STEP_DEG = 0.0001


def place(step: float) -> Position:
    """Eleven metres further north with each step."""
    return (27.0 + STEP_DEG * step, -15.0, 300.0)


def flown(steps: int, max_points: int = 1000, *, start_s: float = 0.0) -> Track:
    track = Track(0.0, 7, max_points, block_points=2)
    for step in range(steps):
        track.add(start_s + step, place(step))
    return track


def points(track: Track, after: int = 0) -> list[Position]:
    """All positions as they are packed."""
    return [
        (latitude / 1e7, longitude / 1e7, altitude / 1e3)
        for block in track.blocks(after)
        for _, latitude, longitude, altitude in np.frombuffer(block.points, POINT).tolist()
    ]


def lines(track: Track, since_s: float = 0.0) -> list[list[Position]]:
    everything = points(track)
    return [everything[start:end] for start, end in track.spans(since_s)]


def test_every_new_place_is_kept_and_the_same_again_is_not() -> None:
    track = flown(3)
    track.add(3.0, place(2))
    assert lines(track) == [[place(0), place(1), place(2)]]
    track.add(4.0, (*place(2)[:2], 301.0))
    assert len(track) == 4


def test_nothing_and_a_single_place_are_no_line() -> None:
    assert lines(Track()) == []
    assert lines(flown(1)) == []


def test_a_jump_or_a_long_silence_begins_a_new_piece() -> None:
    track = flown(2)
    track.add(2.0, (28.0, -15.0, 300.0))
    track.add(3.0, (28.0001, -15.0, 300.0))
    track.add(60.0, (28.0002, -15.0, 300.0))
    track.add(61.0, (28.0003, -15.0, 300.0))
    assert [len(line) for line in lines(track)] == [2, 2, 2]


def test_the_date_line_is_no_jump() -> None:
    track = Track()
    track.add(0.0, (0.0, 179.9999, 300.0))
    track.add(1.0, (0.0, -179.9999, 300.0))
    assert [len(line) for line in lines(track)] == [2]


def test_a_fast_aircraft_that_is_seldom_heard_does_not_jump() -> None:
    track = Track()
    track.add(0.0, (27.0, -15.0, 300.0))
    track.add(9.0, (27.02, -15.0, 300.0))
    assert [len(line) for line in lines(track)] == [2]


@given(st.integers(2, 400), st.integers(10, 60))
def test_memory_is_bounded_and_the_newest_points_are_all_there(steps: int, max_points: int) -> None:
    track = flown(steps, max_points)
    assert len(track) <= max_points
    (line,) = lines(track)
    assert line[-1] == place(steps - 1)
    newest = min(steps, max_points // 4)
    assert line[-newest:] == [place(step) for step in range(steps - newest, steps)]
    assert line == sorted(line)
    assert line[0] == place(0), "the beginning of the flight stays"


@given(st.lists(st.integers(1, 30), min_size=1, max_size=12), st.integers(10, 60))
def test_thinning_never_joins_what_was_apart(pieces: list[int], max_points: int) -> None:
    track = Track(max_points=max_points, block_points=2)
    for number, length in enumerate(pieces):
        for step in range(length):
            track.add(100.0 * number + step, (27.0 + number + STEP_DEG * step, -15.0, 300.0))
    for line in lines(track):
        assert len({int(position[0]) for position in line}) == 1


def test_only_what_was_flown_since_is_given() -> None:
    assert lines(flown(10), since_s=6.0) == [[place(6), place(7), place(8), place(9)]]
    assert lines(flown(10), since_s=9.0) == []


def test_a_later_track_comes_behind_as_a_piece_of_its_own() -> None:
    track = flown(3)
    track.append(flown(4, start_s=10.0))
    assert [len(line) for line in lines(track)] == [3, 4]
    track.append(Track())
    assert len(track) == 7


@given(st.integers(0, 120), st.integers(0, 120))
def test_two_tracks_together_are_bounded_too(first: int, second: int) -> None:
    track = flown(first, 100)
    track.append(flown(second, 100, start_s=1000.0))
    assert len(track) <= 100


def test_what_is_being_read_stays_as_it_was() -> None:
    """A file of a long track is written while the aircraft flies on, and while the track is thinned."""
    track = flown(7, 10)
    blocks = track.blocks()
    for step in range(7, 25):
        track.add(float(step), place(step))
    read = np.concatenate([np.frombuffer(block.points, POINT) for block in blocks])
    assert [latitude / 1e7 for latitude in read["latitude_1e7deg"]] == [place(step)[0] for step in range(7)]


@given(st.integers(0, 40), st.integers(0, 50))
def test_who_has_some_points_gets_the_others(steps: int, after: int) -> None:
    assert points(flown(steps), after) == [place(step) for step in range(after, steps)]


@pytest.mark.uncounted
def test_four_hours_are_kept_and_the_newest_two_are_whole_after_the_first_thinning() -> None:
    track = Track(1000.0)
    for step in range(715_000):
        track.add(1000.0 + 0.02 * step, (27.0 + 1e-6 * step, -15.0, 300.0))
    assert len(track) == 715_000
    epoch = track.epoch
    for step in range(715_000, MAX_POINTS):
        track.add(1000.0 + 0.02 * step, (27.0 + 1e-6 * step, -15.0, 300.0))
    assert 540_000 < len(track) < 550_000
    assert track.epoch != epoch
    times = np.concatenate([np.frombuffer(block.points, POINT)["t_ms"] for block in track.blocks()])
    assert np.diff(times[-360_000:]).tolist() == [20] * 359_999
    assert set(np.diff(times[:100_000]).tolist()) == {40}


def test_indices_that_were_given_out_hold_until_the_epoch_changes() -> None:
    track = flown(8, 10)
    assert track.epoch == 7
    for step in range(8, 10):
        track.add(float(step), place(step))
    assert (track.epoch, len(track)) == (8, 8), "it was thinned"
    track.append(flown(1, start_s=20.0))
    assert track.epoch == 9


def test_times_count_from_the_tracks_own_beginning_also_of_what_is_put_behind() -> None:
    track, later = Track(1000.0, block_points=2), Track(1600.0, block_points=2)
    for step in range(3):
        track.add(1000.5 + step, place(step))
        later.add(1600.25 + step, place(step + 10))
    track.append(later)
    times = [t for block in track.blocks() for t in np.frombuffer(block.points, POINT)["t_ms"].tolist()]
    assert times == [500, 1500, 2500, 600_250, 601_250, 602_250]
    assert track.spans(1601.0) == [(4, 6)]


@pytest.mark.parametrize(
    ("attitude", "packed"),
    [
        ((359.999, 0.0, 0.0), (0, 0, 0)),
        ((-0.5, 12.34, -45.678), (35950, 1234, -4568)),
        ((90.0, -89.99, 179.99), (9000, -8999, 17999)),
        ((90.0, 0.0, 180.0), (9000, 0, -18000)),
        (None, (UNKNOWN_HEADING, 0, 0)),
    ],
)
def test_attitudes_are_kept_to_a_hundredth_of_a_degree(
    attitude: tuple[float, float, float] | None, packed: tuple[int, int, int]
) -> None:
    track = Track()
    track.add(0.0, place(0), attitude)
    assert np.frombuffer(track.blocks()[0].attitudes, ATTITUDE).tolist() == [packed]


def test_a_number_that_no_track_can_hold_does_not_end_the_flight() -> None:
    track = Track(0.0)
    track.add(1e9, (27.0, -15.0, 9e9))
    assert np.frombuffer(track.blocks()[0].points, POINT).tolist() == [(0xFFFFFFFF, 270000000, -150000000, 0x7FFFFFFF)]
