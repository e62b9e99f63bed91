"""The composition root of the flight process: makes the parts, connects them, and owns their life.

line -> board -> telemetry -> outlet (samples)       simulator <-> hil <-> board
recorder first: every byte of both lines, before anybody decodes it
requests of a station -> commands, parameters, missions, lines, hil -> board
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncIterator, Callable
from pathlib import Path

from epf_gcs import __version__
from epf_gcs.bus.address import Listener
from epf_gcs.bus.vehicle_end import Handlers, VehicleEnd
from epf_gcs.codec.tables import Waypoint
from epf_gcs.contract.answers import Sample
from epf_gcs.contract.base import PlanName
from epf_gcs.contract.events import BoardRestartEvent, LinkEvent
from epf_gcs.contract.hello import ControlHolder, Hello
from epf_gcs.contract.status import Status
from epf_gcs.flight.clock.clock_watch import ClockWatch
from epf_gcs.flight.memory.flight_log import FlightLog
from epf_gcs.flight.parts import make_alarms, make_board, make_common, make_loop
from epf_gcs.flight.recording.known_notes import KnownNotes
from epf_gcs.flight.requests.commands import command_requests
from epf_gcs.flight.requests.faults import fault_requests
from epf_gcs.flight.requests.lines import line_requests
from epf_gcs.flight.requests.notices import notices
from epf_gcs.flight.requests.parameters import mission_requests, parameter_requests
from epf_gcs.flight.requests.recording import recording_requests
from epf_gcs.flight.requests.state import alarm_requests, state_requests
from epf_gcs.flight.state.advised import AdviceWatch
from epf_gcs.flight.state.housekeeping import Housekeeping
from epf_gcs.flight.state.line_rates import LineRates
from epf_gcs.flight.state.sources import StateSources
from epf_gcs.flight.state.status import build_status
from epf_gcs.repeating import Repeating, keep_alive
from epf_gcs.vehicle.alarms import Alarm, News
from epf_gcs.vehicle.restart import Restart


class Flight:
    """Constructed on the running loop, with the data folder locked. `board_url` replaces the remembered board."""

    def __init__(self, data_dir: Path, *, record: bool = True, board_url: str | None = None) -> None:
        self._data_dir = data_dir
        self._board_url = board_url
        self._sending = Repeating(asyncio.get_running_loop(), "the status", self._send_status)

        common = make_common(data_dir, self, record=record)
        self.clock, self.outlet, self.errors, self.memory = common.clock, common.outlet, common.errors, common.memory
        self.recorder, self.notes = common.recorder, common.notes
        self._log = FlightLog(self.clock.steady_s)
        board = make_board(common, self)
        self.board, self.telemetry, self.commands = board.vehicle.board, board.vehicle.telemetry, board.commands
        self.parameters, self.missions, self.journal = board.parameters, board.missions, board.journal
        self.rearming = board.rearming
        loop = make_loop(common, board, self)
        self.stick, self.hil, self.ahrs_test, self.switches = loop.stick, loop.hil, loop.ahrs_test, loop.switches
        self.simulator, self.supervisor, self.lines = loop.simulator, loop.supervisor, loop.lines
        self.faults = loop.faults
        self.rates = LineRates()
        watched = make_alarms(common, board, loop, self)
        self.watch, self.alarms, self._alarm_history = watched.watch, watched.alarms, watched.history

        self._known = self._make_known()
        self._known.limits(self.alarms.thresholds)
        self.sources = self._make_sources()
        self._housekeeping = Housekeeping(
            self.sources,
            self.outlet,
            stick=self.stick,
            log=self._log,
            clock_watch=ClockWatch(self.clock, self.notes.know),
            on_change=self.changed,
        )
        self._advised = AdviceWatch(self.sources, self.outlet)
        self._requests = common.client_names.remembering(self._make_requests(board.vehicle.newest))
        # Each of these is made from the other.
        self.board.on_urgent = self.hil.on_urgent
        self.commands.on_done = self.rearming.command_done
        self._known.identity()

    def _make_known(self) -> KnownNotes:
        return KnownNotes(
            self.notes,
            self.board,
            parameters=self.parameters,
            stick=self.stick,
            supervisor=self.supervisor,
            simulator=self.simulator,
            aircraft=self.memory.now.aircraft,
        )

    def _make_sources(self) -> StateSources:
        return StateSources(
            clock=self.clock,
            errors=self.errors,
            memory=self.memory,
            board=self.board,
            telemetry=self.telemetry,
            supervisor=self.supervisor,
            lines=self.lines,
            simulator=self.simulator,
            faults=self.faults,
            hil=self.hil,
            rates=self.rates,
            ahrs_test=self.ahrs_test,
            recorder=self.recorder,
            watch=self.watch,
            alarms=self.alarms,
        )

    def _make_requests(self, newest: Callable[[], dict[str, Sample]]) -> Handlers:
        """What stations may ask."""
        return {
            **state_requests(self.status, newest, self.sources),
            **line_requests(self.lines, self.supervisor, self.simulator),
            **command_requests(self.board, self.commands, self.parameters, self.ahrs_test, self.outlet, self.hil),
            **parameter_requests(self.parameters),
            **mission_requests(self.missions),
            **self.switches.requests(),
            **fault_requests(self.faults),
            **alarm_requests(self.alarms, self.watch.battery, self._known.limits),
            **recording_requests(self.recorder, self.notes, self._known, self.memory, self.outlet),
        }

    @contextlib.asynccontextmanager
    async def running(self) -> AsyncIterator[None]:
        """Run everything inside; at the end shut board and simulator links down in order. Raises OSError."""
        listener = Listener(self._data_dir)
        end = VehicleEnd(
            self.outlet,
            hello=self._hello,
            samples=lambda: [(topic, one.t_s, one.values) for topic, one in self.telemetry.samples().items()],
            requests=self._requests,
            on_notice=notices(self.stick, self.watch.surroundings, self.clock.steady_s),
            on_gone=self.stick.let_go,
        )
        if self.recorder is not None:
            self.recorder.start()
        self.lines.reopen(self._board_url)
        try:
            async with asyncio.TaskGroup() as tasks:
                running = [
                    tasks.create_task(keep_alive("flight", name, job, lambda: self.errors.count("internal")), name=name)
                    for name, job in (
                        ("board link", self.supervisor.run),
                        ("simulator link", self.simulator.run),
                        ("simulator faults", self.faults.run),
                        ("re-arming", self.rearming.run),
                        ("housekeeping", self._housekeeping.run),
                        ("advice", self._advised.run),
                        ("stream", lambda: end.run(listener)),
                    )
                ]
                try:
                    yield
                finally:
                    self.supervisor.shut_down()
                    self.simulator.shut_down()
                    for task in running:
                        task.cancel()
        finally:
            listener.close()
            if self.recorder is not None:
                await asyncio.to_thread(self.recorder.stop)
            for kept in (self.journal, self._alarm_history, self.memory):
                await asyncio.to_thread(kept.close)

    def status(self) -> Status:
        """The status of all parts now."""
        return build_status(self.sources)

    def changed(self) -> None:
        """Send the status now, not at the next half-second tick."""
        self._sending.arm()

    def _hello(self) -> Hello:
        holder = self.stick.last_holder
        return Hello(
            __version__,
            "live",
            self.status(),
            clock_offset_ns=self.clock.offset_ns,
            control=None if holder is None else ControlHolder(holder.id, holder.name, holder.about),
        )

    def _send_status(self) -> None:
        if self.outlet.has_listeners:
            self.outlet.status(self.status())

    def flies(self) -> bool:
        """An autopilot is on, or the board moves the simulator's surfaces: it must keep hearing commands."""
        heartbeat = self.telemetry.newest("heartbeat") or {}
        moves = self.simulator.state == "open" and self.hil.path == "assisted"
        return moves or any(heartbeat.get(flag) is True for flag in ("autopilot", "autopilot_hil"))

    def may_wait(self) -> bool:
        """Whether neither the HIL loop nor a station needs the board's bytes as they come."""
        return self.hil.link is None and (self.outlet.gathers or not self.outlet.has_listeners)

    def on_ahrs_test(self) -> None:
        """The AHRS test began or ended."""
        if self.board.exclusive_user is not None:
            self.hil.rest()
        self.changed()

    def on_opened(self) -> None:
        """Commands can be sent to the board."""
        # At once and not in the re-arming task, which may be busy: it would discard values that were loaded meanwhile.
        self._known.identity()
        self._known.forget_plans()
        self.parameters.forget()
        self.rearming.board_opened()

    def on_restarted(self, restart: Restart) -> None:
        """The board lost what was not stored on its card: report what that was."""
        self._log.board_restarted(restart.uptime_ms)
        self._known.forget_plans()
        parameters, plans = list(self.parameters.take_unstored()), list(self.missions.take_known())
        self.outlet.event(BoardRestartEvent(uptime_ms=restart.uptime_ms, parameters=parameters, plans=plans))

    def on_parameters(self) -> None:
        """Gains have changed."""
        self._known.parameters()

    def on_plan_read(self, plan: PlanName, waypoints: list[Waypoint]) -> None:
        """A plan was read from the board."""
        self._known.plan(plan, waypoints)

    def on_holder(self) -> None:
        """Another page, or none, has control."""
        self._known.holder()

    def on_alarm(self, news: News, alarm: Alarm) -> None:
        """An alarm came, went or was acknowledged."""
        self._log.alarm(news, alarm.state)
        if news == "acknowledged":
            if alarm.finding.id == "parameter_not_confirmed":
                self.parameters.accept_unconfirmed()
            self.changed()

    def on_line(self) -> None:
        """A line opened, was lost or closed."""
        self._known.lines()
        if not self.board.is_open:
            self.parameters.forget()
            self._known.forget_plans()
        self.commands.link_changed()
        self._housekeeping.log_links()
        self.outlet.event(LinkEvent(self.supervisor.state, self.simulator.state))
        # At once: viewers must know the new link state before its first samples, above all that they are emulated.
        self._send_status()
