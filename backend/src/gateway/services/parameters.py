"""The 17 gains on the board: read, set with read-back, store. A load only reads."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from typing import Any, Final

from gateway.codec.frame import Frame
from gateway.codec.messages_gen import COMMANDS_BY_ID
from gateway.codec.values import Json, Meaning
from gateway.errors import BoardError, InvalidInputError, NotFoundError
from gateway.services.board import Board
from gateway.services.commands import CommandResult, Commands
from gateway.services.hub import Hub
from gateway.vehicle import parameters as gains
from gateway.vehicle.parameters import BY_NAME, UNKNOWN, Held17

_READ_S: Final = 1.0


class Parameters:
    """What is held here is what the board said last, never what somebody hoped to have set."""

    def __init__(self, board: Board, commands: Commands, hub: Hub) -> None:
        self._board = board
        self._commands = commands
        self._hub = hub
        self._lock = asyncio.Lock()
        self.held: Held17 = UNKNOWN
        board.listen(self._on_frame)

    def forget(self) -> None:
        """The board is gone or started anew: what it has is not known any more."""
        self._replace(UNKNOWN)

    async def load(self, client: str | None) -> None:
        """Read all from the board. Raises BoardError where it does not answer."""
        async with self._lock:
            await self._read(client)

    async def set(self, changes: Mapping[str, float], client: str | None) -> None:
        """Set some and read all back. Raises InvalidInputError before anything is sent, BoardError without answer."""
        self._check(changes)
        async with self._lock:
            self._commands.check_ready(COMMANDS_BY_ID[BY_NAME[next(iter(changes))].set_id])
            self._replace(gains.with_state(self.held, changes, "pending"))
            try:
                for name, value in changes.items():
                    parameter = BY_NAME[name]
                    argument = int(value) if parameter.is_integer else value
                    await self._commands.run(COMMANDS_BY_ID[parameter.set_id].name, (argument,), client=client)
                values = await self._read(client)
            except BaseException:
                self._replace({**self.held, **{name: UNKNOWN[name] for name in changes}})
                raise
            refused = dict.fromkeys(gains.differing(changes, values))
            taken = {name: None for name in changes if name not in refused}
            self._replace(gains.with_state(gains.with_state(self.held, refused, "rejected"), taken, "confirmed"))

    async def store(self, client: str | None) -> CommandResult:
        """Write them to the board's card."""
        return await self._commands.run("store_parameters", client=client)

    async def _read(self, client: str | None) -> Mapping[str, Json]:
        heard: asyncio.Future[Mapping[str, Json]] = asyncio.get_running_loop().create_future()

        def listen(frame: Frame, meant: Meaning) -> None:
            if frame.message.name == "autopilot_parameters" and not heard.done():
                heard.set_result(meant.values)

        with self._board.listening(listen):
            result = await self._commands.run("load_autopilot_parameters", client=client)
            try:
                async with asyncio.timeout(_READ_S):
                    return await heard
            except TimeoutError:
                raise BoardError(
                    "parameters_not_read",
                    f"The parameters were not read because the board did not send them ({result.state}): try again.",
                    state=result.state,
                ) from None

    def _check(self, changes: Mapping[str, float]) -> None:
        for name, value in changes.items():
            if name not in BY_NAME:
                raise NotFoundError(
                    "parameter_unknown",
                    f"There is no parameter '{name}': GET /api/v1/parameters lists the 17.",
                    field=name,
                )
            fault = gains.fault(name, value)
            if fault is not None:
                parameter = BY_NAME[name]
                raise InvalidInputError(
                    "parameter_out_of_range",
                    fault,
                    field=name,
                    value=value,
                    minimum=parameter.minimum,
                    maximum=parameter.maximum,
                )

    def _on_frame(self, frame: Frame, meant: Meaning) -> None:
        if frame.message.name == "autopilot_parameters":
            self._replace(gains.after_read(self.held, meant.values))

    def _replace(self, held: Held17) -> None:
        """Take the new state and tell what changed in it."""
        changed: dict[str, Any] = {
            name: {"value": None if one.value is None else gains.shown(name, one.value), "state": one.state}
            for name, one in held.items()
            if one != self.held[name]
        }
        self.held = held
        if changed:
            self._hub.event("parameter", {"parameters": changed})
