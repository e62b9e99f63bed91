"""The table in which a board describes itself: rows out of any bytes, and back."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.codec.description import (
    FieldRow,
    GainRow,
    KnownRow,
    TopicRow,
    UnreadableRow,
    blocks_of,
    packed_rows,
    rows_of,
)
from epf_gcs.codec.values import shortest

GAIN = GainRow(0, 1, True, 0.1, 10.0, 0.05, 3.0, "line_k_bank", "1/rad", "line", "", "Aileron for each rad of bank.")
TOPIC = TopicRow(1, 0x1000, 500, "wind", "The wind.")
FIELD = FieldRow(2, 1, 1.0, 0.0, 360.0, "wind_from", "deg", "", "clockwise from north")

texts = st.text(st.characters(min_codepoint=0x20, max_codepoint=0x7E), max_size=16)
numbers = st.floats(width=32, allow_nan=False).map(shortest)
types = st.integers(0, 255)
words = st.integers(0, 65535)
gains = st.builds(GainRow, st.just(0), types, st.booleans(), *[numbers] * 4, *[texts] * 5)
topics = st.builds(TopicRow, st.just(0), words, words, texts, texts)
fields = st.builds(FieldRow, st.just(0), types, *[numbers] * 3, *[texts] * 4)


def test_the_bytes_of_a_row_are_those_of_the_specification() -> None:
    gain = (
        b"\x01\x01\xcd\xcc\xcc\x3d\x00\x00\x20\x41\xcd\xcc\x4c\x3d\x00\x00\x40\x40line_k_bank\x001/rad\x00line\x00\x00"
    )
    gain += b"Aileron for each rad of bank.\x00"
    topic = b"\x00\x10\xf4\x01wind\x00The wind.\x00"
    field = b"\x01\x00\x00\x80\x3f\x00\x00\x00\x00\x00\x00\xb4\x43wind_from\x00deg\x00\x00clockwise from north\x00"
    table = b"".join(
        bytes((len(content) + 2, kind)) + content for kind, content in enumerate((gain, topic, field), start=1)
    )
    assert rows_of(table) == [GAIN, TOPIC, FIELD]
    assert packed_rows((GAIN, TOPIC, FIELD)) == table


@given(st.lists(st.one_of(gains, topics, fields), max_size=8))
def test_packed_rows_come_back_numbered(rows: list[KnownRow]) -> None:
    assert rows_of(packed_rows(rows)) == [replace(row, row=number) for number, row in enumerate(rows)]


@given(st.binary(max_size=300))
def test_any_bytes_give_rows_numbered_from_0(table: bytes) -> None:
    assert [row.row for row in rows_of(table)] == list(range(len(rows_of(table))))


@given(st.lists(st.one_of(gains, topics, fields), min_size=1, max_size=4), st.data())
def test_a_changed_byte_gives_rows_too(rows: list[KnownRow], data: st.DataObject) -> None:
    table = bytearray(packed_rows(rows))
    table[data.draw(st.integers(0, len(table) - 1))] = data.draw(types)
    assert [row.row for row in rows_of(bytes(table))] == list(range(len(rows_of(bytes(table)))))


@pytest.mark.parametrize(
    ("row", "meant"),
    [
        (b"\x02\x00", UnreadableRow(1, None, "kind")),
        (b"\x06\x04abc\x00", UnreadableRow(1, None, "kind")),
        (b"\x02\x01", UnreadableRow(1, None, "length")),
        (b"\x05\x02\x00\x10\xf4", UnreadableRow(1, None, "length")),
        (b"\x06\x02\x00\x10\xf4\x01", UnreadableRow(1, None, "length")),
        (b"\x0b\x02\x00\x10\xf4\x01wind\x00", UnreadableRow(1, "wind", "length")),
        (b"\x0a\x02\x00\x10\xf4\x01wind", UnreadableRow(1, None, "text")),
        (b"\x0d\x02\x00\x10\xf4\x01wind\x00ab", UnreadableRow(1, "wind", "text")),
        (b"\x0d\x02\x00\x10\xf4\x01wind\x00\xe9\x00", UnreadableRow(1, "wind", "text")),
        (b"\x0d\x02\x00\x10\xf4\x01wi\x07d\x00a\x00", UnreadableRow(1, None, "text")),
    ],
)
def test_a_row_that_cannot_be_read_says_why_and_the_next_one_is_read(row: bytes, meant: UnreadableRow) -> None:
    assert rows_of(packed_rows((GAIN,)) + row + packed_rows((FIELD,))) == [GAIN, meant, FIELD]


@pytest.mark.parametrize("length", [0, 1, 255])
def test_a_length_that_cannot_be_makes_the_rest_one_unreadable_row(length: int) -> None:
    rest = bytes((length, 2)) + packed_rows((TOPIC, FIELD))
    assert rows_of(packed_rows((GAIN,)) + rest) == [GAIN, UnreadableRow(1, None, "length")]


def test_bytes_behind_what_is_known_are_skipped_so_that_rows_can_grow() -> None:
    grown = bytearray(packed_rows((TOPIC,)) + b"\x07\xffmore")
    grown[0] = len(grown)
    assert rows_of(bytes(grown) + packed_rows((FIELD,))) == [replace(TOPIC, row=0), replace(FIELD, row=1)]


def test_a_number_that_is_not_finite_is_left_to_whoever_judges_the_row() -> None:
    (row,) = rows_of(packed_rows((replace(GAIN, maximum=math.nan),)))
    assert isinstance(row, GainRow)
    assert math.isnan(row.maximum)


def test_a_row_that_is_too_long_is_not_packed() -> None:
    with pytest.raises(ValueError, match="line_k_bank"):
        packed_rows((replace(GAIN, help="x" * 255),))


def test_the_blocks_are_the_table_with_zeros_behind_its_end() -> None:
    table = packed_rows((GAIN, TOPIC, FIELD))
    first, second = blocks_of(table)
    assert (len(first), len(second)) == (128, 128)
    assert first + second == table.ljust(256, b"\0")
    assert blocks_of(b"") == []
