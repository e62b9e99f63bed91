"""What is done a few times a second, whoever looks."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncIterator
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import pytest
import structlog

from epf_gcs import repeating
from epf_gcs.flight.clock.clock_watch import ClockWatch
from epf_gcs.flight.flight import Flight
from epf_gcs.flight.hil.simulator import SimulatorAddress
from epf_gcs.flight.memory.flight_log import FlightLog
from epf_gcs.flight.state import housekeeping
from epf_gcs.flight.state.housekeeping import Housekeeping
from epf_gcs.link.address import parse_address
from epf_gcs.link.failures import lost_error
from epf_gcs.vehicle.alarms import Alarms
from epf_gcs.vehicle.judges import Finding
from tests.support.outlet import KeptOutlet
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio


def saying(value: object) -> property:
    return property(lambda _: value)


class Kept:
    """The housekeeping of a flight whose lines are not run. A tick is a look at the alarms; `wrong` is the test's."""

    def __init__(self, folder: Path) -> None:
        self.flight = flight = Flight(folder)
        self.outlet = KeptOutlet()
        self.wrong: list[Finding] = []
        self.ticks = 0
        self.changes = 0
        self.clock_looks = 0
        alarms = Alarms(lambda _: self._look(), self.outlet, {}, lambda _: None)
        self.keeping = Housekeeping(
            replace(flight.sources, alarms=alarms),
            self.outlet,
            stick=flight.stick,
            log=FlightLog(flight.clock.steady_s),
            clock_watch=ClockWatch(flight.clock, lambda *_: None, synchronised=self._synchronised),
            on_change=self._changed,
        )

    def _look(self) -> list[Finding]:
        self.ticks += 1
        return self.wrong

    def _synchronised(self) -> bool:
        self.clock_looks += 1
        return True

    def _changed(self) -> None:
        self.changes += 1

    async def for_ticks(self, number: int) -> None:
        wanted = self.ticks + number
        await eventually_async(lambda: self.ticks >= wanted, "time passes")

    @contextlib.asynccontextmanager
    async def running(self) -> AsyncIterator[None]:
        task = asyncio.create_task(self.keeping.run())
        try:
            yield
        finally:
            task.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await task


@pytest.fixture
async def kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Kept:
    monkeypatch.setattr(housekeeping, "_TICK_S", 0.0)
    return Kept(tmp_path / "data")


async def test_the_status_is_sent_with_every_fifth_tick_and_at_once_when_an_alarm_comes_or_goes(kept: Kept) -> None:
    async with kept.running():
        await kept.for_ticks(12)
        assert kept.changes == kept.clock_looks == kept.ticks // 5
        kept.wrong = [Finding("battery_low", "critical", "9.0 V.")]
        await kept.for_ticks(3)
        assert kept.changes == kept.ticks // 5 + 1
        kept.wrong = []
        await kept.for_ticks(3)
        assert kept.changes == kept.ticks // 5 + 2
    assert [(kind, data["active"]) for kind, data in kept.outlet.events] == [("alarm", True), ("alarm", False)]
    assert abs(kept.outlet.events[0][1]["since_s"] - kept.flight.clock.now_s()) < 120


async def test_alarms_are_looked_at_ten_times_a_second(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    kept = Kept(tmp_path / "data")
    pauses_s = []

    async def pause(lasts_s: float) -> None:
        pauses_s.append(lasts_s)
        await asyncio.sleep(0.0)

    monkeypatch.setattr(repeating, "asyncio", SimpleNamespace(sleep=pause))
    async with kept.running():
        await kept.for_ticks(7)
    assert set(pauses_s) == {0.1}
    assert kept.ticks <= len(pauses_s) <= kept.ticks + 1, "one before each look"


async def test_the_board_the_stick_and_a_running_test_are_asked_at_each_tick_what_is_due(
    kept: Kept, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked = {"board": 0, "stick": 0, "ahrs_test": 0}

    def counts(name: str) -> None:
        tick = getattr(kept.flight, name).tick

        def count() -> None:
            asked[name] += 1
            tick()

        monkeypatch.setattr(getattr(kept.flight, name), "tick", count)

    for name in asked:
        counts(name)
    async with kept.running():
        await kept.for_ticks(7)
        assert asked == dict.fromkeys(asked, kept.ticks)


async def test_the_rates_of_the_lines_are_measured(kept: Kept) -> None:
    async with kept.running():

        def flows() -> bool:
            kept.flight.board.bytes_in += 100
            kept.flight.board.bytes_out += 10
            kept.flight.simulator.bytes_in += 1000
            rates = kept.flight.rates
            return 0 < rates.board_out.per_s() < rates.board_in.per_s() < rates.simulator_in.per_s()

        await eventually_async(flows, "they are measured")


async def test_a_recording_that_begins_and_ends_is_told_once_each(kept: Kept) -> None:
    recorder = kept.flight.recorder
    assert recorder is not None
    async with kept.running():
        await kept.for_ticks(2)
        recorder.file = Path("/recordings/flight.mcap")
        await kept.for_ticks(3)
        assert kept.changes == kept.ticks // 5 + 1
        recorder.file = None
        await kept.for_ticks(3)
        assert kept.changes == kept.ticks // 5 + 2
    assert kept.outlet.events == [
        ("recording", {"active": True, "file": "flight.mcap"}),
        ("recording", {"active": False, "file": None}),
    ]


async def test_each_link_is_logged_by_its_own_name_and_address(kept: Kept, monkeypatch: pytest.MonkeyPatch) -> None:
    flight = kept.flight
    flight.supervisor.want(parse_address("tcp://192.0.2.1:4000"), None)
    flight.simulator.want(SimulatorAddress(49003, "192.0.2.5", 49000, "xp10"))
    failures = {
        flight.supervisor: lost_error("board", "unplugged"),
        flight.simulator: lost_error("simulator", "taken"),
    }
    for part, failure in failures.items():
        monkeypatch.setattr(type(part), "state", saying("lost"))
        monkeypatch.setattr(type(part), "failure", saying(failure))
    with structlog.testing.capture_logs() as logged:
        kept.keeping.log_links()
        kept.keeping.log_links()
    assert [(line["link"], line["target"], line["reason"]) for line in logged] == [
        ("board", "tcp://192.0.2.1:4000", failures[flight.supervisor].detail),
        ("simulator", "192.0.2.5:49000", failures[flight.simulator].detail),
    ]
