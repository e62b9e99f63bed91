"""The AHRS test stream: dialogue and bare records."""

from __future__ import annotations

import struct

import pytest

from epf_gcs.codec.ahrs_test import AhrsTest, AhrsTestState, Attitude

MARK = b"\xaa" * 4


def _record(yaw: float, pitch: float, roll: float) -> bytes:
    return MARK + struct.pack("<3f", yaw, pitch, roll)


def _streaming() -> AhrsTest:
    test = AhrsTest()
    test.start(0.0)
    test.tick(1.0)
    test.feed(b"#SYNCH00\n\r")
    return test


def test_the_dialogue_is_the_chapters() -> None:
    test = AhrsTest()
    assert test.start(0.0) == b"#sim\r"
    assert test.tick(0.1) == b""
    assert test.tick(0.2) == b"#s00\0"
    assert test.feed(b"noise#SYNCH") == []
    assert test.feed(b"00\n\r" + _record(10.0, 5.0, -2.5) + MARK) == [Attitude(10.0, 5.0, -2.5)]
    assert test.state is AhrsTestState.STREAMING
    assert test.stop() == b"q"
    assert test.stop() == b""
    assert test.feed(_record(1.0, 1.0, 1.0)) == []


def test_a_board_that_does_not_answer_is_asked_from_the_beginning() -> None:
    test = AhrsTest()
    test.start(0.0)
    assert test.tick(0.2) == b"#s00\0"
    assert test.deadline_s == pytest.approx(2.2)
    assert test.tick(2.3) == b"#sim\r"


def test_cut_points_do_not_matter() -> None:
    stream = _record(1.0, 2.0, 3.0) + b"\xaa\xaa" + _record(4.0, 5.0, 6.0) + _record(7.0, 8.0, 9.0) + MARK
    whole = _streaming().feed(stream)
    assert whole == [Attitude(1.0, 2.0, 3.0), Attitude(4.0, 5.0, 6.0), Attitude(7.0, 8.0, 9.0)]
    for cut in range(len(stream) + 1):
        test = _streaming()
        assert test.feed(stream[:cut]) + test.feed(stream[cut:]) == whole


def test_a_lost_byte_costs_its_record_and_shows_no_wrong_one() -> None:
    records = [_record(float(n), 10.0 + n, 20.0 + n) for n in range(4)]
    stream = b"".join(records) + MARK
    for lost in range(len(records[0]), 2 * len(records[0])):
        found = _streaming().feed(stream[:lost] + stream[lost + 1 :])
        intact = [Attitude(float(n), 10.0 + n, 20.0 + n) for n in (0, 2, 3)]
        # Where the lost byte is of its mark, the record in front of it has no proof either.
        assert found == (intact if lost >= len(records[0]) + len(MARK) else intact[1:])


def test_a_float_that_holds_the_mark_does_not_break_the_records() -> None:
    (odd,) = struct.unpack("<f", b"\xaa\xaa\xaa\x42")
    stream = _record(odd, odd, 0.5) + _record(3.0, 2.0, 1.0) + MARK
    assert _streaming().feed(stream) == [Attitude(odd, odd, 0.5), Attitude(3.0, 2.0, 1.0)]


def test_impossible_angles_are_no_attitude() -> None:
    test = _streaming()
    bad = _record(float("nan"), 0.0, 0.0) + _record(0.0, 91.0, 0.0)
    assert test.feed(bad + _record(1.0, 2.0, 3.0) + MARK) == [Attitude(1.0, 2.0, 3.0)]
    assert test.skipped == len(bad)


@pytest.mark.parametrize("angles", [(359.5, 89.5, 179.5), (-359.5, -89.5, -179.5), (360.0, 90.0, 180.0)])
def test_angles_just_inside_their_limits_are_an_attitude(angles: tuple[float, float, float]) -> None:
    assert _streaming().feed(_record(*angles) + MARK) == [Attitude(*angles)]


@pytest.mark.parametrize("angles", [(360.5, 0.0, 0.0), (0.0, -90.5, 0.0), (0.0, 0.0, 180.5)])
def test_angles_just_outside_their_limits_are_none(angles: tuple[float, float, float]) -> None:
    test = _streaming()
    assert test.feed(_record(*angles) + MARK) == []
    assert test.skipped > 0


def test_the_answer_is_found_wherever_it_is_cut_and_whatever_came_before() -> None:
    answer = b"#SY" + b"noise" + b"#SYNCH00\n\r"
    for cut in range(len(answer) + 1):
        test = AhrsTest()
        test.start(0.0)
        test.tick(1.0)
        test.feed(answer[:cut])
        assert test.feed(answer[cut:] + _record(1.0, 2.0, 3.0) + MARK) == [Attitude(1.0, 2.0, 3.0)]


def test_without_a_start_nothing_is_waited_for_and_nothing_is_sent() -> None:
    test = AhrsTest()
    assert (test.deadline_s, test.tick(100.0), test.stop()) == (None, b"", b"")
    assert test.skipped == 0


def test_every_byte_outside_records_is_counted_once() -> None:
    test = _streaming()
    test.feed(bytes(100) + _record(1.0, 2.0, 3.0) + MARK)
    assert test.skipped == 100
    silent = _streaming()
    silent.feed(bytes(100))
    assert silent.skipped == 97, "the last three may be the beginning of a mark"


def test_half_an_answer_from_before_the_end_is_no_part_of_the_next_one() -> None:
    test = AhrsTest()
    test.start(0.0)
    test.tick(1.0)
    test.feed(b"#SYNCH0")
    test.stop()
    assert test.deadline_s is None
    assert test.start(10.0) == b"#sim\r"
    assert test.deadline_s == pytest.approx(10.2)
    test.tick(10.2)
    assert test.feed(b"0\n\r" + _record(1.0, 2.0, 3.0) + MARK) == [], "it has not answered"
    assert test.state is AhrsTestState.SYNCHRONISING


def test_a_stream_that_runs_is_not_asked_again() -> None:
    test = _streaming()
    assert test.deadline_s is None
    assert test.tick(99.0) == b""
    assert test.feed(_record(1.0, 2.0, 3.0) + MARK) == [Attitude(1.0, 2.0, 3.0)]
