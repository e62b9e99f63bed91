"""Rows become one command for each simulator frame, however they are spread over datagrams."""

from __future__ import annotations

import json
import random
from dataclasses import asdict

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.xplane.datagram import Record
from epf_gcs.xplane.gather import Gatherer, GathererState
from epf_gcs.xplane.mapping import XplaneInfo

ORDER = (3, 4, 6, 8, 11, 16, 17, 18, 20, 25)
PERIOD_S = 0.02


def _frame(number: int, rows: tuple[int, ...] = ORDER) -> list[Record]:
    """All values of frame n carry n, so that a mixture of two frames is seen."""
    mark = number % 80 / 100.0
    return [Record(row, (mark,) * 8) for row in rows]


def _is_of_one_frame(info: XplaneInfo) -> bool:
    return len(set(info)) == 1


def _whole(gatherer: Gatherer, count: int, rows: tuple[int, ...] = ORDER) -> list[XplaneInfo | None]:
    return [gatherer.take(_frame(n, rows), n * PERIOD_S) for n in range(count)]


def test_one_datagram_with_all_rows_is_one_command_at_once() -> None:
    infos = _whole(Gatherer("xp10"), 5)
    assert [info and info.pitch_deg for info in infos] == [0.0, 0.01, 0.02, 0.03, 0.04]


def test_one_row_a_datagram_is_one_command_for_each_frame() -> None:
    gatherer = Gatherer("xp10")
    infos = []
    for number in range(10):
        for place, record in enumerate(_frame(number)):
            info = gatherer.take([record], number * PERIOD_S + place * 0.0001)
            if info is not None:
                infos.append((number, record.row, info))
    assert [(number, row) for number, row, _ in infos] == [(number, 25) for number in range(10)]
    assert all(_is_of_one_frame(info) for _, _, info in infos)


@pytest.mark.parametrize("cut", range(1, len(ORDER)))
def test_two_datagrams_a_frame_are_one_command(cut: int) -> None:
    gatherer = Gatherer("xp10")
    infos = []
    for number in range(6):
        records = _frame(number)
        infos += [gatherer.take(part, number * PERIOD_S) for part in (records[:cut], records[cut:])]
    made = [info for info in infos if info is not None]
    assert len(made) == 6
    assert all(_is_of_one_frame(info) for info in made)


def test_one_datagram_whose_first_row_is_not_its_lowest_is_one_command_for_each_frame() -> None:
    infos = _whole(Gatherer("xp10"), 5, (18, *[row for row in ORDER if row < 18], 20, 25)[::-1])
    assert [info is not None for info in infos] == [True] * 5
    infos = _whole(Gatherer("xp10"), 5, (20, 25, 18, 3, 4, 8, 16, 17))
    assert [info is not None for info in infos] == [True] * 5


def test_a_row_behind_a_complete_frame_does_not_send_it_again() -> None:
    gatherer = Gatherer("xp10")
    assert gatherer.take(_frame(1, (3, 4, 8, 16, 17, 20, 25)), 0.0) is not None
    assert gatherer.take([Record(25, (0.5,) * 8)], 0.001) is None
    gatherer = Gatherer("xp10")
    assert gatherer.take(_frame(1, (20, 25, 3, 4, 8, 16, 17)), 0.0) is not None
    assert gatherer.take(_frame(1, (18,)), 0.001) is None


def test_the_first_datagrams_of_a_running_simulator_may_come_from_the_middle_of_a_frame() -> None:
    gatherer = Gatherer("xp10")
    stream = [record for number in range(10) for record in _frame(number)][6:]
    infos = [info for place, record in enumerate(stream) if (info := gatherer.take([record], place * 0.002))]
    assert all(_is_of_one_frame(info) for info in infos)
    assert len(infos) == 9


