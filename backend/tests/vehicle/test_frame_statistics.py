"""Every type of frame has its statistics, also those that came damaged and those that nobody knows."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.codec.checksum import checksum
from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.codec.frame import Damage, FrameDecoder
from epf_gcs.codec.messages_gen import END, TELEMETRY, TO_PC_HEADER
from epf_gcs.vehicle.frame_statistics import FrameStatistics

AHRS = encode_telemetry("ahrs", 10.0, 5.0, -3.0)
GPS = encode_telemetry("gps", 27.9, -15.4, 30.0, 0.0, 0.0, 0x38, 0x31, 0x41)


def broken(frame: bytes) -> bytes:
    """A bit of the last payload byte is turned."""
    return frame[:-9] + bytes([frame[-9] ^ 1]) + frame[-8:]


def of_type(type_word: int, payload: bytes) -> bytes:
    body = type_word.to_bytes(4, "little") + payload
    return TO_PC_HEADER + body + checksum(body).to_bytes(4, "little") + END


def counted_from(*chunks: bytes) -> FrameStatistics:
    statistics, decoder = FrameStatistics(), FrameDecoder()
    for place, chunk in enumerate(chunks):
        for item in decoder.feed(chunk):
            if isinstance(item, Damage):
                statistics.on_damage(item, float(place))
    for item in decoder.finish():
        if isinstance(item, Damage):
            statistics.on_damage(item, 99.0)
    return statistics


def test_every_type_is_there_before_it_is_heard() -> None:
    assert [arrivals.count for arrivals in FrameStatistics().heard.values()] == [0] * len(TELEMETRY)


@pytest.mark.parametrize(("frame", "name"), [(AHRS, "ahrs"), (GPS, "gps")])
def test_a_damaged_frame_is_counted_where_it_belongs(frame: bytes, name: str) -> None:
    stream = AHRS + broken(frame) + GPS + broken(frame)
    assert counted_from(stream).damaged == {name: 2}
    assert counted_from(*(stream[place : place + 1] for place in range(len(stream)))).damaged == {name: 2}


def test_the_type_alone_tells_what_was_cut_off() -> None:
    assert counted_from(GPS[:8] + GPS + GPS[:7] + AHRS + AHRS).damaged == {"gps": 1}


def test_a_whole_frame_of_an_unknown_type_is_heard() -> None:
    newer = of_type(0x80000123, b"\1\2\3\4" * 3)
    statistics = counted_from(AHRS + newer, newer + GPS)
    assert list(statistics.unknown) == [0x123]
    assert statistics.unknown[0x123].count == 2
    assert statistics.unknown_damaged[0x123] == 0


@pytest.mark.parametrize("words", [0, 1, 2])
def test_a_frame_of_an_unknown_type_is_whole_however_short_it_is(words: int) -> None:
    statistics = counted_from(AHRS + of_type(0x80000123, b"\1\2\3\4" * words) + GPS)
    assert statistics.unknown[0x123].count == 1
    assert statistics.unknown_damaged[0x123] == 0


def test_a_damaged_one_of_an_unknown_type_is_damaged() -> None:
    statistics = counted_from(AHRS + broken(of_type(0x80000123, b"\1\2\3\4" * 3)) + GPS)
    assert statistics.unknown[0x123].count == 0
    assert statistics.unknown_damaged == {0x123: 1}


def test_a_type_with_wrong_bits_and_noise_belong_to_nobody() -> None:
    statistics = counted_from(of_type(0x90000001, b"") + of_type(0x00000001, b"") + b"prompt>\n" + b"\xff" * 40)
    assert (statistics.damaged, statistics.unknown) == ({}, {})


def test_a_header_behind_a_failed_frame_is_no_frame_of_a_type_of_its_own() -> None:
    statistics = FrameStatistics()
    failed = Damage("bad_checksum", (0x80000123).to_bytes(4, "little"))
    for damage in (failed, failed, Damage("noise", failed.data), failed):
        statistics.on_damage(damage, 1.0)
    assert (statistics.damaged, statistics.unknown) == ({}, {})


def test_a_bad_line_does_not_fill_the_memory() -> None:
    statistics = counted_from(*(of_type(0x80001000 + number, b"") for number in range(500)))
    assert len(statistics.unknown) == 32


def test_a_commanded_rate_is_forgotten_for_its_topics_alone() -> None:
    statistics = FrameStatistics()
    for place in range(10):
        statistics.heard["servos_in"].heard(place * 0.02, None)
        statistics.heard["gps"].heard(place * 0.1, None)
    statistics.rate_changed("set_servos_task_rate")
    assert statistics.heard["servos_in"].summary(0.18).rate_hz == 0.0
    assert statistics.heard["gps"].summary(0.9).rate_hz == pytest.approx(10.0)


@given(st.lists(st.one_of(st.binary(max_size=60), st.sampled_from((AHRS, GPS, broken(AHRS), TO_PC_HEADER)))))
def test_no_line_makes_it_raise_and_damage_never_exceeds_what_failed(chunks: list[bytes]) -> None:
    statistics, decoder = FrameStatistics(), FrameDecoder()
    failed = 0
    for item in (item for chunk in chunks for item in decoder.feed(chunk)):
        if isinstance(item, Damage):
            failed += item.is_failed_frame
            statistics.on_damage(item, 0.0)
    counted = sum(statistics.damaged.values()) + sum(statistics.unknown_damaged.values())
    assert counted + sum(arrivals.count for arrivals in statistics.unknown.values()) <= failed


def test_statistics_that_are_cleared_begin_anew() -> None:
    statistics = counted_from(
        AHRS + broken(AHRS) + of_type(0x80000123, b"") + broken(of_type(0x80000124, b"\0" * 4)) + GPS
    )
    statistics.heard["ahrs"].heard(1.0, {"roll_deg": 1.0})
    statistics.clear()
    assert (statistics.damaged, statistics.unknown, statistics.unknown_damaged) == ({}, {}, {})
    assert (statistics.heard["ahrs"].count, statistics.heard["ahrs"].values) == (0, None)
