"""The AHRS test stream of text mode."""

from board_tests.line.station import VERSION, Station
from epf_gcs.codec.ahrs_test import BEGIN, QUIT, SYNCHRONISE, SYNCHRONISED, AhrsTest, AhrsTestState

MARK = b"\xaa" * 4


def begin(text: Station) -> None:
    text.send(BEGIN)
    text.send(SYNCHRONISE)
    text.wait(lambda: text.received.count(MARK) >= 5)


def test_the_dialogue_gives_records_of_attitude(text: Station) -> None:
    test = AhrsTest()
    text.send(test.start(0.0))
    text.send(test.tick(10.0))
    text.wait(lambda: text.received.count(MARK) >= 20)
    attitudes = test.feed(bytes(text.received))
    assert test.state is AhrsTestState.STREAMING
    assert len(attitudes) >= 18
    assert test.skipped == 0
    assert all(abs(attitude.pitch_deg) < 3 and abs(attitude.roll_deg) < 3 for attitude in attitudes)
    assert all(20 < attitude.yaw_deg < 36 for attitude in attitudes)


def test_the_answer_and_the_records_are_the_exact_bytes(text: Station) -> None:
    begin(text)
    assert text.received.startswith(SYNCHRONISED)
    records = bytes(text.received).removeprefix(SYNCHRONISED)
    assert all(records[start : start + 4] == MARK for start in range(0, len(records) - 15, 16))


def test_q_ends_it_and_the_shell_is_back(text: Station) -> None:
    begin(text)
    text.send(QUIT)
    # Records that were on their way end before the shell's first answer.
    text.send(b"\nversion\n")
    text.wait(lambda: text.text.endswith(f"\r{VERSION}\n"))
    assert text.lines("param k_roll")[-1].startswith("k_roll")
    text.received.clear()
    assert text.table("status")["hil plan"] == "none"
    assert MARK not in text.received


def test_it_begins_only_when_it_was_announced(text: Station) -> None:
    text.send(SYNCHRONISE)
    text.wait(lambda: "unknown: #s00" in text.text)
    text.send(BEGIN)
    assert text.line("version2") == "unknown: version2 (try `help`)"
    assert text.line("#s00") == "unknown: #s00 (try `help`)"


def test_a_station_that_opens_the_line_ends_it(text: Station) -> None:
    begin(text)
    text.open_binary()
    text.received.clear()
    text.heartbeats(3)
    assert MARK not in text.received


def test_other_bytes_do_not_disturb_it(text: Station) -> None:
    begin(text)
    text.send(b"hello #QT #sim\r\n\0\xff")
    text.received.clear()
    text.wait(lambda: text.received.count(MARK) >= 5)
    assert text.frames == []
