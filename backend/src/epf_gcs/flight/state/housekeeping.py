"""Work done a few times a second: time-outs, rates, alarms, the log of the links, and the status."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Final

from epf_gcs.contract.events import RecordingEvent
from epf_gcs.flight.clock.clock_watch import ClockWatch
from epf_gcs.flight.hil.stick import Stick
from epf_gcs.flight.memory.flight_log import FlightLog
from epf_gcs.flight.state.sources import StateSources
from epf_gcs.repeating import repeat
from epf_gcs.vehicle.outside import Outlet

_TICK_S: Final = 0.1
_STATUS_EVERY_TICKS: Final = 5


class Housekeeping:
    """`on_change`: the status should be sent."""

    def __init__(
        self,
        parts: StateSources,
        outlet: Outlet,
        *,
        stick: Stick,
        log: FlightLog,
        clock_watch: ClockWatch,
        on_change: Callable[[], None],
    ) -> None:
        self._parts = parts
        self._outlet = outlet
        self._stick = stick
        self._log = log
        self._clock_watch = clock_watch
        self._on_change = on_change
        self._recording: Path | None = None
        self._ticks = 0

    async def run(self) -> None:
        """Do all of it periodically, forever."""
        await repeat(_TICK_S, "housekeeping", self._tick)

    def _tick(self) -> None:
        self._ticks += 1
        self._parts.board.tick()
        self._parts.ahrs_test.tick()
        self._stick.tick()
        if self._ticks % _STATUS_EVERY_TICKS == 0:
            self._parts.rates.note(self._parts.clock.steady_s(), self._parts.board, self._parts.simulator)
            self.log_links()
            self._clock_watch.look()
            self._on_change()
        if self._parts.alarms.look(self._parts.clock.now_s()):
            self._on_change()
        self._watch_recording()

    def log_links(self) -> None:
        """Pass the state of both links to the log, which writes only changes."""
        board, simulator = self._parts.supervisor, self._parts.simulator
        self._log.link("board", board.state, None if board.address is None else board.address.url, board.failure)
        where = None if simulator.address is None else f"{simulator.address.send_host}:{simulator.address.send_port}"
        self._log.link("simulator", simulator.state, where, simulator.failure)

    def _watch_recording(self) -> None:
        """Tell the viewers when a recording begins or ends: the writing thread may not touch the event loop's parts."""
        file = self._parts.recorder.file if self._parts.recorder is not None else None
        if file != self._recording:
            self._recording = file
            self._outlet.event(RecordingEvent(file is not None, None if file is None else file.name))
            self._on_change()
