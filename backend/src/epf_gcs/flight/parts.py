"""The parts of the flight process in groups, each made by a function from the groups before it.

common (recording too) -> board -> loop (HIL and both lines) -> alarms
"""

from __future__ import annotations

import asyncio
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from epf_gcs import __version__
from epf_gcs.codec.tables import Waypoint
from epf_gcs.contract.base import PlanName
from epf_gcs.contract.events import ErrorEvent
from epf_gcs.error_log import ErrorLog
from epf_gcs.flight.board.ahrs_test import AhrsTestRun
from epf_gcs.flight.board.board_link import Supervisor
from epf_gcs.flight.board.commands import Commands
from epf_gcs.flight.board.journal import Journal
from epf_gcs.flight.board.missions import Missions
from epf_gcs.flight.board.own_gains import OwnGainValues
from epf_gcs.flight.board.own_table import OwnTableReader
from epf_gcs.flight.board.parameters import Parameters
from epf_gcs.flight.board.rearming import Rearmer
from epf_gcs.flight.clock.line_clock import LineClock
from epf_gcs.flight.hil.hil import Hil
from epf_gcs.flight.hil.simulator import Simulator
from epf_gcs.flight.hil.simulator_faults import SimulatorFaultControl
from epf_gcs.flight.hil.stick import Stick
from epf_gcs.flight.memory.memory import Memory
from epf_gcs.flight.recording.flight_notes import FlightNotes, NotedBroadcast
from epf_gcs.flight.recording.recorder import Recorder
from epf_gcs.flight.recording.taps import line_taps
from epf_gcs.flight.requests.client_names import ClientNames
from epf_gcs.flight.requests.hil import HilSwitches
from epf_gcs.flight.state.alarm_history import AlarmHistory
from epf_gcs.flight.state.lines import BothLines, Lines, LinkOpener
from epf_gcs.flight.state.watch import Watch
from epf_gcs.recordings.notes import EVENT
from epf_gcs.repeating import log_and_count_failures
from epf_gcs.vehicle.alarms import Alarm, Alarms, News
from epf_gcs.vehicle.restart import Restart
from epf_gcs.vehicle.surroundings import ToldSurroundings
from epf_gcs.vehicle.vehicle import Vehicle


class Owner(Protocol):
    """The flight, as far as its parts call it."""

    def changed(self) -> None:
        """The status should be sent at once."""

    def on_line(self) -> None:
        """A line opened, was lost or closed."""

    def on_ahrs_test(self) -> None:
        """The AHRS test began or ended."""

    def may_wait(self) -> bool:
        """Whether neither the HIL loop nor a station needs the board's bytes as they come."""

    def flies(self) -> bool:
        """Whether the board flies something, and must keep hearing commands."""

    def on_opened(self) -> None:
        """Commands can be sent to the board."""

    def on_restarted(self, restart: Restart) -> None:
        """The board has lost what it was told."""

    def on_parameters(self) -> None:
        """Gains have changed."""

    def on_plan_read(self, plan: PlanName, waypoints: list[Waypoint]) -> None:
        """A plan was read from the board."""

    def on_holder(self) -> None:
        """Another page, or none, has control."""

    def on_alarm(self, news: News, alarm: Alarm) -> None:
        """An alarm came, went or was acknowledged."""


@dataclass(frozen=True, slots=True)
class Common:
    """What every other part uses."""

    folder: Path
    clock: LineClock
    recorder: Recorder | None
    notes: FlightNotes
    outlet: NotedBroadcast
    errors: ErrorLog
    memory: Memory
    client_names: ClientNames


def make_common(folder: Path, owner: Owner, *, record: bool) -> Common:
    """`folder`: of the station's data. Called on the running loop, whose failures it counts from now on."""
    clock = LineClock()
    # Writes every byte of both lines, before anybody decodes it.
    recorder = Recorder(folder / "recordings", clock, f"epf-gcs {__version__}") if record else None
    notes = FlightNotes(recorder, clock)
    outlet = NotedBroadcast(clock, notes, owner.on_parameters)
    errors = ErrorLog()
    log_and_count_failures(asyncio.get_running_loop(), "flight", lambda: errors.count("internal"))
    errors.tell_viewers(clock.steady_s, lambda *told: outlet.event(ErrorEvent.of(*told)))
    memory = Memory(folder / "state.json", errors.report)
    return Common(folder, clock, recorder, notes, outlet, errors, memory, ClientNames())


@dataclass(frozen=True, slots=True)
class BoardParts:
    """The board as it is known, recorded before it is decoded, and what can be asked of it."""

    vehicle: Vehicle
    commands: Commands
    journal: Journal
    parameters: Parameters
    missions: Missions
    rearming: Rearmer


