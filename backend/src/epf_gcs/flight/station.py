"""All running parts of the gateway, put together once and told when to begin and to end."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncIterator, Awaitable, Callable
from pathlib import Path
from typing import Any, Final

import structlog

from epf_gcs import __version__
from epf_gcs.clock import Clock
from epf_gcs.error_log import ErrorLog
from epf_gcs.errors import GatewayError
from epf_gcs.flight.board.ahrs_test import AhrsTestRun
from epf_gcs.flight.board.board_link import Supervisor
from epf_gcs.flight.board.commands import Commands
from epf_gcs.flight.board.journal import Journal
from epf_gcs.flight.board.missions import Missions
from epf_gcs.flight.board.parameters import Parameters
from epf_gcs.flight.hil.emulation import PROFILE, EmulationLink
from epf_gcs.flight.hil.hil import Hil
from epf_gcs.flight.hil.simulator import Simulator, SimulatorAddress
from epf_gcs.flight.hil.stick import Stick
from epf_gcs.flight.line_rates import LineRates
from epf_gcs.flight.memory import Memory
from epf_gcs.flight.recording.recorder import Recorder
from epf_gcs.flight.watch import Watch
from epf_gcs.link.address import EMULATION, LinkAddress, parse_address
from epf_gcs.link.base import Link
from epf_gcs.link.open import open_link
from epf_gcs.vehicle.alarms import Alarms
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.judges import AlarmId
from epf_gcs.vehicle.telemetry import Telemetry
from epf_gcs.vehicle.wanted import RATE_COMMANDS, Wanted
from epf_gcs.web.access.control import Client, Control
from epf_gcs.web.maps.maps import Maps
from epf_gcs.web.stream.hub import Hub
from epf_gcs.web.track.tracks import Tracks

_TICK_S: Final = 0.1
_STATUS_EVERY_TICKS: Final = 5
_RESTART_S: Final = 1.0

log = structlog.get_logger("gateway")


class Station:
    """Made on the running loop. `board_url` overrides the remembered board."""

    def __init__(self, data_dir: Path, errors: ErrorLog, *, record: bool, board_url: str | None = None) -> None:
        loop = asyncio.get_running_loop()
        self._loop = loop
        self._board_url = board_url
        self._status_due = False
        self._recording: Path | None = None
        # Set by the composition: makes the status text that all viewers get.
        self.status_text: Callable[[], bytes] = lambda: b"{}"
        self.before_emulation: LinkAddress | None = None
        self.recordings_dir = data_dir / "recordings"
        self.clock = Clock()
        self.hub = Hub(loop, self.clock.now_s)
        self.errors = errors
        errors.tell_viewers(self.clock.steady_s, self.hub.event)
        self.memory = Memory(data_dir / "state.json", self._report)
        self.telemetry = Telemetry(self.hub, self.clock, self._commanded_period_s)
        self.control = Control(loop, self._on_control)
        self.recorder = Recorder(self.recordings_dir, self.clock, f"epf-gcs {__version__}") if record else None
        taps = (self.recorder.board_tap, self.recorder.simulator_tap) if self.recorder else (None, None)
        self.board = Board(self.clock, self.hub, self.telemetry, self.errors)
        self.commands = Commands(self.board, self.telemetry, self.hub, self.clock, self.errors)
        journal = Journal(
            data_dir / "parameter-journal.jsonl",
            clock=self.clock,
            hub=self.hub,
            report=self._report,
            name_of=self.control.name_of,
        )
        self.parameters = Parameters(self.board, self.commands, self.hub, journal)
        self.missions = Missions(self.board, self.commands, self.hub)
        self.stick = Stick(self.control, self.hub, self.clock, self.changed)
        self.hil = Hil(self.board, self.telemetry, self.hub, self.clock, self.stick)
        self.supervisor = Supervisor(self.board, taps[0], self._report, self._on_link, self._open_link)
        self.simulator = Simulator(self.hil, self.clock, taps[1], self._report, self._on_link)
        self.ahrs_test = AhrsTestRun(
            board=self.board,
            telemetry=self.telemetry,
            hub=self.hub,
            clock=self.clock,
            errors=self.errors,
            flies=self._flies,
            changed=self._on_ahrs_test,
        )
        self.rates = LineRates()
        self.tracks = Tracks(self.telemetry, self.hub, self.clock, lambda: self.board.is_emulated)
        self.maps = Maps(data_dir / "maps", self.hub, self.clock, self.memory, self._report)
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
        )
        self.alarms = Alarms(
            self.watch, self.hub, self.memory.now.thresholds, lambda chosen: self.memory.update(thresholds=chosen)
        )
        self.alarms.on_acknowledged = self._on_acknowledged
        self._board_opened = asyncio.Event()
        self.board.on_urgent = self.hil.on_urgent
        self.board.on_opened = self._on_opened
        self.commands.on_done = self._on_command_done

    @contextlib.asynccontextmanager
    async def running(self) -> AsyncIterator[None]:
        """Everything runs inside; at the end board and simulator are let go as they should be."""
        if self.recorder is not None:
            self.recorder.start()
        self._remember_links()
        try:
            async with asyncio.TaskGroup() as tasks:
                running = [
                    tasks.create_task(self._keep_alive(name, job), name=name)
                    for name, job in (
                        ("board link", self.supervisor.run),
                        ("simulator link", self.simulator.run),
                        ("re-arming", self._rearm),
                        ("housekeeping", self._keep_house),
                        ("maps", self.maps.run),
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
            if self.recorder is not None:
                await asyncio.to_thread(self.recorder.stop)
            await asyncio.to_thread(self.parameters.journal.close)
            await asyncio.to_thread(self.memory.close)
            await self.maps.close()

    def changed(self) -> None:
        """Something in the status changed that should be seen now and not in half a second."""
        if not self._status_due:
            self._status_due = True
            self._loop.call_soon(self._send_status)

    async def close_board(self) -> None:
        """The operator ends the session with this board: nothing of it is asked for again.

        Ending the emulation gives back what was open before it.
        """
        if self.board.is_emulated:
            before, identity = self.before_emulation, self.memory.now.board_identity
            await self.supervisor.close()
            self._end_emulation()
            if before is not None:
                self.supervisor.want(before, identity if before.url == self.memory.now.board_url else None)
            self.changed()
            return
        await self.supervisor.close()
        self.parameters.forget()
        self.memory.update(board_url=None, board_identity=None, wanted=Wanted())
        self._end_recording_if_idle()

    async def open_board(self, address: LinkAddress) -> None:
        """Open a board link and remember it; the emulation alone is forgotten with the gateway."""
        was_emulated, before = self.board.is_emulated, self.supervisor.address
        await self.supervisor.open(address)
        if address == EMULATION:
            self.before_emulation = self.before_emulation if was_emulated else before
            self.changed()
            return
        if was_emulated:
            self._end_emulation()
        self.memory.update(board_url=address.url, board_identity=self.supervisor.identity)
        self._note("board_link", {"url": address.url})

    async def open_simulator(self, address: SimulatorAddress) -> None:
        """Open the simulator's socket and remember it."""
        await self.simulator.open(address)
        self.memory.update(simulator=address.as_dict())
        self._note("simulator_link", {name: str(value) for name, value in address.as_dict().items()})

    async def close_simulator(self) -> None:
        """Hand the simulator its controls back and forget it."""
        await self.simulator.close()
        self.memory.update(simulator=None)
        self._end_recording_if_idle()

    def set_path(self, path: str) -> None:
        """Who moves the simulator's surfaces from now on."""
        self.hil.path = "assisted" if path == "assisted" else "manual"
        self.memory.update(hil_path=self.hil.path)
        self.changed()

    async def set_stick(self, source: str, client: str | None, gamepad: str) -> None:
        """Where the pilot's stick comes from. Raises ConflictError where that gamepad cannot be flown with."""
        if source == "gamepad":
            await self.stick.choose_gamepad(client, gamepad)
            self._note("stick", {"source": source, "gamepad": gamepad})
        else:
            self.stick.choose_simulator()
            self._note("stick", {"source": source})

    async def _open_link(self, address: LinkAddress) -> Link:
        if address != EMULATION:
            return await open_link(address)
        if self.simulator.address is None:
            self.hil.begin(None, PROFILE)
        return EmulationLink(self._take_example)

    def _take_example(self, datagram: bytes) -> None:
        """What a simulator would have sent, where none is connected."""
        if self.simulator.address is None:
            self.hil.on_datagram(datagram)

    def _end_emulation(self) -> None:
        self.before_emulation = None
        self.parameters.forget()
        self.tracks.forget_examples()
        if self.simulator.address is None:
            self.hil.begin(None, PROFILE)

    def _remember_links(self) -> None:
        remembered = self.memory.now
        self.hil.path = "assisted" if remembered.hil_path == "assisted" else "manual"
        url = self._board_url or remembered.board_url
        try:
            if url is not None:
                identity = remembered.board_identity if url == remembered.board_url else None
                self.supervisor.want(parse_address(url), identity)
            if remembered.simulator is not None:
                self.simulator.want(SimulatorAddress(**remembered.simulator))
        except (GatewayError, TypeError) as error:
            log.error("a remembered link cannot be opened", reason=str(error))

    async def _keep_alive(self, name: str, job: Callable[[], Awaitable[None]]) -> None:
        """The top of each task: a fault of ours in one of them must not end a flight."""
        while True:
            try:
                await job()
            except Exception:
                log.exception("a part failed and begins again", part=name)
                self.errors.count("internal")
                await asyncio.sleep(_RESTART_S)

    async def _rearm(self) -> None:
        """Each time the board opens, bring it to what was asked of it before."""
        while True:
            await self._board_opened.wait()
            self._board_opened.clear()
            self.changed()
            if self.board.is_emulated:
                continue
            wanted = self.memory.now.wanted
            self.board.session.expect_heartbeat_every(wanted.period_s(RATE_COMMANDS[0]))
            for name, arguments in wanted.missing(self.telemetry.newest("heartbeat") or {}):
                try:
                    await self.commands.run(name, arguments, client="gateway")
                except GatewayError as error:
                    self.errors.report(error)
                    break

    async def _keep_house(self) -> None:
        ticks = 0
        while True:
            await asyncio.sleep(_TICK_S)
            self.board.tick()
            self.ahrs_test.tick()
            self.stick.tick()
            ticks += 1
            if ticks % _STATUS_EVERY_TICKS == 0:
                self.rates.note(self.clock.steady_s(), self.board, self.simulator)
                self.changed()
            if self.alarms.look(self.clock.now_s()):
                self.changed()
            self._watch_recording()

    def _watch_recording(self) -> None:
        """Tell the viewers when a file begins or ends; the thread that writes it cannot."""
        file = self.recorder.file if self.recorder is not None else None
        if file != self._recording:
            self._recording = file
            self.hub.event("recording", {"active": file is not None, "file": None if file is None else file.name})
            self.changed()

    def _send_status(self) -> None:
        self._status_due = False
        if self.hub.viewers:
            self.hub.status(self.status_text())

    def _on_command_done(self, name: str, arguments: tuple[float, ...]) -> None:
        self.memory.update(wanted=self.memory.now.wanted.after(name, arguments))
        if name in RATE_COMMANDS:
            self.telemetry.rate_changed(name)
            self.board.books.rate_changed(name)
            if name == RATE_COMMANDS[0]:
                self.board.session.expect_heartbeat_every(arguments[0] / 1000.0)

    def _flies(self) -> bool:
        """An autopilot is on, or the board moves the simulator's surfaces: it must not be left alone."""
        heartbeat = self.telemetry.newest("heartbeat") or {}
        moves = self.simulator.state == "open" and self.hil.path == "assisted"
        return moves or any(heartbeat.get(flag) is True for flag in ("autopilot", "autopilot_hil"))

    def _on_ahrs_test(self) -> None:
        if self.board.guest is not None:
            self.hil.rest()
        self.changed()

    def _commanded_period_s(self, rate_command: str) -> float:
        return self.memory.now.wanted.period_s(rate_command)

    def _on_control(self, holder: Client | None) -> None:
        data: dict[str, Any] = {"client": holder.id if holder else None, "name": holder.name if holder else None}
        self.hub.event("control", data)
        self.stick.control_changed(holder)
        self.changed()

    def _on_opened(self) -> None:
        # At once and not with the re-arming, which may be busy: whoever loads now must not lose what was read.
        self.parameters.forget()
        self._board_opened.set()

    def _on_acknowledged(self, alarm: AlarmId) -> None:
        if alarm == "parameter_not_confirmed":
            self.parameters.accept_unconfirmed()
        self.changed()

    def _on_link(self) -> None:
        if not self.board.is_open:
            self.parameters.forget()
        self.hub.event("link", {"board": self.supervisor.state, "simulator": self.simulator.state})
        self.changed()

    def _report(self, error: GatewayError) -> None:
        self.errors.report(error)

    def _note(self, name: str, values: dict[str, str]) -> None:
        if self.recorder is not None:
            self.recorder.note(name, values)

    def _end_recording_if_idle(self) -> None:
        if self.recorder is not None and self.supervisor.address is None and self.simulator.address is None:
            self.recorder.end_session()
