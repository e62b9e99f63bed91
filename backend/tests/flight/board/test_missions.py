"""Plans on a real line."""

from __future__ import annotations

import math
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest

from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.codec.tables import Waypoint
from epf_gcs.contract.events import Event
from epf_gcs.errors import BoardError, ConflictError
from epf_gcs.flight.board import commands
from epf_gcs.flight.flight import Flight
from epf_gcs.link.address import parse_address
from tests.support.contract import as_told
from tests.support.fake_board import FakeBoard
from tests.support.waiting import eventually_async

TWO = [Waypoint(27.9, -15.4, 500.0, 60.0), Waypoint(28.0, -15.5, 600.0, 60.0)]


@pytest.mark.anyio
@pytest.mark.parametrize(("plan", "other"), [("flight", 1), ("hil", 0)])
async def test_what_the_board_says_of_the_other_plan_is_not_taken_for_this_one(
    tmp_path: Path, board: FakeBoard, plan: str, other: int
) -> None:
    item = (1 - other, 0, 27.9, -15.4, 500.0, 60.0)
    board.plans[1 - other] = [item]
    _says_first(board, encode_telemetry("mission_count", other, 0))
    assert await _altitudes_ft(tmp_path, board, plan) == [500]


@pytest.mark.anyio
async def test_a_waypoint_that_lacks_a_value_is_waited_for(tmp_path: Path, board: FakeBoard) -> None:
    board.plans[1] = [(1, 0, 27.9, -15.4, 500.0, 60.0)]
    lacking = encode_telemetry("mission_item", 1, 0, 27.9, -15.4, math.nan, 60.0)
    _says_first(board, encode_telemetry("mission_count", 1, 1) + lacking)
    assert await _altitudes_ft(tmp_path, board, "hil") == [500]


@pytest.mark.anyio
async def test_waypoints_of_a_transfer_that_broke_off_are_not_mixed_with_the_next_one(
    tmp_path: Path, board: FakeBoard
) -> None:
    board.plans[1] = [(1, 0, 27.9, -15.4, 500.0, 60.0), (1, 1, 28.0, -15.5, 600.0, 60.0)]
    broken_off = encode_telemetry("mission_count", 1, 2) + encode_telemetry(
        "mission_item", 1, 1, 27.0, -15.0, 9.0, 60.0
    )
    _says_first(board, broken_off)
    assert await _altitudes_ft(tmp_path, board, "hil") == [500, 600]


@pytest.mark.anyio
async def test_waypoints_that_come_in_another_order_or_twice_are_the_same_plan(
    tmp_path: Path, board: FakeBoard
) -> None:
    items = [encode_telemetry("mission_item", 1, index, 27.9, -15.4, 500.0 + index, 60.0) for index in (1, 0, 0, 1)]
    _says_first(board, encode_telemetry("mission_count", 1, 2) + b"".join(items))
    assert await _altitudes_ft(tmp_path, board, "hil") == [500, 501]


@pytest.mark.anyio
async def test_a_plan_that_the_board_has_otherwise_than_it_was_sent_is_not_confirmed(
    tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    answer = board._plan

    def lose_the_last(name: str, values: tuple[float, ...]) -> None:
        answer(name, values)
        if name == "mission_commit":
            board.plans[1].pop()

    board._plan = lose_the_last  # type: ignore[method-assign]
    async with _a_station(tmp_path, board) as station:
        told = _told(station, monkeypatch)
        with pytest.raises(BoardError) as differs:
            await station.missions.write("hil", TWO, "c1")
        assert differs.value.code == "mission_differs"
        assert "(1 waypoints)" in differs.value.detail
    assert told == [("pending", 2, "c1"), ("rejected", 1, "c1")]


@pytest.mark.anyio
async def test_a_plan_that_is_refused_is_told_as_rejected_and_its_steps_are_told_to_nobody(
    tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    board.refuse["mission_item"] = 1
    async with _a_station(tmp_path, board) as station:
        told = _told(station, monkeypatch)
        with pytest.raises(BoardError):
            await station.missions.write("hil", TWO, "c1")
    assert told == [("pending", 2, "c1"), ("rejected", 2, "c1")]
    assert board.count("mission_commit") == 0


@pytest.mark.anyio
async def test_a_step_of_a_plan_that_nobody_answers_says_that_it_timed_out(
    tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    board.ignore["mission_begin"] = 99
    async with _a_station(tmp_path, board) as station:
        monkeypatch.setattr(commands, "_ANSWER_S", 0.01)
        with pytest.raises(BoardError) as refused:
            await station.missions.write("hil", TWO, None)
    assert (refused.value.code, refused.value.params["reason"]) == ("mission_refused", "timed_out")
    assert board.count("mission_item") == 0


@pytest.mark.anyio
async def test_a_board_that_speaks_of_no_plans_is_asked_for_none(tmp_path: Path, board: FakeBoard) -> None:
    board.features = 7
    async with _a_station(tmp_path, board) as station:
        for transfer in (station.missions.read("hil"), station.missions.write("hil", TWO, None)):
            with pytest.raises(ConflictError) as refused:
                await transfer
            assert refused.value.code == "not_supported"
    assert [name for name in board.received if name.startswith("mission")] == []


@pytest.mark.anyio
async def test_only_a_plan_that_the_board_has_can_be_lost_with_it(tmp_path: Path, board: FakeBoard) -> None:
    async with _a_station(tmp_path, board) as station:
        await station.missions.read("flight")
        await station.missions.write("hil", TWO, None)
        assert station.missions.take_known() == ("hil",)
        assert station.missions.take_known() == ()


def _told(station: Flight, monkeypatch: pytest.MonkeyPatch) -> list[tuple[Any, ...]]:
    """What viewers hear from now on of plans, and of commands."""
    heard: list[tuple[Any, ...]] = []

    def event(event: Event) -> None:
        kind, data = as_told(event)
        if kind == "mission":
            heard.append((data["state"], data["count"], data["client"]))
        elif kind == "command":
            heard.append((kind, data["name"]))

    monkeypatch.setattr(station.outlet, "event", event)
    return heard


def _says_first(board: FakeBoard, data: bytes) -> None:
    """What the board sends before it answers what is asked about its plans."""
    answer = board._plan

    def answer_then(name: str, values: tuple[float, ...]) -> None:
        board._write(data)
        answer(name, values)

    board._plan = answer_then  # type: ignore[method-assign]


@asynccontextmanager
async def _a_station(folder: Path, board: FakeBoard) -> AsyncIterator[Flight]:
    station = Flight(folder / "data", record=False)
    async with station.running():
        await station.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: station.supervisor.state == "open", "the board opens")
        yield station


async def _altitudes_ft(folder: Path, board: FakeBoard, plan: str) -> list[int]:
    async with _a_station(folder, board) as station:
        found = await station.missions.read(plan)  # type: ignore[arg-type]
    return [round(waypoint.altitude_ft) for waypoint in found]
