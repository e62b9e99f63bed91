"""The alarms over REST."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

from epf_gcs.codec.encode import encode_telemetry
from tests.support.fake_board import FakeBoard
from tests.support.gateway import Gateway, running_gateway
from tests.support.waiting import eventually


def book(gateway: Gateway) -> dict[str, Any]:
    answer: dict[str, Any] = gateway.http.get("/alarms").raise_for_status().json()
    return answer


def limits(answer: Any) -> dict[str, float]:
    return {one["name"]: one["value"] for one in answer.raise_for_status().json()["thresholds"]}


def test_an_alarm_is_acknowledged_and_ends_in_the_history(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    assert book(gateway) == {"active": [], "past": []}
    with gateway.stream() as stream:
        operator = {"X-Client": stream.hello["client"]}
        board.silent = True
        assert stream.event("alarm")["active"] is True
        eventually(lambda: len(book(gateway)["active"]) == 1, "it is active")
        assert gateway.status()["alarms"] == book(gateway)["active"]
        assert gateway.status()["alarms"][0]["acknowledged"] is False
        answer = gateway.http.post("/alarms/heartbeat_lost/acknowledge", headers=operator).raise_for_status().json()
        assert (answer["id"], answer["acknowledged"]) == ("heartbeat_lost", True)
        told = stream.event("alarm")
        assert (told["id"], told["active"], told["acknowledged"]) == ("heartbeat_lost", True, True)
        assert gateway.status()["alarms"][0]["acknowledged"] is True
        board.silent = False
        told = stream.event("alarm")
        assert (told["id"], told["active"]) == ("heartbeat_lost", False)
    (past,) = book(gateway)["past"]
    assert (past["id"], past["acknowledged"]) == ("heartbeat_lost", True)
    assert past["until_s"] > past["since_s"]


def test_what_is_not_active_cannot_be_acknowledged_and_a_viewer_cannot(gateway: Gateway) -> None:
    answer = gateway.http.post("/alarms/battery_low/acknowledge")
    assert (answer.status_code, answer.json()["code"]) == (404, "alarm_not_active")
    with gateway.stream(), gateway.stream() as viewer:
        headers = {"X-Client": viewer.hello["client"]}
        answer = gateway.http.post("/alarms/battery_low/acknowledge", headers=headers)
        assert (answer.status_code, answer.json()["code"]) == (409, "control_held")
        answer = gateway.http.put("/alarms/thresholds", json={"battery_low_v": 11}, headers=headers)
        assert (answer.status_code, answer.json()["code"]) == (409, "control_held")


def test_limits_are_kept_over_a_restart(tmp_path: Path) -> None:
    with running_gateway(tmp_path / "data") as gateway:
        assert limits(gateway.http.get("/alarms/thresholds"))["battery_low_v"] == 0
        answer = gateway.http.put("/alarms/thresholds", json={"battery_low_v": 11.1})
        assert limits(answer)["battery_low_v"] == 11.1
    with running_gateway(tmp_path / "data") as gateway:
        assert limits(gateway.http.get("/alarms/thresholds")) == {
            "battery_low_v": 11.1,
            "battery_cells": 0,
            "battery_cell_low_v": 3.5,
            "altitude_high_ft": 0,
            "airspeed_low_kt": 0,
            "airspeed_high_kt": 0,
            "distance_far_m": 0,
            "satellites_few": 0,
            "cpu_high_percent": 90,
            "frames_damaged_percent": 1,
            "heartbeat_lost_s": 1,
            "hil_lost_s": 0.5,
        }


@pytest.mark.parametrize(
    ("changes", "status", "code", "field"),
    [
        ({"battery_low_v": 61}, 422, "threshold_out_of_range", "battery_low_v"),
        ({"battery_low_v": 11, "cpu_high_percent": 0}, 422, "threshold_out_of_range", "cpu_high_percent"),
        ({"battery_low": 11}, 404, "threshold_unknown", "battery_low"),
        ({"battery_low_v": None}, 422, "invalid_request", "battery_low_v"),
        ({}, 422, "invalid_request", ""),
    ],
)
def test_a_limit_that_is_not_allowed_names_itself_and_changes_nothing(
    gateway: Gateway, changes: dict[str, Any], status: int, code: str, field: str
) -> None:
    answer = gateway.http.put("/alarms/thresholds", json=changes)
    assert (answer.status_code, answer.json()["code"], answer.json()["params"]["field"]) == (status, code, field)
    assert limits(gateway.http.get("/alarms/thresholds"))["battery_low_v"] == 0


def test_a_longer_patience_with_the_heartbeat_counts_at_once(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    gateway.http.put("/alarms/thresholds", json={"heartbeat_lost_s": 30}).raise_for_status()
    board.silent = True
    eventually(lambda: (gateway.status()["board"]["heartbeat_age_s"] or 0) > 2, "the board is silent for two seconds")
    assert book(gateway)["active"] == []
    gateway.http.put("/alarms/thresholds", json={"heartbeat_lost_s": 1}).raise_for_status()
    eventually(lambda: len(book(gateway)["active"]) == 1, "now it is an alarm")


def test_a_page_is_told_how_many_cells_the_battery_is_taken_for(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    assert gateway.http.get("/alarms/thresholds").json()["battery"] is None
    nan = math.nan
    with gateway.stream("?rate=0") as stream:
        board.send(encode_telemetry("analog", 1013.0, 10.0, nan, nan, nan, nan, nan, 20.0, 41.0, nan))
        stream.sample("analog")
    guessed = {"highest_v": 41.0, "cells": 10, "is_guessed": True, "low_v": 35.0}
    eventually(lambda: gateway.http.get("/alarms/thresholds").json()["battery"] == guessed, "it is guessed")
    told = gateway.http.put("/alarms/thresholds", json={"battery_cells": 11}).json()["battery"]
    assert told == {"highest_v": 41.0, "cells": 11, "is_guessed": False, "low_v": 38.5}