def make_board(common: Common, owner: Owner) -> BoardParts:
    """The vehicle, and who sends to it."""
    memory, outlet = common.memory, common.outlet
    period_s = lambda rate: memory.now.wanted.period_s(rate)  # noqa: E731, PLW0108 (`now` is replaced)
    vehicle = Vehicle(
        common.clock, outlet, common.errors, period_s, on_opened=owner.on_opened, on_restarted=owner.on_restarted
    )
    board = vehicle.board
    commands = Commands(board, vehicle.telemetry, outlet, common.clock, common.errors)
    journal = Journal(
        common.folder / "parameter-journal.jsonl",
        clock=common.clock,
        outlet=outlet,
        report=common.errors.report,
        name_of=common.client_names.name_of,
    )
    reader = OwnTableReader(board, commands, common.folder / "own-gains.json", common.errors.report)
    own = OwnGainValues(board, commands, outlet, common.clock, reader)
    parameters = Parameters(board, commands, outlet, journal, own)
    rearming = Rearmer(
        board=board,
        commands=commands,
        parameters=parameters,
        telemetry=vehicle.telemetry,
        memory=memory,
        errors=common.errors,
        on_change=owner.changed,
    )
    missions = Missions(board, commands, outlet, owner.on_plan_read)
    return BoardParts(vehicle, commands, journal, parameters, missions, rearming)


@dataclass(frozen=True, slots=True)
class LoopParts:
    """The loop with the simulator, and both lines."""

    stick: Stick
    hil: Hil
    simulator: Simulator
    faults: SimulatorFaultControl
    supervisor: Supervisor
    both: BothLines
    lines: Lines
    switches: HilSwitches
    ahrs_test: AhrsTestRun


def make_loop(common: Common, parts: BoardParts, owner: Owner) -> LoopParts:
    """The supervisor opens the board's line, `lines` both on request."""
    clock, memory, report = common.clock, common.memory, common.errors.report
    board, vehicle = parts.vehicle.board, parts.vehicle
    board_tap, simulator_tap = common.recorder.taps if common.recorder else line_taps(clock, None)
    stick = Stick(common.outlet, clock, owner.changed, owner.on_holder)
    hil = Hil(vehicle, clock, stick)
    hil.path = "assisted" if memory.now.hil_path == "assisted" else "manual"
    simulator = Simulator(hil, clock, simulator_tap, report, owner.on_line)
    faults = SimulatorFaultControl(
        simulator.order,
        common.outlet,
        clock,
        lambda flown: common.notes.know(EVENT, {"event": "faults", "data": flown}, "faults"),
        owner.changed,
    )
    simulator.on_report = faults.on_datagram
    opener = LinkOpener(hil, lambda: simulator.address is not None)
    supervisor = Supervisor(
        board,
        clock,
        board_tap,
        report=report,
        on_change=owner.on_line,
        may_wait=owner.may_wait,
        open_link=opener,
    )
    both = BothLines(board, supervisor, simulator, hil)
    lines = Lines(
        both,
        parameters=parts.parameters,
        memory=memory,
        recorder=common.recorder,
        on_change=owner.changed,
    )
    switches = HilSwitches(
        board=board,
        commands=parts.commands,
        hil=hil,
        memory=memory,
        notes=common.notes,
        errors=common.errors,
        on_change=owner.changed,
    )
    ahrs_test = AhrsTestRun(
        vehicle=vehicle, clock=clock, errors=common.errors, flies=owner.flies, changed=owner.on_ahrs_test
    )
    return LoopParts(stick, hil, simulator, faults, supervisor, both, lines, switches, ahrs_test)


@dataclass(frozen=True, slots=True)
class AlarmParts:
    """What looks for faults, and what it found."""

    watch: Watch
    history: AlarmHistory
    alarms: Alarms


def make_alarms(common: Common, parts: BoardParts, loop: LoopParts, owner: Owner) -> AlarmParts:
    """The watch looks at all lines; the alarms ask it."""
    memory = common.memory
    watch = Watch(
        loop.both,
        telemetry=parts.vehicle.telemetry,
        parameters=parts.parameters,
        recorder=common.recorder,
        steady_s=common.clock.steady_s,
        wants=lambda stream: stream in memory.now.wanted.streams,
        surroundings=ToldSurroundings(
            memory.now.watched, lambda watched: memory.update(watched=watched), now_s=common.clock.steady_s()
        ),
    )
    history = AlarmHistory(common.folder / "alarms.jsonl", common.errors.report)
    alarms = Alarms(
        watch,
        common.outlet,
        memory.now.thresholds,
        lambda chosen: memory.update(thresholds=chosen),
        past=history.past,
        on_past=history.keep,
        on_news=owner.on_alarm,
    )
    return AlarmParts(watch, history, alarms)
