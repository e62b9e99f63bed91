"""The 17 gains and the flight plans over REST."""

from __future__ import annotations

from typing import Any

import pytest

from epf_gcs.codec.messages_gen import ROUTES
from tests.support.fake_board import FakeBoard, law_row, own_row
from tests.support.gateway import Gateway
from tests.support.waiting import eventually

GANDO = [
    {
        "latitude_deg": waypoint.latitude_deg,
        "longitude_deg": waypoint.longitude_deg,
        "altitude_ft": waypoint.altitude_ft,
        "speed_kt": waypoint.speed_kt,
    }
    for waypoint in ROUTES["gando"].waypoints
]


def by_name(answer: Any) -> dict[str, dict[str, Any]]:
    return {parameter["name"]: parameter for parameter in answer.json()["parameters"]}


def set_commands(board: FakeBoard) -> list[str]:
    return [name for name in board.received if name.startswith("set_k")]


def test_before_a_load_nothing_is_known(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    parameters = by_name(gateway.http.get("/parameters"))
    assert len(parameters) == 17
    assert {one["state"] for one in parameters.values()} == {"unknown"}
    assert parameters["k_pitch"]["value"] is None
    assert (parameters["k_pitch"]["minimum"], parameters["k_pitch"]["default"]) == (0, 2)
    assert board.count("load_autopilot_parameters") == 0


@pytest.mark.parametrize("kind", ["board", "legacy_board"])
def test_a_load_only_reads(gateway: Gateway, request: pytest.FixtureRequest, kind: str) -> None:
    board: FakeBoard = request.getfixturevalue(kind)
    gateway.open_board(board.url)
    board.gains["k_int_pitch"] = 0.1
    parameters = by_name(gateway.http.post("/parameters/load").raise_for_status())
    assert (parameters["k_int_pitch"]["value"], parameters["k_int_pitch"]["state"]) == (0.1, "loaded")
    assert parameters["k_div_velocidad"]["value"] == 700
    assert set_commands(board) == []


@pytest.mark.parametrize("kind", ["board", "legacy_board"])
def test_a_gain_is_confirmed_by_reading_it_back(gateway: Gateway, request: pytest.FixtureRequest, kind: str) -> None:
    board: FakeBoard = request.getfixturevalue(kind)
    gateway.open_board(board.url)
    answer = gateway.http.patch("/parameters", json={"k_pitch": 2.5, "k_div_velocidad": 800})
    parameters = by_name(answer.raise_for_status())
    assert (parameters["k_pitch"]["value"], parameters["k_pitch"]["state"]) == (2.5, "confirmed")
    assert (parameters["k_div_velocidad"]["value"], parameters["k_div_velocidad"]["state"]) == (800, "confirmed")
    assert parameters["k_roll"]["state"] == "loaded"
    assert board.gains["k_pitch"] == 2.5
    assert set(set_commands(board)) == {"set_k_pitch", "set_k_div_velocidad"}


def test_a_gain_that_the_board_refuses_is_rejected_with_the_boards_value(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    board.refuse["set_k_pitch"] = 1
    parameters = by_name(gateway.http.patch("/parameters", json={"k_pitch": 2.5}).raise_for_status())
    assert (parameters["k_pitch"]["value"], parameters["k_pitch"]["state"]) == (2.0, "rejected")


def test_without_a_read_back_nothing_is_claimed(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    board.ignore["load_autopilot_parameters"] = 99
    answer = gateway.http.patch("/parameters", json={"k_pitch": 2.5})
    assert (answer.status_code, answer.json()["code"]) == (502, "parameters_not_read")
    assert by_name(gateway.http.get("/parameters"))["k_pitch"]["state"] == "unknown"


@pytest.mark.parametrize(
    ("changes", "status", "code", "words"),
    [
        ({"k_pitch": 100}, 422, "parameter_out_of_range", "k_pitch must be in 0..99.99, not 100."),
        ({"k_roll": 2, "k_pitch": -0.1}, 422, "parameter_out_of_range", "k_pitch must be in 0..99.99"),
        ({"k_div_velocidad": 700.5}, 422, "parameter_out_of_range", "must be a whole number"),
        ({"k_yaw": 1}, 404, "parameter_unknown", "There is no parameter 'k_yaw'"),
        ({}, 422, "invalid_request", "at least 1 item"),
        ({"k_pitch": "much"}, 422, "invalid_request", "'k_pitch' cannot be taken"),
        ({"k_pitch": None}, 422, "invalid_request", "'k_pitch' cannot be taken"),
    ],
)
def test_a_wrong_value_names_field_and_range_and_nothing_is_sent(
    gateway: Gateway, board: FakeBoard, changes: dict[str, Any], status: int, code: str, words: str
) -> None:
    gateway.open_board(board.url)
    answer = gateway.http.patch("/parameters", json=changes)
    assert (answer.status_code, answer.json()["code"]) == (status, code)
    assert words in answer.json()["detail"]
    assert set_commands(board) == []


def own_of(answer: Any) -> tuple[Any, Any]:
    own = answer.json()["own"]
    return own["table"], own["values"]


def test_the_boards_own_gains_are_listed_with_their_definitions_and_written_by_name(
    gateway: Gateway, board: FakeBoard
) -> None:
    board.describe(law_row(0), own_row(1), own_row(2, "Faulty"))
    gateway.open_board(board.url)
    eventually(
        lambda: {one["value"] for one in own_of(gateway.http.get("/parameters"))[1].values()} == {0, 3},
        "its own gains are read",
    )
    table, _ = own_of(gateway.http.get("/parameters"))
    assert table["gains"][1] == {
        "row": 1,
        "name": "line_k_bank",
        "group": "line",
        "type": "f32",
        "unit": "1/rad",
        "minimum": 0.1,
        "maximum": 10,
        "step": 0.1,
        "default": 3,
        "choices": [],
        "needs_restart": False,
        "doc": "Aileron for each radian of bank error.",
    }
    assert table["left_out"] == [{"row": 2, "name": "Faulty", "reason": "name"}]
    _, values = own_of(gateway.http.patch("/parameters", json={"line_k_bank": 4.5}).raise_for_status())
    assert (values["line_k_bank"]["value"], values["line_k_bank"]["state"]) == (4.5, "confirmed")
    _, values = own_of(gateway.http.post("/parameters/undo").raise_for_status())
    assert (values["line_k_bank"]["value"], values["line_k_bank"]["state"]) == (3, "confirmed")
    answer = gateway.http.patch("/parameters", json={"guidance_law": 2})
    assert (answer.status_code, answer.json()["code"]) == (422, "parameter_out_of_range")


def test_a_board_that_does_not_describe_itself_has_no_gains_of_its_own(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    table, values = own_of(gateway.http.get("/parameters"))
    assert (table["state"], table["gains"], values) == ("none", [], {})


def test_storing_needs_the_boards_word(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    assert gateway.http.post("/parameters/store").json()["state"] == "confirmed"
    board.refuse["store_parameters"] = 4
    answer = gateway.http.post("/parameters/store").json()
    assert (answer["state"], answer["reason"]) == ("rejected", "storage_failed")


def test_a_legacy_board_cannot_store_and_has_no_plans_to_transfer(gateway: Gateway, legacy_board: FakeBoard) -> None:
    gateway.open_board(legacy_board.url)
    for answer in (
        gateway.http.post("/parameters/store"),
        gateway.http.get("/missions/hil"),
        gateway.http.put("/missions/hil", json={"waypoints": GANDO}),
    ):
        assert (answer.status_code, answer.json()["code"]) == (409, "not_supported")
    assert legacy_board.received.count("capabilities") == len(
        [name for name in legacy_board.received if name in ("capabilities", "store_parameters", "mission_read")]
    )


def test_a_plan_is_written_whole_and_read_back(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    answer = gateway.http.put("/missions/hil", json={"waypoints": GANDO}).raise_for_status().json()
    assert answer == {"plan": "hil", "waypoints": GANDO}
    assert [name for name in board.received if name.startswith("mission")] == [
        "mission_begin",
        *["mission_item"] * len(GANDO),
        "mission_commit",
        "mission_read",
    ]
    assert gateway.http.get("/missions/hil").json()["waypoints"] == GANDO
    assert gateway.http.get("/missions/flight").json()["waypoints"] == []


@pytest.mark.parametrize("step", ["mission_begin", "mission_item", "mission_commit"])
def test_a_plan_that_the_board_refuses_leaves_the_old_one(gateway: Gateway, board: FakeBoard, step: str) -> None:
    gateway.open_board(board.url)
    gateway.http.put("/missions/hil", json={"waypoints": GANDO[:2]}).raise_for_status()
    board.refuse[step] = 1
    answer = gateway.http.put("/missions/hil", json={"waypoints": GANDO})
    assert (answer.status_code, answer.json()["code"]) == (502, "mission_refused")
    assert f"did not accept {step} (bad_value)" in answer.json()["detail"]
    assert gateway.http.get("/missions/hil").json()["waypoints"] == GANDO[:2]


def test_a_plan_that_differs_after_the_read_is_not_confirmed(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    board.ignore["mission_commit"] = 0
    gateway.http.put("/missions/hil", json={"waypoints": GANDO}).raise_for_status()
    board.plans[1] = board.plans[1][:3]
    board.refuse["mission_commit"] = 0

    original = board.plans
    board.plans = {0: [], 1: original[1]}
    answer = gateway.http.get("/missions/hil").json()
    assert len(answer["waypoints"]) == 3


def test_a_plan_that_does_not_come_whole_is_no_plan(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    gateway.http.put("/missions/hil", json={"waypoints": GANDO}).raise_for_status()
    board.lose_item = 3
    answer = gateway.http.get("/missions/hil")
    assert (answer.status_code, answer.json()["code"]) == (502, "mission_not_read")


@pytest.mark.parametrize(
    ("body", "field"),
    [
        ({"waypoints": []}, "waypoints"),
        ({"waypoints": GANDO * 13}, "waypoints"),
        ({"waypoints": [{**GANDO[0], "latitude_deg": 91}]}, "waypoints.0.latitude_deg"),
        ({"waypoints": [{**GANDO[0], "heading_deg": 1}]}, "waypoints.0.heading_deg"),
        ({}, "waypoints"),
    ],
)
def test_a_wrong_plan_is_named_and_nothing_is_sent(
    gateway: Gateway, board: FakeBoard, body: dict[str, Any], field: str
) -> None:
    gateway.open_board(board.url)
    answer = gateway.http.put("/missions/hil", json=body)
    assert (answer.status_code, answer.json()["params"]["field"]) == (422, field)
    assert board.count("mission_begin") == 0


def test_the_viewers_hear_of_changed_gains_and_plans(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    with gateway.stream() as stream:
        operator = {"X-Client": stream.hello["client"]}
        gateway.http.patch("/parameters", json={"k_pitch": 2.5}, headers=operator).raise_for_status()
        states = [stream.event("parameter")["parameters"].get("k_pitch") for _ in range(3)]
        assert states[0] == {"value": 2, "state": "loaded", "loaded": 2}
        assert states[1] == {"value": 2, "state": "pending", "loaded": 2}
        assert states[-1] == {"value": 2.5, "state": "confirmed", "loaded": 2}
        gateway.http.put("/missions/hil", json={"waypoints": GANDO}, headers=operator).raise_for_status()
        assert [stream.event("mission")["state"] for _ in range(2)] == ["pending", "confirmed"]
