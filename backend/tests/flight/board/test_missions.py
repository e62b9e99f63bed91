"""Plans on a real line."""

from __future__ import annotations

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
    answer = board._plan

    def other_first(name: str, values: tuple[float, ...]) -> None:
        board._write(encode_telemetry("mission_count", other, 0))
        answer(name, values)

    board._plan = other_first  # type: ignore[method-assign]
    station = Flight(tmp_path / "data", record=False)
    async with station.running():
        await station.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: station.supervisor.state == "open", "the board opens")
        found = await station.missions.read(plan)  # type: ignore[arg-type]
    assert [round(waypoint.altitude_ft) for waypoint in found] == [500]
