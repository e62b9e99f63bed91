"""Which saved tracks are drawn again after a restart."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from pathlib import Path

import pytest

from epf_gcs.clock import Clock
from epf_gcs.contract.base import Values
from epf_gcs.track.tracks import Tracks

START_S = 1_800_000_000.0


class SetClock(Clock):
    """A clock in the test's hand."""

    def __init__(self) -> None:
        super().__init__()
        self.at_s = START_S

    def now_s(self) -> float:
        return self.at_s


class Aircraft:
    """A vehicle whose samples the test sends."""

    is_emulated = False

    def __init__(self) -> None:
        self._listeners: dict[str, Callable[[float, Values], None]] = {}

    def listen(self, topic: str, listener: Callable[[float, Values], None]) -> None:
        self._listeners[topic] = listener

    def newest(self, topic: str) -> Values | None:
        return None

    def is_live(self, topic: str) -> bool:
        return False

    def fly_simulator(self, t_s: float, latitude_deg: float) -> None:
        self._listeners["simulator"](
            t_s, {"latitude_deg": latitude_deg, "longitude_deg": -15.4, "altitude_msl_ft": 300.0}
        )

    def fly(self, t_s: float, latitude_deg: float) -> None:
        place: Values = {"latitude_deg": latitude_deg, "longitude_deg": -15.4, "altitude_m": 300.0}
        self._listeners["gps"](t_s, {"valid": True, "fix": True, **place})


class Run:
    """One run of the station, with its files in a folder."""

    def __init__(self, folder: Path, clock: Clock) -> None:
        self.aircraft = Aircraft()
        self._loaded = asyncio.Event()
        self.tracks = Tracks(self.aircraft, lambda *_: self._loaded.set(), clock, folder, lambda error: None)

    async def load(self) -> None:
        """Until the saved tracks are there."""
        running = asyncio.create_task(self.tracks.run())
        await self._loaded.wait()
        running.cancel()

    def drawn(self) -> tuple[int, int]:
        state = self.tracks.state
        return state.flight_points, state.hil_points


async def flown(folder: Path, clock: SetClock) -> None:
    """A run whose simulator flew at the start, and the board until 100 s later."""
    run = Run(folder, clock)
    for n in range(3):
        run.aircraft.fly_simulator(START_S + n, 27.9 + n * 1e-4)
        run.aircraft.fly(START_S + 98.0 + n, 27.9 + n * 1e-4)
    await run.tracks.close()


@pytest.mark.parametrize(
    ("later_s", "drawn", "restorable"),
    [
        pytest.param(101.0, (3, 3), False, id="a flight that goes on is drawn"),
        pytest.param(180.0, (3, 0), True, id="each track by its own newest point"),
        pytest.param(600.0, (0, 0), True, id="an earlier flight is not drawn"),
    ],
)
def test_the_track_of_an_earlier_flight_is_off_until_it_is_asked_for(
    tmp_path: Path, later_s: float, drawn: tuple[int, int], restorable: bool
) -> None:
    async def again() -> None:
        clock = SetClock()
        await flown(tmp_path, clock)
        clock.at_s = START_S + later_s
        run = Run(tmp_path, clock)
        await run.load()
        assert run.drawn() == drawn
        assert run.tracks.state.can_restore is restorable
        run.aircraft.fly(clock.at_s + 1.0, 27.95)
        if restorable:
            run.tracks.restore()
        assert run.drawn() == (4, 3)
        newest_s = run.tracks.now.flight.newest_s
        assert newest_s == pytest.approx(clock.at_s + 1.0)

    asyncio.run(again())
