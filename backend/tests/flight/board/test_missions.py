"""Plans on a real line."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.flight.flight import Flight
from epf_gcs.link.address import parse_address
from tests.support.fake_board import FakeBoard
from tests.support.waiting import eventually_async


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


def _says_first(board: FakeBoard, data: bytes) -> None:
    """What the board sends before it answers what is asked about its plans."""
    answer = board._plan

    def answer_then(name: str, values: tuple[float, ...]) -> None:
        board._write(data)
        answer(name, values)

    board._plan = answer_then  # type: ignore[method-assign]


async def _altitudes_ft(folder: Path, board: FakeBoard, plan: str) -> list[int]:
    station = Flight(folder / "data", record=False)
    async with station.running():
        await station.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: station.supervisor.state == "open", "the board opens")
        found = await station.missions.read(plan)  # type: ignore[arg-type]
    return [round(waypoint.altitude_ft) for waypoint in found]
