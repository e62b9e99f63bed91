"""The flown track: every new place, in order, in pieces, and never too much of it."""

from __future__ import annotations

from itertools import pairwise

from hypothesis import given
from hypothesis import strategies as st

from gateway.vehicle.track import Position, Track

STEP_DEG = 0.0001


def place(step: float) -> Position:
    """Eleven metres further north with each step."""
    return (27.0 + STEP_DEG * step, -15.0, 300.0)


def flown(steps: int, max_points: int = 1000, *, start_s: float = 0.0) -> Track:
    track = Track(max_points)
    for step in range(steps):
        track.add(start_s + step, place(step))
    return track


def lines(track: Track, most_points: int | None = None, since_s: float = 0.0) -> list[list[Position]]:
    return [list(track.points(piece)) for piece in track.pieces(most_points, since_s)]


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
    track = Track(max_points)
    for number, length in enumerate(pieces):
        for step in range(length):
            track.add(100.0 * number + step, (27.0 + number + STEP_DEG * step, -15.0, 300.0))
    for line in lines(track):
        assert len({int(position[0]) for position in line}) == 1


@given(st.integers(2, 300), st.integers(2, 50))
def test_fewer_points_are_spread_evenly_and_end_with_the_newest(steps: int, most: int) -> None:
    (line,) = lines(flown(steps), most)
    assert 2 <= len(line) <= most + 1
    assert line[-1] == place(steps - 1)
    gaps = {round((second[0] - first[0]) / STEP_DEG) for first, second in pairwise(line)}
    assert len(gaps) == 1


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
    track = flown(10, 10)
    (piece,) = track.pieces()
    reading = track.points(piece)
    for step in range(10, 25):
        track.add(float(step), place(step))
    assert list(reading) == [place(step) for step in range(10)]
