"""Requests about the HIL switches and the pilot's stick, and the notices that keep the stick alive."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from epf_gcs.bus.definition import Asker, Client
from epf_gcs.bus.vehicle_end import Handlers
from epf_gcs.contract.base import ControlSource, StickSource, SurfacePath
from epf_gcs.contract.notices import ControlChange, Notice, StickRelease, StickSample
from epf_gcs.contract.requests import ReadHil, SetHil
from epf_gcs.contract.status import HilState
from epf_gcs.error_log import ErrorLog
from epf_gcs.errors import BoardError
from epf_gcs.flight.board.commands import Commands
from epf_gcs.flight.hil.hil import Hil
from epf_gcs.flight.hil.stick import Stick
from epf_gcs.flight.memory.memory import Memory
from epf_gcs.flight.recording.flight_notes import FlightNotes
from epf_gcs.flight.state.status import hil_state
from epf_gcs.recordings.notes import EVENT
from epf_gcs.vehicle.board import Board


class HilSwitches:
    """Who holds the stick (source), who moves the simulator's surfaces (path), and simulator or gamepad (stick)."""

    def __init__(
        self,
        *,
        board: Board,
        commands: Commands,
        hil: Hil,
        memory: Memory,
        notes: FlightNotes,
        errors: ErrorLog,
        on_change: Callable[[], None],
    ) -> None:
        self._board = board
        self._commands = commands
        self._hil = hil
        self._memory = memory
        self._notes = notes
        self._errors = errors
        self._on_change = on_change
        hil.on_taken = self._path_taken
        self.note()

    async def choose_source(self, source: ControlSource, client: str | None) -> None:
        """Set the board's control source and wait for its confirmation. Raises BoardError."""
        result = await self._commands.run("control_source", (int(source == "joystick"),), client=client)
        if not result.done:
            raise BoardError(
                "source_not_taken",
                f"The control source is still {self._hil.source}: the board did not take the change "
                f"({result.reason or result.state}); try again.",
                reason=result.reason or result.state,
            )

    def choose_path(self, path: SurfacePath) -> None:
        """Set the path; it is kept across restarts."""
        self._hil.path = "assisted" if path == "assisted" else "manual"
        self._path_changed()

    def _path_taken(self) -> None:
        self._errors.report(
            BoardError(
                "profile_took_surfaces",
                "The surfaces were taken from the board and given to the stick because the simulator's profile is "
                "wrong: fly by hand, choose the other profile in the simulator's link, then assist again.",
            )
        )
        self._path_changed()

    def _path_changed(self) -> None:
        self._memory.update(hil_path=self._hil.path)
        self.note()
        self._on_change()

    def note(self) -> None:
        """Path and source in the recording: now, and at the start of each later file."""
        data = {"path": self._hil.path, "source": self._hil.source}
        self._notes.know(EVENT, {"event": "hil", "data": data}, "hil")

    async def choose_stick(self, stick: StickSource, gamepad: str, client: str | None) -> None:
        """Choose simulator or gamepad. Raises ConflictError if that gamepad cannot be used."""
        if stick == "gamepad":
            await self._hil.stick.choose_gamepad(client, gamepad)
        else:
            self._hil.stick.choose_simulator()

    def requests(self) -> Handlers:
        """Both answer with the HIL state."""
        return {ReadHil: self._read, SetHil: self._write}

    async def _read(self, _: ReadHil, __: Asker) -> HilState:
        return hil_state(self._hil)

    async def _write(self, request: SetHil, by: Asker) -> HilState:
        source, path, stick = request.source, request.path, request.stick
        if stick != "simulator" or source is not None or path is not None:
            self._board.check_commandable()
        if path == "assisted":
            self._hil.check_profile()
        if source is not None:
            await self.choose_source(source, by.client)
        if path is not None:
            self.choose_path(path)
        if stick is not None:
            await self.choose_stick(stick, request.gamepad, by.client)
        state = hil_state(self._hil)
        return state if source is None else replace(state, source=source)


def take_stick_notice(stick: Stick, notice: Notice) -> None:
    """Keep the stick alive, let it go, or hear who has control."""
    match notice:
        case StickSample(client, sample):
            stick.take(client, dict(sample))
        case StickRelease(client):
            stick.let_go(client)
        case ControlChange(client=None):
            stick.control_changed(None)
        case ControlChange(str(client), name, about, kept):
            page = Client(client, name or "", about)
            if kept:
                stick.control_changed(None, page)
            else:
                stick.control_changed(page)
