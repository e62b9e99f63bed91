"""The composition root of the flight process: makes the parts, connects them, and owns their life.

line -> board -> telemetry -> outlet (samples)       simulator <-> hil <-> board
recorder first: every byte of both lines, before anybody decodes it
requests of a station -> commands, parameters, missions, lines, hil -> board
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncIterator
from pathlib import Path

from epf_gcs import __version__
from epf_gcs.bus.address import Listener
from epf_gcs.bus.vehicle_end import VehicleEnd
from epf_gcs.contract.alarm_ids import AlarmId
from epf_gcs.contract.events import BoardRestartEvent, ErrorEvent, LinkEvent
from epf_gcs.contract.hello import ControlHolder, Hello
from epf_gcs.contract.status import Status
from epf_gcs.error_log import ErrorLog
from epf_gcs.flight.board.ahrs_test import AhrsTestRun
from epf_gcs.flight.board.board_link import Supervisor
from epf_gcs.flight.board.commands import Commands
from epf_gcs.flight.board.journal import Journal
from epf_gcs.flight.board.missions import Missions
from epf_gcs.flight.board.parameters import Parameters
from epf_gcs.flight.board.rearming import Rearmer
from epf_gcs.flight.clock.clock_watch import ClockWatch
from epf_gcs.flight.clock.line_clock import LineClock
from epf_gcs.flight.hil.hil import Hil
from epf_gcs.flight.hil.simulator import Simulator
from epf_gcs.flight.hil.stick import Stick
from epf_gcs.flight.memory.flight_log import FlightLog
from epf_gcs.flight.memory.memory import Memory
from epf_gcs.flight.recording.flight_notes import FlightNotes, NotedBroadcast
from epf_gcs.flight.recording.known_notes import KnownNotes
from epf_gcs.flight.recording.recorder import Recorder
from epf_gcs.flight.recording.taps import line_taps
from epf_gcs.flight.requests.client_names import ClientNames
from epf_gcs.flight.requests.commands import command_requests
from epf_gcs.flight.requests.hil import HilSwitches
from epf_gcs.flight.requests.lines import line_requests
from epf_gcs.flight.requests.notices import notices
from epf_gcs.flight.requests.parameters import mission_requests, parameter_requests
from epf_gcs.flight.requests.recording import recording_requests
from epf_gcs.flight.requests.state import alarm_requests, state_requests
from epf_gcs.flight.state.advised import AdviceWatch
from epf_gcs.flight.state.alarm_history import AlarmHistory
from epf_gcs.flight.state.housekeeping import Housekeeping
from epf_gcs.flight.state.inspection import InspectorSources
from epf_gcs.flight.state.line_rates import LineRates
from epf_gcs.flight.state.lines import Lines, LinkOpener
from epf_gcs.flight.state.status import StatusSources, build_status
from epf_gcs.flight.state.watch import Watch
from epf_gcs.repeating import Repeating, keep_alive, log_and_count_failures
from epf_gcs.vehicle.alarms import Alarms
from epf_gcs.vehicle.restart import Restart
from epf_gcs.vehicle.surroundings import ToldSurroundings
from epf_gcs.vehicle.vehicle import Vehicle


class Flight:
    """Constructed on the running loop, with the data folder locked. `board_url` replaces the remembered board."""

    def __init__(self, data_dir: Path, *, record: bool = True, board_url: str | None = None) -> None:
        self._loop = asyncio.get_running_loop()
        self._data_dir = data_dir
        self._board_url = board_url
        self._sending = Repeating(self._loop, "the status", self._send_status)

        self.clock = LineClock()
        self.outlet = NotedBroadcast(self.clock)
        self._client_names = ClientNames()
        self._log = FlightLog(self.clock.steady_s)
        self.errors = ErrorLog()
        log_and_count_failures(self._loop, "flight", lambda: self.errors.count("internal"))
        self.errors.tell_viewers(self.clock.steady_s, lambda *told: self.outlet.event(ErrorEvent.of(*told)))
        self.memory = Memory(data_dir / "state.json", self.errors.report)

        # The vehicle, recorded before it is decoded.
        self.recorder = Recorder(data_dir / "recordings", self.clock, f"epf-gcs {__version__}") if record else None
        self.notes = FlightNotes(self.recorder, self.clock)
        board_tap, simulator_tap = self.recorder.taps if self.recorder else line_taps(self.clock, None)
        period_s = lambda rate: self.memory.now.wanted.period_s(rate)  # noqa: E731, PLW0108 (`now` is replaced)
        vehicle = Vehicle(self.clock, self.outlet, self.errors, period_s)
        self.telemetry, self.board = vehicle.telemetry, vehicle.board

        self.commands = Commands(self.board, self.telemetry, self.outlet, self.clock, self.errors)
        self.journal = Journal(
            data_dir / "parameter-journal.jsonl",
            clock=self.clock,
            outlet=self.outlet,
            report=self.errors.report,
            name_of=self._client_names.name_of,
        )
        self.parameters = Parameters(self.board, self.commands, self.outlet, self.journal)
        self.missions = Missions(self.board, self.commands, self.outlet)
        self.rearming = Rearmer(
            board=self.board,
            commands=self.commands,
            telemetry=self.telemetry,
            memory=self.memory,
            errors=self.errors,
            on_change=self.changed,
        )

        # The loop with the simulator, and both lines.
        self.stick = Stick(self.outlet, self.clock, self.changed)
        self.hil = Hil(vehicle, self.clock, self.stick)
        self.hil.path = "assisted" if self.memory.now.hil_path == "assisted" else "manual"
        self.simulator = Simulator(self.hil, self.clock, simulator_tap, self.errors.report, self._on_line)
        opener = LinkOpener(self.hil, lambda: self.simulator.address is not None)
        self.supervisor = Supervisor(
            self.board, self.clock, board_tap, self.errors.report, self._on_line, self._may_wait, opener
        )
        self.lines = Lines(
            board=self.board,
            supervisor=self.supervisor,
            simulator=self.simulator,
            hil=self.hil,
            parameters=self.parameters,
            memory=self.memory,
            recorder=self.recorder,
            on_change=self.changed,
        )
        self.switches = HilSwitches(
            board=self.board,
            commands=self.commands,
            hil=self.hil,
            memory=self.memory,
            notes=self.notes,
            errors=self.errors,
            on_change=self.changed,
        )
        self.rates = LineRates()
        self.ahrs_test = AhrsTestRun(
            vehicle=vehicle, clock=self.clock, errors=self.errors, flies=self._flies, changed=self._on_ahrs_test
        )

        noted = (self.notes, self.board, self.parameters, self.stick, self.supervisor, self.simulator)
        self._known = KnownNotes(*noted, self.memory.now.aircraft)

        # Alarms and housekeeping.
        self.watch = Watch(
            supervisor=self.supervisor,
            board=self.board,
            telemetry=self.telemetry,
            parameters=self.parameters,
            simulator=self.simulator,
            hil=self.hil,
            recorder=self.recorder,
            steady_s=self.clock.steady_s,
            wants=lambda stream: stream in self.memory.now.wanted.streams,
            surroundings=ToldSurroundings(
                self.memory.now.watched,
                lambda watched: self.memory.update(watched=watched),
                now_s=self.clock.steady_s(),
            ),
        )
        self._alarm_history = AlarmHistory(data_dir / "alarms.jsonl", self.errors.report)
        self.alarms = Alarms(
            self.watch,
            self.outlet,
            self.memory.now.thresholds,
            lambda chosen: self.memory.update(thresholds=chosen),
            past=self._alarm_history.past,
            on_past=self._alarm_history.keep,
        )

        self._housekeeping = Housekeeping(
            clock=self.clock,
            outlet=self.outlet,
            board=self.board,
            supervisor=self.supervisor,
            simulator=self.simulator,
            stick=self.stick,
            ahrs_test=self.ahrs_test,
            rates=self.rates,
            alarms=self.alarms,
            recorder=self.recorder,
            log=self._log,
            clock_watch=ClockWatch(self.clock, self.notes.know),
            on_change=self.changed,
        )

        # The status that stations see, and the requests that they may make.
        self._status_sources = StatusSources(
            self.clock,
            self.errors,
            self.memory,
            self.board,
            self.telemetry,
            self.supervisor,
            self.lines,
            self.simulator,
            self.hil,
            self.rates,
            self.ahrs_test,
            self.recorder,
            self.alarms,
        )
        inspector_sources = InspectorSources(
            self.clock,
            self.board,
            self.telemetry,
            self.supervisor,
            self.simulator,
            self.hil,
            self.rates,
            self.memory,
            self.watch,
            self.alarms,
        )
        self._advised = AdviceWatch(inspector_sources, self.outlet)
        self._requests = self._client_names.remembering(
            {
                **state_requests(self.status, vehicle.newest, inspector_sources),
                **line_requests(self.lines, self.supervisor, self.simulator),
                **command_requests(self.board, self.commands, self.parameters, self.ahrs_test, self.outlet, self.hil),
                **parameter_requests(self.parameters),
                **mission_requests(self.missions),
                **self.switches.requests(),
                **alarm_requests(self.alarms, self.watch.battery),
                **recording_requests(self.recorder, self.notes, self._known, self.memory, self.outlet),
            }
        )
        self._connect()

    def _connect(self) -> None:
        """Connect parts that need each other and so cannot both get the other at construction."""
        self._known.listen(self.outlet, self.missions)
        self.board.on_urgent = self.hil.on_urgent
        self.board.on_opened = self._on_opened
        self.board.on_restarted = self._on_restarted
        self.commands.on_done = self.rearming.command_done
        self.alarms.on_acknowledged = self._on_acknowledged
        self.alarms.on_news = lambda news, alarm: self._log.alarm(news, alarm.state)

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
        return build_status(self._status_sources)

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

    def _flies(self) -> bool:
        """An autopilot is on, or the board moves the simulator's surfaces: it must keep hearing commands."""
        heartbeat = self.telemetry.newest("heartbeat") or {}
        moves = self.simulator.state == "open" and self.hil.path == "assisted"
        return moves or any(heartbeat.get(flag) is True for flag in ("autopilot", "autopilot_hil"))

    def _may_wait(self) -> bool:
        """Whether neither the HIL loop nor a station needs the board's bytes as they come."""
        return self.hil.link is None and (self.outlet.gathers or not self.outlet.has_listeners)

    def _on_ahrs_test(self) -> None:
        if self.board.exclusive_user is not None:
            self.hil.rest()
        self.changed()

    def _on_opened(self) -> None:
        # At once and not in the re-arming task, which may be busy: it would discard values that were loaded meanwhile.
        self._known.identity()
        self._known.forget_plans()
        self.parameters.forget()
        self.rearming.board_opened()

    def _on_restarted(self, restart: Restart) -> None:
        """The board lost what was not stored on its card: report what that was."""
        self._log.board_restarted(restart.uptime_ms)
        self._known.forget_plans()
        parameters, plans = list(self.parameters.take_unstored()), list(self.missions.take_known())
        self.outlet.event(BoardRestartEvent(uptime_ms=restart.uptime_ms, parameters=parameters, plans=plans))

    def _on_acknowledged(self, alarm: AlarmId) -> None:
        if alarm == "parameter_not_confirmed":
            self.parameters.accept_unconfirmed()
        self.changed()

    def _on_line(self) -> None:
        self._known.lines()
        if not self.board.is_open:
            self.parameters.forget()
            self._known.forget_plans()
        self.commands.link_changed()
        self._housekeeping.log_links()
        self.outlet.event(LinkEvent(self.supervisor.state, self.simulator.state))
        # At once: viewers must know the new link state before its first samples, above all that they are emulated.
        self._send_status()
