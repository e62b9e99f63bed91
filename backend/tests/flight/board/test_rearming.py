"""What was asked of a board is asked again each time one opens, on a line in the test's hand."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest

from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.error_log import ErrorLog
from epf_gcs.flight.board.commands import Commands
from epf_gcs.flight.board.journal import Journal
from epf_gcs.flight.board.own_gains import OwnGainValues
from epf_gcs.flight.board.own_table import OwnTableReader
from epf_gcs.flight.board.parameters import Parameters
from epf_gcs.flight.board.rearming import Rearmer
from epf_gcs.flight.memory.memory import Memory
from epf_gcs.vehicle.vehicle import Vehicle
from epf_gcs.vehicle.wanted import IntendedSettings
from tests.support.held import HEARTBEAT, HeldClock, HeldLine, open_session
from tests.support.outlet import KeptOutlet
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio

STREAMS = IntendedSettings().after("ahrs_on", ()).after("gps_on", ())


class World:
    """A board whose openings re-arm it. `looks` counts how often others were asked to look at the state."""

    def __init__(self, folder: Path) -> None:
        self.clock = HeldClock()
        self.outlet = KeptOutlet()
        self.errors = ErrorLog()
        self.memory = Memory(folder / "state.json", self.errors.report)
        vehicle = Vehicle(
            self.clock,
            self.outlet,
            self.errors,
            self.memory.now.wanted.period_s,
            on_opened=lambda: self.rearming.board_opened(),  # noqa: PLW0108 - it is made from the vehicle
        )
        self.board, self.telemetry = vehicle.board, vehicle.telemetry
        self.commands = Commands(self.board, self.telemetry, self.outlet, self.clock, self.errors)
        self.looks = 0
        journal = Journal(
            folder / "journal.jsonl",
            clock=self.clock,
            outlet=self.outlet,
            report=self.errors.report,
            name_of=lambda _: None,
        )
        reader = OwnTableReader(self.board, self.commands, folder / "own-gains.json", self.errors.report)
        own = OwnGainValues(self.board, self.commands, self.outlet, self.clock, reader)
        self.rearming = Rearmer(
            board=self.board,
            commands=self.commands,
            parameters=Parameters(self.board, self.commands, self.outlet, journal, own),
            telemetry=self.telemetry,
            memory=self.memory,
            errors=self.errors,
            on_change=self._look,
        )
        self.line = HeldLine()

    def _look(self) -> None:
        self.looks += 1

    def opens(self, *, is_emulated: bool = False) -> None:
        self.board.attach(self.line, is_emulated=is_emulated)
        open_session(self.board)
        self.line.sent.clear()

    def acknowledges(self, name: str, result: int = 0) -> None:
        self.board.on_bytes(encode_telemetry("acknowledgement", COMMANDS[name].id, result))

    async def was_sent(self, *names: str) -> None:
        await eventually_async(lambda: tuple(self.line.sent) == names, f"{names}, not {self.line.sent}")

    @property
    def told(self) -> list[tuple[Any, ...]]:
        return [(data["name"], data["state"], data["client"]) for kind, data in self.outlet.events if kind == "command"]


@asynccontextmanager
async def a_world(folder: Path) -> AsyncIterator[World]:
    world = World(folder)
    task = asyncio.create_task(world.rearming.run())
    try:
        yield world
    finally:
        task.cancel()
        await asyncio.to_thread(world.memory.close)


async def test_what_was_wanted_is_asked_for_one_after_the_other_in_the_gateway_s_name(tmp_path: Path) -> None:
    async with a_world(tmp_path) as world:
        world.memory.update(wanted=STREAMS)
        world.opens()
        await world.was_sent("ahrs_on")
        world.acknowledges("ahrs_on")
        await world.was_sent("ahrs_on", "gps_on")
        world.acknowledges("gps_on")
        await eventually_async(lambda: len(world.told) == 4, "both are done")
        assert world.told[0] == ("ahrs_on", "pending", "gateway")
        assert world.told[-1] == ("gps_on", "confirmed", "gateway")
        assert world.looks == 1
        assert world.errors.counts == {}


async def test_what_a_board_refuses_does_not_keep_the_rest_from_it(tmp_path: Path) -> None:
    async with a_world(tmp_path) as world:
        world.memory.update(wanted=STREAMS)
        world.opens()
        await world.was_sent("ahrs_on")
        world.acknowledges("ahrs_on", 2)
        await world.was_sent("ahrs_on", "gps_on")


async def test_once_the_line_takes_nothing_more_the_rest_is_left_for_the_next_opening(tmp_path: Path) -> None:
    async with a_world(tmp_path) as world:
        world.memory.update(wanted=STREAMS)
        world.opens()
        world.line.is_full = True
        await eventually_async(lambda: world.errors.counts["board_line_full"] > 0, "it is told")
        for _ in range(10):
            await asyncio.sleep(0)
        assert world.errors.counts == {"board_line_full": 1}
        world.line.is_full = False
        world.opens()
        await world.was_sent("ahrs_on")


async def test_an_emulated_board_is_asked_for_nothing(tmp_path: Path) -> None:
    async with a_world(tmp_path) as world:
        world.memory.update(wanted=STREAMS)
        world.opens(is_emulated=True)
        await eventually_async(lambda: world.looks == 1, "its opening is noticed")
        for _ in range(10):
            await asyncio.sleep(0)
        assert world.line.sent == []
        assert world.errors.counts == {}


async def test_a_board_that_was_told_a_slow_heartbeat_is_given_its_time_after_the_cable_was_out(tmp_path: Path) -> None:
    async with a_world(tmp_path) as world:
        world.memory.update(wanted=IntendedSettings().after("set_parameter_task_rate", (2000,)))
        world.opens()
        await world.was_sent("set_parameter_task_rate")
        world.board.on_bytes(HEARTBEAT)
        world.clock.time_s += 5.5
        world.board.tick()
        assert world.board.is_open
        world.clock.time_s += 1.0
        world.board.tick()
        assert not world.board.is_open


async def test_the_rates_of_a_task_whose_period_was_changed_are_measured_anew(tmp_path: Path) -> None:
    async with a_world(tmp_path) as world:
        world.opens()
        for _ in range(20):
            world.clock.time_s += 0.5
            world.board.on_bytes(HEARTBEAT)

        def measured() -> tuple[float | None, float]:
            frames = world.board.frame_statistics.heard["heartbeat"].summary(world.clock.now_s())
            return world.telemetry.health["heartbeat"].period_s(None), frames.rate_hz

        assert measured() == (0.5, 2.0)
        world.rearming.command_done("set_servos_task_rate", (100,))
        assert measured() == (0.5, 2.0), "that is another task"
        world.rearming.command_done("set_parameter_task_rate", (2000,))
        assert measured() == (None, 0.0)
