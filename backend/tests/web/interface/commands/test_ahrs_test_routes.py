"""The AHRS test through the gateway: begun and ended with proof, and nothing else meanwhile."""

from __future__ import annotations

from typing import Any

import pytest

from epf_gcs.codec.ahrs_test import BEGIN, QUIT, SYNCHRONISE
from epf_gcs.codec.encode import EMPTY_COMMANDS
from epf_gcs.codec.messages_gen import OPEN_BINARY_MODE
from tests.support.fake_board import FakeBoard
from tests.support.gateway import Gateway
from tests.support.waiting import eventually


def start(gateway: Gateway) -> dict[str, Any]:
    answer: dict[str, Any] = gateway.http.post("/ahrs-test").raise_for_status().json()
    return answer


def stop(gateway: Gateway) -> dict[str, Any]:
    answer: dict[str, Any] = gateway.http.delete("/ahrs-test").raise_for_status().json()
    return answer


def stage(gateway: Gateway) -> str:
    return str(gateway.status()["board"]["ahrs_test"])


def open_quiet(gateway: Gateway, board: FakeBoard) -> None:
    """Open it, and forget the bytes of the opening."""
    gateway.open_board(board.url)
    board.forget_bytes()


@pytest.mark.parametrize("which", ["board", "legacy_board"])
def test_it_is_confirmed_by_its_first_record(gateway: Gateway, which: str, request: pytest.FixtureRequest) -> None:
    board: FakeBoard = request.getfixturevalue(which)
    open_quiet(gateway, board)
    outcome = start(gateway)
    assert (outcome["state"], outcome["by"]) == ("confirmed", "read_back")
    assert stage(gateway) == "running"
    left = EMPTY_COMMANDS["stop"] + EMPTY_COMMANDS["exit_binary_mode"]
    assert left + BEGIN + SYNCHRONISE in board.raw


def test_its_attitude_is_a_topic_of_the_stream(gateway: Gateway, board: FakeBoard) -> None:
    open_quiet(gateway, board)
    board.attitude_deg = (-170.0, 12.5, -45.0)
    start(gateway)
    with gateway.stream() as stream:
        assert stream.sample("ahrs_test") == {"yaw_deg": -170.0, "pitch_deg": 12.5, "roll_deg": -45.0}
    eventually(lambda: gateway.status()["topics"]["ahrs_test"]["rate_hz"] > 5, "it has a rate")


def test_nothing_else_is_sent_and_the_reason_is_said(gateway: Gateway, board: FakeBoard) -> None:
    open_quiet(gateway, board)
    start(gateway)
    board.forget_bytes()
    for path, body in (("/commands/ahrs_on", {}), ("/console", {"text": "q"})):
        answer = gateway.http.post(path, json=body)
        assert (answer.status_code, answer.json()["code"]) == (409, "ahrs_test_running")
    assert gateway.http.put("/hil", json={"source": "joystick"}).json()["code"] == "ahrs_test_running"
    assert board.raw == b""


def test_its_silence_is_no_alarm_and_the_link_is_open(gateway: Gateway, board: FakeBoard) -> None:
    open_quiet(gateway, board)
    gateway.http.put("/alarms/thresholds", json={"heartbeat_lost_s": 0.5}).raise_for_status()
    start(gateway)
    eventually(lambda: gateway.status()["board"]["heartbeat_age_s"] > 1.0, "the heartbeat is long gone")
    status = gateway.status()
    assert status["alarms"] == []
    assert status["board"]["state"] == "open"


def test_its_end_is_confirmed_by_the_heartbeat_and_the_streams_are_back(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    gateway.http.post("/commands/ahrs_on", json={}).raise_for_status()
    start(gateway)
    board.forget_bytes()
    outcome = stop(gateway)
    assert (outcome["state"], outcome["by"]) == ("confirmed", "heartbeat")
    assert board.raw.startswith(QUIT + OPEN_BINARY_MODE)
    assert stage(gateway) == "off"
    eventually(lambda: board.flags["ahrs"] == 1, "the stream that was wanted is on again")
    assert gateway.status()["board"]["frames_damaged"] == 0


def test_a_board_without_the_test_is_back_in_its_frames(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    board.has_ahrs_test = False
    assert start(gateway)["state"] == "timed_out"
    eventually(lambda: gateway.status()["board"]["state"] == "open", "commands work again")
    assert stage(gateway) == "off"


def test_a_board_that_agrees_and_sends_no_attitude_has_not_begun(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    board.sends_attitude = False
    assert start(gateway)["state"] == "timed_out"
    eventually(lambda: gateway.status()["board"]["state"] == "open", "commands work again")


@pytest.mark.parametrize("flag", ["autopilot", "autopilot_hil"])
def test_a_flying_board_is_not_left_alone(gateway: Gateway, board: FakeBoard, flag: str) -> None:
    open_quiet(gateway, board)
    board.flags[flag] = 1
    eventually(lambda: gateway.http.get("/telemetry").json()["heartbeat"]["values"][flag] is True, "it flies")
    answer = gateway.http.post("/ahrs-test")
    assert (answer.status_code, answer.json()["code"]) == (409, "ahrs_test_in_flight")
    assert board.raw == b""


def test_a_board_that_falls_silent_ends_the_test(gateway: Gateway, board: FakeBoard) -> None:
    open_quiet(gateway, board)
    start(gateway)
    board.restart()
    eventually(lambda: stage(gateway) == "off", "the test is over")
    eventually(lambda: gateway.status()["board"]["mode"] == "extended", "the board is opened anew")
    assert gateway.status()["errors"]["ahrs_test_lost"] == 1


def test_closing_the_link_ends_the_test_on_the_board(gateway: Gateway, board: FakeBoard) -> None:
    open_quiet(gateway, board)
    start(gateway)
    gateway.http.delete("/links/board").raise_for_status()
    eventually(lambda: board.raw.endswith(QUIT), "the board is told")
    assert stage(gateway) == "off"


def test_without_a_board_or_in_the_emulation_it_is_refused(gateway: Gateway) -> None:
    assert gateway.http.post("/ahrs-test").json()["code"] == "board_not_open"
    gateway.open_board("emulation:")
    assert gateway.http.post("/ahrs-test").json()["code"] == "emulation_running"


def test_a_second_start_changes_nothing(gateway: Gateway, board: FakeBoard) -> None:
    open_quiet(gateway, board)
    start(gateway)
    board.forget_bytes()
    assert start(gateway)["state"] == "confirmed"
    assert board.raw == b""


def test_an_end_without_a_test_leaves_the_board_as_it_is(gateway: Gateway, board: FakeBoard) -> None:
    open_quiet(gateway, board)
    assert stop(gateway)["state"] == "confirmed"
    assert board.raw == b""
