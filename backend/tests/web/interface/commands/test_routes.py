"""Commands over REST: each with its proof, each mistake with its sentence."""

from __future__ import annotations

from typing import Any

import pytest

from tests.support.fake_board import FakeBoard
from tests.support.gateway import Gateway
from tests.support.waiting import eventually


def post(gateway: Gateway, name: str, value: Any = None) -> dict[str, Any]:
    answer: dict[str, Any] = gateway.http.post(f"/commands/{name}", json={"value": value}).raise_for_status().json()
    return answer


def test_an_extended_board_proves_by_acknowledgement(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    outcome = post(gateway, "ahrs_on")
    assert (outcome["state"], outcome["by"]) == ("confirmed", "acknowledgement")
    assert board.flags["ahrs"] == 1


def test_a_refused_command_is_rejected_with_the_boards_reason(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    board.refuse["autopilot_on"] = 2
    outcome = post(gateway, "autopilot_on")
    assert (outcome["state"], outcome["reason"]) == ("rejected", "bad_state")
    assert gateway.status()["errors"]["command_rejected"] == 1


def test_a_lost_command_is_sent_once_more(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    board.ignore["gps_on"] = 1
    assert post(gateway, "gps_on")["state"] == "confirmed"
    assert board.count("gps_on") == 2


def test_a_command_without_any_answer_times_out(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    board.ignore["gps_on"] = 99
    assert post(gateway, "gps_on")["state"] == "timed_out"
    assert board.count("gps_on") == 2


def test_a_step_of_the_plan_is_never_sent_twice(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    board.ignore["hil_fms_next_waypoint"] = 1
    assert post(gateway, "hil_fms_next_waypoint")["state"] == "timed_out"
    assert board.count("hil_fms_next_waypoint") == 1


def test_a_legacy_board_proves_by_its_heartbeat(gateway: Gateway, legacy_board: FakeBoard) -> None:
    gateway.open_board(legacy_board.url)
    assert gateway.status()["board"]["mode"] == "legacy"
    outcome = post(gateway, "control_source", "joystick")
    assert (outcome["state"], outcome["by"]) == ("confirmed", "heartbeat")
    assert gateway.http.get("/hil").json()["source"] == "joystick"


def test_a_legacy_board_proves_a_gain_by_reading_it_back(gateway: Gateway, legacy_board: FakeBoard) -> None:
    gateway.open_board(legacy_board.url)
    outcome = post(gateway, "set_k_pitch", 2.5)
    assert (outcome["state"], outcome["by"]) == ("confirmed", "read_back")


def test_what_a_legacy_board_cannot_prove_is_only_sent(gateway: Gateway, legacy_board: FakeBoard) -> None:
    gateway.open_board(legacy_board.url)
    outcome = post(gateway, "servo_out", {"servo": 3, "position": 0.5})
    assert (outcome["state"], outcome["by"]) == ("sent", "none")
    eventually(lambda: legacy_board.count("servo_out") == 1, "the command arrives")
    assert legacy_board.arguments[-1] == (3, 0.5)


def test_an_extension_is_not_sent_to_a_legacy_board(gateway: Gateway, legacy_board: FakeBoard) -> None:
    gateway.open_board(legacy_board.url)
    answer = gateway.http.post("/commands/select_airspeed_source", json={"value": "pitot"})
    assert (answer.status_code, answer.json()["code"]) == (409, "not_supported")
    post(gateway, "ahrs_on")
    assert legacy_board.count("select_airspeed_source") == 0


def test_the_viewers_see_what_the_operator_did(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    with gateway.stream() as stream:
        client = stream.hello["client"]
        gateway.http.post("/commands/gps_on", headers={"X-Client": client}).raise_for_status()
        pending = stream.event("command")
        final = stream.event("command")
    assert (pending["name"], pending["state"], pending["client"]) == ("gps_on", "pending", client)
    assert (final["id"], final["state"], final["by"]) == (pending["id"], "confirmed", "acknowledgement")


@pytest.mark.parametrize(
    ("name", "value", "status", "code"),
    [
        ("fly_to_the_moon", None, 404, "command_unknown"),
        ("xplane_info", [0.0] * 15, 404, "command_unknown"),
        ("set_fms_task_rate", 49, 422, "value_not_allowed"),
        ("set_fms_task_rate", 100.5, 422, "value_not_allowed"),
        ("set_fms_task_rate", "fast", 422, "value_not_allowed"),
        ("set_fms_task_rate", None, 422, "value_not_allowed"),
        ("servo_out", [20, 0.0], 422, "value_not_allowed"),
        ("servo_out", {"servo": 1}, 422, "value_not_allowed"),
        ("servo_out", {"servo": 1, "position": 0.0, "speed": 1}, 422, "value_not_allowed"),
        ("start", 1, 422, "value_not_allowed"),
    ],
)
def test_a_wrong_command_changes_nothing(
    gateway: Gateway, board: FakeBoard, name: str, value: Any, status: int, code: str
) -> None:
    gateway.open_board(board.url)
    before = list(board.received)
    answer = gateway.http.post(f"/commands/{name}", json={"value": value})
    problem = answer.json()
    assert (answer.status_code, problem["code"]) == (status, code), problem
    assert answer.headers["content-type"] == "application/problem+json"
    assert problem["detail"].endswith(".")
    assert board.received == before
    assert gateway.status()["errors"][code] == 1


def test_a_number_beyond_all_numbers_is_refused(gateway: Gateway) -> None:
    content = '{"value": 1' + "0" * 400 + "}"
    answer = gateway.http.post(
        "/commands/set_fms_task_rate", content=content, headers={"Content-Type": "application/json"}
    )
    assert (answer.status_code, answer.json()["code"]) == (422, "invalid_request")
    assert answer.json()["params"] == {"field": "value"}


def test_without_a_board_a_command_is_refused(gateway: Gateway) -> None:
    answer = gateway.http.post("/commands/start")
    assert (answer.status_code, answer.json()["code"]) == (409, "board_not_open")


def test_the_list_has_every_command_that_may_be_sent(gateway: Gateway) -> None:
    commands = {command["name"]: command for command in gateway.http.get("/commands").json()["commands"]}
    assert commands["control_source"]["arguments"][0]["names"] == {"rc": 0, "joystick": 1}
    assert commands["set_servos_task_rate"]["arguments"][0]["minimum"] == 20
    assert "mission_commit" not in commands


def test_a_line_of_text_goes_to_the_board_and_its_answer_comes_back(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    with gateway.stream() as stream:
        gateway.http.post(
            "/console", json={"text": "help"}, headers={"X-Client": stream.hello["client"]}
        ).raise_for_status()
        assert stream.event("console")["direction"] == "sent"
        eventually(lambda: b"help\n" in board.raw, "the line arrives")
        board.send(b"\rhelp: this text\n")
        assert stream.event("console") == {"direction": "received", "text": "help: this text", "client": None}
    assert gateway.status()["board"]["frames_damaged"] == 0
