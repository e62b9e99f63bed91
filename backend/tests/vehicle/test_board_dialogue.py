"""The board's part alone, on a line and a clock in the test's hand: rubbish, silence, and who may wait."""

from __future__ import annotations

import pytest

from epf_gcs.codec.encode import encode_command, encode_telemetry
from epf_gcs.error_log import ErrorLog
from epf_gcs.errors import ConflictError
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.restart import Restart
from epf_gcs.vehicle.telemetry import Telemetry
from tests.support.held import HeldClock
from tests.support.outlet import KeptOutlet

AHRS_IS_ON = encode_telemetry("heartbeat", *[0] * 6, 1, *[0] * 5)
ALL_IS_OFF = encode_telemetry("heartbeat", *[0] * 12)
GPS = encode_telemetry("gps", 27.9, -15.4, 30.0, 0.0, 0.0, 0x38, 0x31, 0x41)
HIL_SURFACES = encode_telemetry("hil_surfaces", 0.1, 0.2, 0.3, 0.4)
ACKNOWLEDGEMENT = encode_telemetry("acknowledgement", 50, 0)


class Line:
    """A line that takes everything, or nothing."""

    baud = 115200
    backlog = 0

    def __init__(self) -> None:
        self.sent = b""
        self.is_full = False

    def write(self, data: bytes) -> bool:
        if not self.is_full:
            self.sent += data
        return not self.is_full


class User:
    """Who has the line for itself."""

    def __init__(self) -> None:
        self.got = b""

    def on_bytes(self, data: bytes) -> None:
        self.got += data

    def on_line_released(self) -> bytes:
        return b"q"


class Rig:
    """A board on a line."""

    def __init__(self) -> None:
        self.clock = HeldClock()
        self.outlet = KeptOutlet()
        self.errors = ErrorLog()
        self.telemetry = Telemetry(self.outlet, self.clock, lambda _: 1.0)
        self.opened = 0
        self.restarts: list[Restart] = []
        self.board = Board(
            self.clock,
            self.outlet,
            self.telemetry,
            self.errors,
            on_opened=self._opened,
            on_restarted=self.restarts.append,
        )
        self.line = Line()

    def _opened(self) -> None:
        self.opened += 1

    def later(self, seconds: float) -> None:
        self.clock.time_s += seconds
        self.board.tick()

    def open_legacy(self, heartbeat: bytes) -> None:
        """A heartbeat, and no answer to the question for capabilities."""
        self.board.on_bytes(heartbeat)
        self.later(0.6)
        assert self.board.is_open
        assert not self.board.session.is_extended


@pytest.fixture
def rig() -> Rig:
    made = Rig()
    made.board.attach(made.line)
    return made


def rubbish(rig: Rig) -> bool:
    return rig.board.hears_only_rubbish


def noise(rig: Rig, times: int) -> None:
    for _ in range(times):
        rig.board.on_bytes(b"\x81\x93")
        rig.board.tick()
        rig.board.tick()


def test_much_noise_and_no_heartbeat_is_rubbish(rig: Rig) -> None:
    noise(rig, 20)
    assert rig.board.damage["noise"] == 20
    assert not rubbish(rig), "it may be the end of a disturbance"
    noise(rig, 1)
    assert rubbish(rig)
    rig.board.detach()
    assert not rubbish(rig), "there is no line"
    rig.board.attach(rig.line)
    assert not rubbish(rig), "it was on the earlier link"
    noise(rig, 21)
    assert rubbish(rig)
    rig.board.on_bytes(ALL_IS_OFF)
    assert not rubbish(rig), "a heartbeat has the right rate"


def test_noise_between_text_is_no_wrong_rate(rig: Rig) -> None:
    rig.board.on_bytes(b"\nstatus: well\n" * 3)
    rig.later(0.1)
    rig.later(0.1)
    assert rig.board.damage["text"] > 0
    before = rig.board.damage["text"]
    noise(rig, 10 * before)
    assert not rubbish(rig)
    noise(rig, 1 + max(0, 20 - 10 * before))
    assert rubbish(rig)
    rig.board.attach(rig.line)
    noise(rig, 21)
    assert rubbish(rig), "the text of the earlier link does not count"


