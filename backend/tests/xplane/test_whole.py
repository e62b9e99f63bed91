"""The short way gives what the long way gives, or nothing."""

from __future__ import annotations

import struct

import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.codec.messages_gen import NO_VALUE
from epf_gcs.xplane.datagram import Record, build, parse
from epf_gcs.xplane.gather import Gatherer
from epf_gcs.xplane.mapping import XplaneInfo
from epf_gcs.xplane.whole import WholeFrames

ORDER = (3, 4, 6, 8, 11, 16, 17, 18, 20, 25)
PROFILES = ("xp10", "xp12")


def a_datagram(rows: tuple[int, ...] = ORDER, value: float = 0.25) -> bytes:
    return build(Record(row, (value + row / 100.0,) * 8) for row in rows)


def the_long_way(datagram: bytes, profile: str) -> XplaneInfo | None:
    records = parse(datagram)
    return None if records is None else Gatherer(profile).take(records, 0.0)


@pytest.mark.parametrize("profile", PROFILES)
def test_a_usual_frame_is_read(profile: str) -> None:
    info = WholeFrames(profile).read(a_datagram())
    assert info is not None
    assert info == the_long_way(a_datagram(), profile)
    assert info.yaw_deg == pytest.approx(0.43), "the track, row 18, and not the heading, row 17"


@pytest.mark.parametrize("rows", [ORDER[::-1], (25, 3, 20, 4, 18, 8, 17, 16), (*ORDER, 100, 101)])
def test_any_order_and_more_rows_are_read(rows: tuple[int, ...]) -> None:
    assert WholeFrames("xp10").read(a_datagram(rows)) == the_long_way(a_datagram(rows), "xp10") is not None


@pytest.mark.parametrize("missing", [3, 4, 8, 16, 17, 18, 20, 25])
def test_a_frame_without_a_row_is_left_to_the_long_way(missing: int) -> None:
    assert WholeFrames("xp10").read(a_datagram(tuple(row for row in ORDER if row != missing))) is None


def test_a_row_that_is_there_twice_is_left_to_the_long_way() -> None:
    assert WholeFrames("xp10").read(a_datagram((*ORDER, 17))) is None


@pytest.mark.parametrize("value", [NO_VALUE, float("nan"), float("inf"), 1e9])
def test_an_unusual_value_is_left_to_the_long_way(value: float) -> None:
    assert WholeFrames("xp10").read(a_datagram(value=value)) is None


def test_no_value_is_no_altitude() -> None:
    frame = [Record(row, (0.25,) * 8) for row in ORDER if row != 20]
    position = Record(20, (27.9, -15.4, 100.0, 0.0, 0.0, NO_VALUE, 0.0, 0.0))
    assert WholeFrames("xp10").read(build([*frame, position])) is None


def test_many_orders_of_rows_cost_no_memory() -> None:
    reader = WholeFrames("xp10")
    for extra in range(100, 400):
        assert reader.read(a_datagram((*ORDER, extra))) is not None
    assert reader.read(a_datagram()) is not None


@given(st.binary(max_size=800))
def test_rubbish_is_never_read(data: bytes) -> None:
    assert WholeFrames("xp10").read(data) is None
    assert WholeFrames("xp10").read(b"DATA@" + data) is None or len(data) % 36 == 0


singles = st.floats(width=32) | st.sampled_from([NO_VALUE, 0.0, 1.0, -1.0, 1.5])


@pytest.mark.uncounted
@given(
    st.sampled_from(PROFILES),
    st.lists(st.sampled_from([*ORDER, 13]), min_size=8, max_size=12),
    st.lists(singles, min_size=96, max_size=96),
)
def test_where_it_answers_it_is_the_long_ways_answer(profile: str, rows: list[int], values: list[float]) -> None:
    datagram = build(Record(row, tuple(values[8 * n : 8 * n + 8])) for n, row in enumerate(rows))
    info = WholeFrames(profile).read(datagram)
    assert info is None or info == the_long_way(datagram, profile)


@pytest.mark.uncounted
@given(
    st.sampled_from(PROFILES), st.permutations(ORDER), st.lists(st.floats(0.0, 1.0, width=32), min_size=80, max_size=80)
)
def test_every_usual_frame_is_answered(profile: str, rows: list[int], values: list[float]) -> None:
    datagram = build(Record(row, tuple(values[8 * n : 8 * n + 8])) for n, row in enumerate(rows))
    info = WholeFrames(profile).read(datagram)
    assert info is not None
    assert info == the_long_way(datagram, profile)
    assert struct.calcsize("<15f") == 4 * len(info)
