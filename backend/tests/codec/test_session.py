"""The opening dialogue, told what time it is."""

from __future__ import annotations

from epf_gcs.codec.encode import encode_command, encode_telemetry
from epf_gcs.codec.frame import Frame, FrameDecoder
from epf_gcs.codec.session import Session, SessionState

OPEN = b"#QT\n"
ASK = encode_command("capabilities")
QUIET = encode_command("stop") + encode_command("exit_binary_mode")


def _frame(data: bytes) -> Frame:
    (event,) = FrameDecoder().feed(data)
    assert isinstance(event, Frame)
    return event


HEARTBEAT = _frame(encode_telemetry("heartbeat", *[0] * 12))
CAPABILITIES = _frame(encode_telemetry("capabilities", 1, 15, b"epf-board", b"1.0", 5))


def test_a_board_that_answers_is_extended() -> None:
    session = Session()
    assert session.open(100.0) == OPEN
    assert session.on_frame(HEARTBEAT, 100.1) == ASK
    assert session.state is SessionState.ASKING
    assert session.on_frame(CAPABILITIES, 100.2) == b""
    assert session.is_extended
    assert session.capabilities is not None
    assert session.capabilities["firmware_name"] == "epf-board"


def test_a_board_that_is_silent_for_half_a_second_is_legacy_and_is_not_asked_again() -> None:
    session = Session()
    session.open(0.0)
    sent = session.on_frame(HEARTBEAT, 0.1)
    now = 0.1
    while now < 5.0:
        now += 0.05
        sent += session.on_frame(HEARTBEAT, now)
        sent += session.tick(now)
        if now < 0.59:
            assert session.state is SessionState.ASKING
    assert sent == ASK
    assert session.state is SessionState.LEGACY
    assert session.is_open
    assert not session.is_extended


ACKNOWLEDGEMENT = _frame(encode_telemetry("acknowledgement", 0x100, 0))


def test_a_board_whose_answer_was_lost_is_asked_again_because_it_acknowledged_the_question() -> None:
    session = Session()
    session.open(0.0)
    session.on_frame(HEARTBEAT, 0.1)
    assert session.on_frame(ACKNOWLEDGEMENT, 0.12) == b"", "its answer may be on the way"
    assert session.tick(0.6) == ASK
    assert session.state is SessionState.ASKING
    session.on_frame(CAPABILITIES, 0.7)
    assert session.is_extended


def test_a_board_that_is_taken_for_legacy_is_asked_again_once_it_sends_what_no_deployed_board_does() -> None:
    session = Session()
    session.open(0.0)
    session.on_frame(HEARTBEAT, 0.1)
    session.tick(0.6)
    assert session.state is SessionState.LEGACY
    assert session.on_frame(ACKNOWLEDGEMENT, 30.0) == ASK
    assert session.state is SessionState.LEGACY, "it stays open meanwhile"
    session.on_frame(CAPABILITIES, 30.1)
    assert session.is_extended


def test_a_board_that_never_answers_is_asked_three_times_and_again_when_it_is_opened_anew() -> None:
    session = Session()
    for start in (0.0, 100.0):
        sent = session.open(start)
        for tenth in range(1, 300):
            now = start + tenth / 10
            sent += session.on_frame(HEARTBEAT, now) + session.on_frame(ACKNOWLEDGEMENT, now) + session.tick(now)
        assert sent == OPEN + 3 * ASK
        assert session.state is SessionState.LEGACY


def test_a_late_answer_still_proves_what_the_board_can_do() -> None:
    session = Session()
    session.open(0.0)
    session.on_frame(HEARTBEAT, 0.1)
    session.tick(0.7)
    session.on_frame(CAPABILITIES, 0.8)
    assert session.is_extended


def test_nothing_but_the_opening_line_is_sent_before_the_first_heartbeat() -> None:
    session = Session()
    sent = session.open(0.0)
    for tenth in range(1, 31):
        sent += session.tick(tenth / 10)
    assert sent == OPEN * 4
    assert session.heartbeat_age_s(3.0) is None


def test_a_board_that_restarted_in_text_mode_is_opened_again() -> None:
    session = Session()
    session.open(0.0)
    session.on_frame(HEARTBEAT, 0.1)
    session.on_frame(CAPABILITIES, 0.2)
    session.on_frame(HEARTBEAT, 1.0)
    assert session.deadline_s == 4.0
    assert session.tick(3.9) == b""
    assert session.tick(4.0) == OPEN
    assert not session.is_open
    assert session.capabilities is None
    assert session.on_frame(HEARTBEAT, 4.3) == ASK


def test_a_slow_parameter_task_is_not_taken_for_a_dead_board() -> None:
    session = Session()
    session.open(0.0)
    session.on_frame(HEARTBEAT, 0.1)
    session.on_frame(CAPABILITIES, 0.2)
    session.expect_heartbeat_every(10.0)
    session.on_frame(HEARTBEAT, 1.0)
    assert session.tick(30.9) == b""
    assert session.is_open
    assert session.tick(31.0) == OPEN


def test_a_fast_parameter_task_or_an_earlier_link_s_slow_one_changes_no_silence() -> None:
    session = Session()
    for period_s in (0.02, 10.0, 0.02):
        session.open(0.0)
        session.on_frame(HEARTBEAT, 0.1)
        session.on_frame(CAPABILITIES, 0.2)
        assert session.deadline_s == 3.1
        session.expect_heartbeat_every(period_s)
        session.on_frame(HEARTBEAT, 1.0)
        assert session.deadline_s == (4.0 if period_s < 1.0 else 31.0)
        session.close()


def test_an_answer_from_before_the_silence_opens_nothing() -> None:
    session = Session()
    session.open(0.0)
    assert session.on_frame(CAPABILITIES, 0.1) == b""
    assert session.state is SessionState.OPENING
    assert session.capabilities is None


def test_a_legacy_board_s_silence_counts_from_its_last_heartbeat() -> None:
    session = Session()
    session.open(0.0)
    session.on_frame(HEARTBEAT, 0.25)
    session.tick(0.75)
    assert session.state is SessionState.LEGACY
    assert session.deadline_s == 3.25


def test_the_age_of_the_heartbeat_grows_until_the_next() -> None:
    session = Session()
    session.open(10.0)
    session.on_frame(HEARTBEAT, 11.0)
    assert session.heartbeat_age_s(11.25) == 0.25
    session.on_frame(HEARTBEAT, 12.0)
    assert session.heartbeat_age_s(12.0) == 0.0


def test_closing_stops_the_streams_and_leaves_binary_mode_once() -> None:
    session = Session()
    assert session.close() == b""
    session.open(0.0)
    assert session.close() == QUIET
    assert session.close() == b""
    assert session.tick(99.0) == b""
    assert session.on_frame(HEARTBEAT, 100.0) == b""