def test_a_legacy_board_that_was_silent_for_a_while_is_no_other_one_and_opens_again(rig: Rig) -> None:
    rig.open_legacy(AHRS_IS_ON)
    rig.later(3.1)
    assert not rig.board.is_open
    rig.later(0.1)
    rig.open_legacy(AHRS_IS_ON)
    assert rig.opened == 2
    assert rig.restarts == []


def test_a_legacy_board_whose_streams_are_off_after_a_silence_has_begun_anew(rig: Rig) -> None:
    rig.open_legacy(AHRS_IS_ON)
    rig.later(3.1)
    rig.later(0.1)
    rig.open_legacy(ALL_IS_OFF)
    assert rig.restarts == [Restart(rig.clock.now_s(), None)]


def test_who_has_the_line_for_itself_gets_every_byte_and_nothing_is_commanded_meanwhile(rig: Rig) -> None:
    rig.open_legacy(ALL_IS_OFF)
    heard, user = rig.board.frames_received, User()
    rig.board.acquire_line(user)
    rig.board.on_bytes(GPS)
    assert user.got == GPS
    assert rig.board.frames_received == heard
    assert rig.board.missing_bytes(GPS[:4]) == 0
    assert not rig.board.may_wait()
    with pytest.raises(ConflictError, match="AHRS test"):
        rig.board.check_commandable()
    rig.line.sent = b""
    rig.board.release_line()
    assert rig.line.sent.startswith(b"q"), "the user's farewell, then the dialogue anew"
    assert len(rig.line.sent) > 1
    rig.open_legacy(ALL_IS_OFF)
    rig.board.check_commandable()
    assert rig.restarts == []


def test_how_much_of_a_frame_is_missing_is_known_and_reads_may_wait_for_it(rig: Rig) -> None:
    rig.open_legacy(ALL_IS_OFF)
    assert rig.board.may_wait()
    rig.board.on_bytes(GPS[:20])
    assert rig.board.missing_bytes() == len(GPS) - 20
    assert rig.board.missing_bytes(GPS[20:30]) == len(GPS) - 20, "what comes next is a part of it"
    with rig.board.listening(lambda _frame, _meant: None):
        assert not rig.board.may_wait(), "an answer is awaited"
    rig.board.on_bytes(GPS[20:])
    assert rig.telemetry.newest("gps") is not None
    assert rig.board.missing_bytes(GPS[:16]) == len(GPS), "the next frame, which has only begun"


def test_only_what_left_is_counted_as_sent(rig: Rig) -> None:
    before = rig.board.bytes_out
    assert rig.board.write(b"12345")
    rig.line.is_full = True
    assert not rig.board.write(b"678")
    assert rig.board.bytes_out == before + 5


def test_damage_is_counted_beside_good_frames_of_the_same_read(rig: Rig) -> None:
    broken = bytearray(GPS)
    broken[12] ^= 1
    rig.board.on_bytes(bytes(broken) + GPS)
    assert (rig.board.frames_received, rig.board.frames_damaged) == (1, 1)
    assert rig.board.damage == {"bad_checksum": 1, "remains": 1}
    assert rig.errors.counts["line_garbage"] == 1, "the rest of a bad frame is no other fault"
    rig.board.on_bytes(b"\x81\x93\nstatus: well\n")
    assert rig.board.frames_damaged == 1, "neither noise nor text was a frame"
    assert rig.errors.counts["line_garbage"] == 2, "but noise is a fault"


def test_a_topic_is_as_old_as_its_newest_sample(rig: Rig) -> None:
    assert rig.telemetry.age_s("gps") is None
    rig.board.on_bytes(GPS)
    assert rig.telemetry.age_s("gps") == 0.0
    rig.later(1.5)
    assert rig.telemetry.age_s("gps") == pytest.approx(1.5)
    rig.board.on_bytes(GPS)
    assert rig.telemetry.age_s("gps") == 0.0


