"""Every request can be asked, and whoever is asked knows it."""

from __future__ import annotations

import ast
from dataclasses import fields
from pathlib import Path
from typing import Any, cast

import orjson
import pytest

import epf_gcs
from epf_gcs.bus.definition import converted
from epf_gcs.codec.tables import Waypoint
from epf_gcs.contract import requests
from epf_gcs.contract.requests import REQUESTS, Request
from epf_gcs.flight.flight import Flight
from epf_gcs.replay.player import Player
from epf_gcs.replay.viewing import ReplayViewer

OF_A_REPLAY = {requests.ReadKnown, requests.ReadPlayback}


def asked_anywhere() -> set[str]:
    """The names of all classes that are called in the programs that ask a vehicle."""
    folders = [Path(epf_gcs.__file__).parent / name for name in ("web", "library")]
    calls: set[str] = set()
    for file in (file for folder in folders for file in folder.rglob("*.py")):
        for node in ast.walk(ast.parse(file.read_text())):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
                calls.add(node.func.id)
    return calls


@pytest.mark.anyio
async def test_every_request_has_a_handler_in_the_flight_or_in_a_replay(tmp_path: Path) -> None:
    flight = Flight(tmp_path)
    assert set(flight._requests) == set(REQUESTS.values()) - OF_A_REPLAY
    viewing = ReplayViewer.__new__(ReplayViewer)
    viewing._player = cast(Player, None)
    of_a_replay = set(viewing._requests())
    assert OF_A_REPLAY <= of_a_replay <= set(REQUESTS.values())
    for kept in (flight.journal, flight._alarm_history, flight.memory):
        kept.close()


def test_every_request_is_asked_by_somebody() -> None:
    assert set(REQUESTS) - asked_anywhere() == {"ReadPlayback"}, "a viewer is told without asking where its replay is"


@pytest.mark.parametrize(
    "request_",
    [
        requests.OpenBoard("tcp://192.0.2.1:5760"),
        requests.OpenSimulator(49003, "192.0.2.1", 49000, "xp12"),
        requests.RunCommand("servo_out", [1, 0.5, True]),
        requests.SetHil(path="manual"),
        requests.SetParameters({"k_pitch": 2.5}),
        requests.WritePlan("hil", [Waypoint(28.0, -15.5, 1000.0, 60.0)]),
        requests.ChooseDiskPolicy(keep_free_bytes=5),
    ],
    ids=lambda request: type(request).__name__,
)
def test_a_request_arrives_as_it_was_asked_its_numbers_of_the_same_kind(request_: Request[Any]) -> None:
    arrived = converted(type(request_), orjson.loads(orjson.dumps(request_)))
    assert arrived == request_
    assert [type(getattr(arrived, one.name)) for one in fields(arrived)] == [
        type(getattr(request_, one.name)) for one in fields(arrived)
    ]
    if isinstance(arrived, requests.RunCommand):
        assert [type(value) for value in arrived.arguments] == [int, float, bool]
