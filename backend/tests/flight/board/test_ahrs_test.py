"""The AHRS test on a line and a clock in the test's hand: when it has begun, when it is lost, when it has ended."""

from __future__ import annotations

import asyncio
from itertools import groupby
from struct import pack

import pytest

from epf_gcs.codec.ahrs_test import QUIT, SYNCHRONISED
from epf_gcs.codec.messages_gen import OPEN_BINARY_MODE
from epf_gcs.contract.answers import CommandOutcome
from epf_gcs.error_log import ErrorLog
from epf_gcs.errors import ConflictError
from epf_gcs.flight.board import ahrs_test
from epf_gcs.flight.board.ahrs_test import AhrsTestRun, Stage
from epf_gcs.vehicle.vehicle import Vehicle
from tests.support.held import HeldClock, HeldLine, open_session
from tests.support.outlet import KeptOutlet
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio

# A record counts only once the next one has begun.
ATTITUDE = (b"\xaa" * 4 + pack("<3f", 10.0, 5.0, -3.0)) * 2


class World:
    """A board that is open, and its test. `told`: the stages that viewers saw, each once."""

    def __init__(self) -> None:
        self.clock = HeldClock()
        self.errors = ErrorLog()
        self.line = HeldLine()
        vehicle = Vehicle(self.clock, KeptOutlet(), self.errors, lambda _: 1.0)
        self.board = vehicle.board
        self.flies = False
        self._changes: list[Stage] = []
        self.run = AhrsTestRun(
            vehicle=vehicle,
            clock=self.clock,
            errors=self.errors,
            flies=lambda: self.flies,
            changed=lambda: self._changes.append(self.run.stage),
        )
        self.board.attach(self.line)
        open_session(self.board)
        self.line.raw = b""

    @property
    def told(self) -> list[Stage]:
        return [stage for stage, _ in groupby(self._changes)]

    def wait(self, seconds: float) -> None:
        self.clock.time_s += seconds
        self.run.tick()

    async def begins(self) -> asyncio.Task[CommandOutcome]:
        """The board agreed, and has sent no attitude yet."""
        task = asyncio.create_task(self.run.start())
        await eventually_async(lambda: self.board.exclusive_user is self.run, "it has the line")
        self.wait(0.25)
        self.board.on_bytes(SYNCHRONISED)
        return task

    async def runs(self) -> CommandOutcome:
        task = await self.begins()
        self.board.on_bytes(ATTITUDE)
        return await task

    async def ends(self) -> CommandOutcome:
        task = asyncio.create_task(self.run.stop())
        await eventually_async(lambda: self.run.stage == "ending", "it ends")
        self.clock.time_s += 0.5
        open_session(self.board)
        self.run.tick()
        return await task


async def test_begin_and_end_are_told_step_by_step_with_the_time_that_they_took() -> None:
    world = World()
    assert await world.runs() == CommandOutcome("confirmed", "read_back", 250.0)
    assert await world.ends() == CommandOutcome("confirmed", "heartbeat", 500.0)
    assert world.told == ["starting", "running", "ending", "off"]


async def test_an_attitude_of_the_test_before_does_not_prove_the_next_one() -> None:
    world = World()
    await world.runs()
    await world.ends()
    task = await world.begins()
    assert world.run.stage == "starting"
    assert not task.done()
    world.board.on_bytes(ATTITUDE)
    assert (await task).state == "confirmed"


async def test_a_test_is_lost_two_seconds_after_its_last_attitude() -> None:
    world = World()
    await world.runs()
    world.wait(1.75)
    world.board.on_bytes(ATTITUDE)
    world.wait(2.0)
    assert world.run.stage == "running", "counted from the last attitude"
    world.line.raw = b""
    world.wait(0.125)
    assert world.told == ["starting", "running", "off"]
    assert world.errors.counts == {"ahrs_test_lost": 1}
    assert world.line.raw == QUIT + OPEN_BINARY_MODE, "the board is brought back to its frames"


async def test_a_test_that_has_not_begun_is_not_lost() -> None:
    world = World()
    task = await world.begins()
    world.wait(3.0)
    assert world.run.stage == "starting"
    assert world.errors.counts == {}
    world.board.on_bytes(ATTITUDE)
    assert (await task).state == "confirmed"


async def test_a_start_that_nothing_answers_gives_the_line_back(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ahrs_test, "_BEGIN_S", 0.0)
    world = World()
    assert (await world.run.start()).state == "timed_out"
    assert world.told == ["starting", "off"]
    assert world.line.raw.endswith(QUIT + OPEN_BINARY_MODE)
    open_session(world.board)


async def test_the_end_is_not_waited_for_on_a_line_that_is_gone(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ahrs_test, "_END_S", 3600.0)
    world = World()
    await world.runs()
    task = asyncio.create_task(world.run.stop())
    await eventually_async(lambda: world.run.stage == "ending", "it ends")
    world.board.detach()
    world.run.tick()
    await eventually_async(task.done, "nobody waits for a board that is gone")
    assert (await task).state == "timed_out"
    assert world.told[-1] == "off"


async def test_two_who_start_it_at_once_begin_one_test() -> None:
    world = World()
    first = await world.begins()
    second = asyncio.create_task(world.run.start())
    await asyncio.sleep(0)
    begun = world.line.raw
    world.board.on_bytes(ATTITUDE)
    assert [(await task).state for task in (first, second)] == ["confirmed", "confirmed"]
    assert world.line.raw == begun


async def test_a_board_that_flies_or_is_not_there_keeps_its_line() -> None:
    world = World()
    world.flies = True
    with pytest.raises(ConflictError) as refused:
        await world.run.start()
    assert refused.value.code == "ahrs_test_in_flight"
    world.flies = False
    world.board.detach()
    with pytest.raises(ConflictError) as refused:
        await world.run.start()
    assert refused.value.code == "board_not_open"
    assert world.line.raw == b""
    assert world.told == []