def test_frames_wait_for_the_next_flush_unless_an_answer_is_awaited_or_comes(rig: Rig) -> None:
    rig.outlet.is_lazy = True
    heard: list[str] = []
    rig.board.listen("acknowledgement", lambda frame, _meant: heard.append(frame.message.name))
    rig.board.on_bytes(GPS)
    assert rig.outlet.samples == []
    rig.board.on_bytes(ACKNOWLEDGEMENT)
    assert heard == ["acknowledgement"]
    assert [topic for topic, _, _ in rig.outlet.samples] == ["gps"], "what came before it is not overtaken"
    rig.outlet.samples.clear()
    with rig.board.listening(lambda frame, _meant: heard.append(frame.message.name)):
        rig.board.on_bytes(GPS)
        assert heard[1:] == ["gps"]
    rig.outlet.samples.clear()
    rig.board.on_bytes(GPS)
    assert rig.outlet.samples == []


def an_extended_board(uptime_ms: int) -> bytes:
    return encode_telemetry("capabilities", 1, 15, b"epf-board", b"1.0", uptime_ms)


def test_an_extended_board_whose_uptime_began_again_has_begun_anew_and_one_that_was_only_silent_has_not(
    rig: Rig,
) -> None:
    for uptime_ms in (50_000, 55_000, 2_000):
        rig.board.on_bytes(ALL_IS_OFF + an_extended_board(uptime_ms))
        assert rig.board.session.state == "extended", "at once"
        assert rig.board.capabilities()["uptime_ms"] == uptime_ms
        rig.later(3.1)
        assert rig.board.session.state == "opening"
        rig.later(1.9)
        assert rig.board.capabilities() == {}
    assert rig.opened == 3
    assert rig.restarts == [Restart(rig.clock.now_s() - 5.0, 2_000)]


def test_a_board_whose_answer_is_lost_is_asked_again_and_is_not_taken_for_a_deployed_one(rig: Rig) -> None:
    rig.board.on_bytes(ALL_IS_OFF + encode_telemetry("acknowledgement", 0x100, 0))
    rig.later(0.6)
    rig.board.on_bytes(an_extended_board(5_000))
    assert rig.board.session.state == "extended"
    assert rig.line.sent.count(encode_command("capabilities")) == 2


def test_a_legacy_board_that_speaks_text_while_it_is_opened_has_begun_anew_though_its_streams_are_on(rig: Rig) -> None:
    rig.open_legacy(AHRS_IS_ON)
    rig.board.on_bytes(b"status: well\n")
    rig.later(3.1)
    rig.later(0.1)
    rig.board.on_bytes(AHRS_IS_ON + b"status: well\n")
    rig.open_legacy(AHRS_IS_ON)
    assert rig.restarts == [], "what it says in binary mode says nothing"
    rig.later(3.1)
    rig.board.on_bytes(b"EPF board\n")
    rig.later(0.1)
    rig.open_legacy(AHRS_IS_ON)
    assert len(rig.restarts) == 1


def test_a_board_that_is_attached_again_is_opened_and_told_again_with_nothing_of_the_line_before(rig: Rig) -> None:
    assert rig.board.baud == 115200
    rig.open_legacy(AHRS_IS_ON)
    rig.board.on_bytes(GPS[:20])
    rig.board.detach()
    assert (rig.board.link, rig.board.is_open) == (None, False)
    assert rig.board.damage["cut_short"] == 1, "half a frame will never be whole"
    rig.line.sent = b""
    rig.board.on_bytes(GPS[20:])
    rig.board.attach(rig.line)
    assert rig.line.sent == b"#QT\n"
    assert rig.board.heartbeat_age_s() is None
    rig.open_legacy(ALL_IS_OFF)
    assert rig.board.heartbeat_age_s() == pytest.approx(0.6)
    assert rig.opened == 2
    assert rig.restarts == [], "it may be another board"
    assert rig.telemetry.newest("gps") is None


def test_a_line_that_is_gone_delivers_nothing_and_takes_nothing(rig: Rig) -> None:
    delivered: list[bool] = []
    rig.board.attach(rig.line, deliver=lambda: delivered.append(True))
    rig.board.acquire_line(User())
    rig.board.detach()
    assert rig.board.exclusive_user is None
    rig.board.check_commandable()
    rig.line.sent = b""
    with rig.board.listening(lambda _frame, _meant: None):
        assert delivered == []
    rig.board.release_line()
    rig.board.say_goodbye()
    rig.later(5.0)
    assert rig.line.sent == b""


