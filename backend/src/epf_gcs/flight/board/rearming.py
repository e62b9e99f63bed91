"""Each time a board opens, restore the streams, periods and control source that were requested before, read the gains
again that were known and the board's own, and ask for the times of HIL steps."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from epf_gcs.error_log import ErrorLog
from epf_gcs.errors import GatewayError
from epf_gcs.flight.board.commands import Commands
from epf_gcs.flight.board.parameters import Parameters
from epf_gcs.flight.memory.memory import Memory
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.telemetry import Telemetry
from epf_gcs.vehicle.wanted import RATE_COMMANDS


class Rearmer:
    """Never switches an autopilot on: it may have been switched off for a reason."""

    def __init__(
        self,
        *,
        board: Board,
        commands: Commands,
        parameters: Parameters,
        telemetry: Telemetry,
        memory: Memory,
        errors: ErrorLog,
        on_change: Callable[[], None],
    ) -> None:
        self._board = board
        self._commands = commands
        self._parameters = parameters
        self._telemetry = telemetry
        self._memory = memory
        self._errors = errors
        self._on_change = on_change
        self._opened = asyncio.Event()

    def board_opened(self) -> None:
        """The board's session is open, or open again."""
        self._opened.set()

    def command_done(self, name: str, arguments: tuple[float, ...]) -> None:
        """Remember what this command requests, and expect the board's new periods."""
        self._memory.update(wanted=self._memory.now.wanted.after(name, arguments))
        if name in RATE_COMMANDS:
            self._telemetry.rate_changed(name)
            self._board.frame_statistics.rate_changed(name)
            if name == RATE_COMMANDS[0]:
                self._board.session.expect_heartbeat_every(arguments[0] / 1000.0)

    async def run(self) -> None:
        """Restore the requested state after each opening, forever."""
        while True:
            await self._opened.wait()
            self._opened.clear()
            self._on_change()
            if self._board.is_emulated:
                continue
            for restore in (self._restore, self._parameters.own.read):
                try:
                    await restore()
                except GatewayError as error:
                    self._errors.report(error)

    async def _restore(self) -> None:
        wanted = self._memory.now.wanted
        self._board.session.expect_heartbeat_every(wanted.period_s(RATE_COMMANDS[0]))
        for name, arguments in wanted.missing(self._telemetry.newest("heartbeat") or {}):
            await self._commands.run(name, arguments, client="gateway")
        await self._parameters.read_again()
        if self._board.capabilities().get("has_hil_steps"):
            # So that the recording can be flown again: nobody here needs them.
            await self._commands.run("hil_steps_on", quiet=True)