@given(lost=st.sets(st.integers(0, 599), max_size=120), seed=st.integers(0, 99))
def test_lost_datagrams_never_mix_two_frames(lost: set[int], seed: int) -> None:
    rng = random.Random(seed)
    gatherer = Gatherer("xp10")
    stream = [(number, record) for number in range(60) for record in _frame(number)]
    intact = set(range(60)) - {place // len(ORDER) for place in lost}
    seen = set()
    for place, (number, record) in enumerate(stream):
        if place in lost:
            continue
        info = gatherer.take([record], number * PERIOD_S + rng.uniform(0.0, 0.001))
        if info is not None:
            assert _is_of_one_frame(info)
            seen.add(number)
    assert intact <= seen


def test_the_track_wins_wherever_its_row_comes() -> None:
    for rows in ((18, *[row for row in ORDER if row != 18]), (*[row for row in ORDER if row != 18], 18)):
        gatherer = Gatherer("xp10")
        for number in range(5):
            records = [Record(row, (0.0, 0.0, 200.0, *[0.0] * 5) if row == 18 else (0.1,) * 8) for row in rows]
            info = gatherer.take(records, number * PERIOD_S)
            assert info is not None
            assert info.yaw_deg == 200.0


def test_the_track_is_waited_for_when_its_datagram_comes_last() -> None:
    gatherer = Gatherer("xp10")
    rows = tuple(row for row in ORDER if row != 18)
    yaws = []
    for number in range(40):
        for records in ([Record(row, (0.1,) * 8) for row in rows], [Record(18, (0.0, 0.0, 200.0, *[0.0] * 5))]):
            info = gatherer.take(records, number * PERIOD_S)
            if info is not None:
                yaws.append((number, info.yaw_deg))
    # The very first datagram looks complete; from the second frame on the track is known to come.
    assert {yaw for _, yaw in yaws[1:]} == {200.0}
    numbers = [number for number, _ in yaws]
    assert len(numbers) > 20
    assert len(numbers) == len(set(numbers))


def test_a_simulator_that_stops_sending_the_track_is_followed_by_its_heading() -> None:
    gatherer = Gatherer("xp10")
    _whole(gatherer, 3)
    rows = tuple(row for row in ORDER if row != 18)
    infos = [gatherer.take(_frame(n, rows), n * PERIOD_S) for n in range(3, 6)]
    assert [info is not None for info in infos] == [False, True, True]


@pytest.mark.parametrize("rows", [ORDER[::-1], (3, 4, 6, 8, 11, 16, 18, 17, 20, 25), (17, 25, 3, 18, 4, 20, 8, 16)])
@pytest.mark.parametrize("missed", [0, 3])
def test_rows_in_another_order_are_understood_after_a_while(rows: tuple[int, ...], missed: int) -> None:
    gatherer = Gatherer("xp10")
    stream = [(number, record) for number in range(20) for record in _frame(number, rows)][missed:]
    made = []
    for number, record in stream:
        info = gatherer.take([record], number * PERIOD_S)
        if info is not None:
            made.append((number, info))
    assert {number for number, _ in made} >= set(range(8, 20))
    assert all(_is_of_one_frame(info) for _, info in made)


def test_old_rows_are_never_sent() -> None:
    gatherer = Gatherer("xp10")
    _whole(gatherer, 2)
    first, last = _frame(2)[:5], _frame(2)[5:]
    assert gatherer.take(first, 10.0) is None
    assert gatherer.take(last, 10.5) is None
    assert gatherer.incomplete_frames == 1


@pytest.mark.parametrize("missing", [3, 4, 8, 16, 17, 20, 25])
def test_a_row_that_never_arrives_gives_no_command(missing: int) -> None:
    rows = tuple(row for row in ORDER if row != missing)
    assert _whole(Gatherer("xp10"), 5, rows) == [None] * 5


def test_a_value_that_is_no_number_gives_no_command_and_is_counted() -> None:
    gatherer = Gatherer("xp10")
    records = [record for record in _frame(1) if record.row != 17]
    bad = Record(17, (float("nan"), 1.0, 2.0, *[-999.0] * 5))
    assert gatherer.take([*records, bad], 0.0) is None
    assert gatherer.implausible == {"pitch_deg": 1}
    assert gatherer.take(_frame(2), 0.02) is not None


def test_rows_that_no_one_needs_change_nothing() -> None:
    gatherer = Gatherer("xp10")
    assert gatherer.take([Record(6, (1.0,) * 8), Record(11, (0.0,) * 8)], 0.0) is None
    assert gatherer.take([Record(99, (1.0,) * 8)], 0.0) is None
    assert gatherer.incomplete_frames == 0


@pytest.mark.parametrize("rows", [ORDER, ORDER[::-1], (17, 25, 3, 18, 4, 20, 8, 16)])
def test_one_that_goes_on_from_what_was_kept_makes_the_same_commands_from_there(rows: tuple[int, ...]) -> None:
    stream = [
        (number * PERIOD_S + place * 0.0001, record)
        for number in range(7)
        for place, record in enumerate(_frame(number, rows))
        if (number, place) not in ((2, 3), (5, 0))
    ]
    through = Gatherer("xp10")
    kept, made = [], []
    for now_s, record in stream:
        kept.append(json.dumps(asdict(through.kept())))
        made.append(through.take([record], now_s))
    for place, state in enumerate(kept):
        again = Gatherer("xp10")
        again.restore(msgspec.convert(json.loads(state), GathererState, str_keys=True))
        assert [again.take([record], now_s) for now_s, record in stream[place:]] == made[place:]
        assert again.kept() == through.kept()


def test_a_frame_is_waited_for_for_a_fifth_of_a_second_and_no_longer() -> None:
    for late_s, is_made in ((0.19, True), (0.21, False)):
        gatherer = Gatherer("xp10")
        _whole(gatherer, 2)
        gatherer.take(_frame(2)[:5], 10.0)
        assert (gatherer.take(_frame(2)[5:], 10.0 + late_s) is not None) == is_made


def test_frames_that_were_cut_are_counted_once_each_and_whole_ones_never() -> None:
    gatherer = Gatherer("xp10")
    for number in range(10):
        records = _frame(number)
        gatherer.take(records[:4] if number in (3, 4, 7) else records, number * PERIOD_S)
    assert gatherer.incomplete_frames == 3


def test_frames_that_lost_their_first_row_now_and_then_are_no_other_order() -> None:
    gatherer = Gatherer("xp10")
    made = []
    for number in range(60):
        records = _frame(number)
        # Without its first row a frame ends where the next one begins with a lower row.
        for place, part in enumerate((records[:1], records[1:])[number % 2 :]):
            stalled_s = 0.05 if number > 40 or (number, place) == (40, 1) else 0.0
            info = gatherer.take(part, number * PERIOD_S + stalled_s)
            if info is not None:
                made.append((number, info))
    assert [number for number, _ in made] == list(range(0, 60, 2))
    assert all(_is_of_one_frame(info) for _, info in made)


def test_a_pause_of_ours_does_not_choose_where_frames_begin_for_ever() -> None:
    gatherer = Gatherer("xp10")
    made = []
    for number in range(230):
        for place, record in enumerate(_frame(number, ORDER[::-1])):
            stalled_s = 0.05 if (number, place) >= (1, 5) else 0.0
            info = gatherer.take([record], number * PERIOD_S + place * 0.0001 + stalled_s)
            if info is not None and number >= 200:
                made.append((number, info))
    assert [number for number, _ in made] == list(range(200, 230))
    assert all(_is_of_one_frame(info) for _, info in made)