def test_the_farewell_ends_what_has_the_line_for_itself_then_the_dialogue_and_comes_once(rig: Rig) -> None:
    rig.open_legacy(ALL_IS_OFF)
    rig.line.sent = b""
    rig.board.say_goodbye()
    goodbye = rig.line.sent
    assert goodbye == encode_command("stop") + encode_command("exit_binary_mode")
    rig.board.say_goodbye()
    assert rig.line.sent == goodbye
    rig.board.attach(rig.line)
    rig.line.sent = b""
    rig.board.acquire_line(User())
    assert rig.line.sent == goodbye, "before another has the line the board is silent"
    rig.board.say_goodbye()
    assert rig.line.sent == goodbye + b"q"


def test_half_a_frame_from_before_the_line_was_given_away_joins_nothing_that_comes_after(rig: Rig) -> None:
    rig.open_legacy(ALL_IS_OFF)
    before = rig.board.bytes_in
    rig.board.on_bytes(GPS[:20])
    rig.board.acquire_line(User())
    assert rig.board.damage["cut_short"] == 1
    rig.board.on_bytes(b"attitudes")
    assert rig.board.bytes_in == before + 29
    rig.board.release_line()
    rig.board.on_bytes(GPS[20:])
    rig.open_legacy(ALL_IS_OFF)
    assert rig.opened == 2
    assert rig.telemetry.newest("gps") is None


def test_what_moves_the_simulator_goes_first_and_waits_for_nobody(rig: Rig) -> None:
    rig.outlet.is_lazy = True
    urgent: list[tuple[str, int]] = []
    rig.board.on_urgent = lambda frame: urgent.append((frame.message.name, rig.board.frames_received))
    servos_in = encode_telemetry("servos_in", *[0.5] * 12)
    rig.board.on_bytes(GPS + HIL_SURFACES + ACKNOWLEDGEMENT + servos_in)
    assert urgent == [("hil_surfaces", 0), ("servos_in", 0)]
    assert rig.board.frames_received == 4
    assert rig.telemetry.newest("servos_in") is not None, "viewers see it too"


def test_a_line_of_text_is_shown_as_it_came_and_one_of_white_space_is_not(rig: Rig) -> None:
    rig.board.on_bytes(b"\r\n\t status: all is well \r\n")
    assert rig.outlet.events == [("console", {"direction": "received", "text": "status: all is well", "client": None})]
    assert rig.board.damage == {"text": 2}
    rig.board.on_bytes(b"beep \x07\n\xc3\xa4\n")
    assert rig.board.damage == {"text": 2, "noise": 2}
    assert len(rig.outlet.events) == 1


def test_text_that_comes_in_pieces_is_one_line_until_the_board_pauses(rig: Rig) -> None:
    for piece in (b"sta", b"tus: ", b"well"):
        rig.board.on_bytes(piece)
        rig.later(0.1)
    assert rig.outlet.events == []
    rig.later(0.1)
    assert [data["text"] for _, data in rig.outlet.events] == ["status: well"]


def test_examples_of_the_emulation_mix_with_nothing_of_a_board_and_nothing_is_commanded(rig: Rig) -> None:
    rig.board.on_bytes(GPS)
    assert rig.board.frame_statistics.heard["gps"].count == 1
    rig.board.attach(rig.line, is_emulated=True)
    assert rig.board.frame_statistics.heard["gps"].count == 0
    with pytest.raises(ConflictError, match="emulation"):
        rig.board.check_commandable()
    rig.board.on_bytes(GPS)
    rig.board.detach()
    rig.board.check_commandable()
    assert rig.board.frame_statistics.heard["gps"].count == 0
    values = rig.telemetry.newest("gps")
    assert values is not None
    assert set(values.values()) == {None}
    assert rig.telemetry.age_s("gps") is None, "as if it had never been heard"
    rig.board.attach(rig.line)
    rig.board.on_bytes(GPS)
    rig.board.detach()
    assert rig.board.frame_statistics.heard["gps"].count == 1, "a board's stay"
    assert rig.telemetry.newest("gps") != values


def test_frames_that_wait_are_counted_as_soon_as_anybody_looks(rig: Rig) -> None:
    rig.outlet.is_lazy = True
    rig.board.on_bytes(GPS)
    assert rig.board.frame_statistics.heard["gps"].count == 1
