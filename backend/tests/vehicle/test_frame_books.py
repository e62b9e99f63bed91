"""Every type of frame has its books, also those that came damaged and those that nobody knows."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.codec.checksum import checksum
from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.codec.frame import Damage, FrameDecoder
from epf_gcs.codec.messages_gen import END, TELEMETRY, TO_PC_HEADER
from epf_gcs.vehicle.frame_books import FrameBooks

AHRS = encode_telemetry("ahrs", 10.0, 5.0, -3.0)
GPS = encode_telemetry("gps", 27.9, -15.4, 30.0, 0.0, 0.0, 0x38, 0x31, 0x41)


def broken(frame: bytes) -> bytes:
    """A bit of the last payload byte is turned."""
    return frame[:-9] + bytes([frame[-9] ^ 1]) + frame[-8:]


def of_type(type_word: int, payload: bytes) -> bytes:
    body = type_word.to_bytes(4, "little") + payload
    return TO_PC_HEADER + body + checksum(body).to_bytes(4, "little") + END


def booked(*chunks: bytes) -> FrameBooks:
    books, decoder = FrameBooks(), FrameDecoder()
    for place, chunk in enumerate(chunks):
        for item in decoder.feed(chunk):
            if isinstance(item, Damage):
                books.on_damage(item, float(place))
    for item in decoder.finish():
        if isinstance(item, Damage):
            books.on_damage(item, 99.0)
    return books


def test_every_type_is_there_before_it_is_heard() -> None:
    assert [arrivals.count for arrivals in FrameBooks().heard.values()] == [0] * len(TELEMETRY)


@pytest.mark.parametrize(("frame", "name"), [(AHRS, "ahrs"), (GPS, "gps")])
def test_a_damaged_frame_is_counted_where_it_belongs(frame: bytes, name: str) -> None:
    stream = AHRS + broken(frame) + GPS + broken(frame)
    assert booked(stream).damaged == {name: 2}
    assert booked(*(stream[place : place + 1] for place in range(len(stream)))).damaged == {name: 2}


def test_a_whole_frame_of_an_unknown_type_is_heard() -> None:
    newer = of_type(0x80000123, b"\1\2\3\4" * 3)
    books = booked(AHRS + newer, newer + GPS)
    assert list(books.unknown) == [0x123]
    assert books.unknown[0x123].count == 2
    assert books.unknown_damaged[0x123] == 0


def test_a_damaged_one_of_an_unknown_type_is_damaged() -> None:
    books = booked(AHRS + broken(of_type(0x80000123, b"\1\2\3\4" * 3)) + GPS)
    assert books.unknown[0x123].count == 0
    assert books.unknown_damaged == {0x123: 1}


def test_a_type_with_wrong_bits_and_noise_belong_to_nobody() -> None:
    books = booked(of_type(0x90000001, b"") + of_type(0x00000001, b"") + b"prompt>\n" + b"\xff" * 40)
    assert (books.damaged, books.unknown) == ({}, {})


def test_a_bad_line_does_not_fill_the_memory() -> None:
    books = booked(*(of_type(0x80001000 + number, b"") for number in range(500)))
    assert len(books.unknown) == 32


def test_a_commanded_rate_is_forgotten_for_its_topics_alone() -> None:
    books = FrameBooks()
    for place in range(10):
        books.heard["servos_in"].heard(place * 0.02, None)
        books.heard["gps"].heard(place * 0.1, None)
    books.rate_changed("set_servos_task_rate")
    assert books.heard["servos_in"].summary(0.18).rate_hz == 0.0
    assert books.heard["gps"].summary(0.9).rate_hz == pytest.approx(10.0)


@given(st.lists(st.one_of(st.binary(max_size=60), st.sampled_from((AHRS, GPS, broken(AHRS), TO_PC_HEADER)))))
def test_no_line_makes_it_raise_and_damage_never_exceeds_what_failed(chunks: list[bytes]) -> None:
    books, decoder = FrameBooks(), FrameDecoder()
    failed = 0
    for item in (item for chunk in chunks for item in decoder.feed(chunk)):
        if isinstance(item, Damage):
            failed += item.is_failed_frame
            books.on_damage(item, 0.0)
    counted = sum(books.damaged.values()) + sum(books.unknown_damaged.values())
    assert counted + sum(arrivals.count for arrivals in books.unknown.values()) <= failed


def test_books_that_are_cleared_begin_anew() -> None:
    books = booked(AHRS + broken(AHRS) + of_type(0x80000123, b"") + broken(of_type(0x80000124, b"\0" * 4)) + GPS)
    books.heard["ahrs"].heard(1.0, {"roll_deg": 1.0})
    books.clear()
    assert (books.damaged, books.unknown, books.unknown_damaged) == ({}, {}, {})
    assert (books.heard["ahrs"].count, books.heard["ahrs"].values) == (0, None)
