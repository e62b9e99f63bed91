"""The gains on the board, the 17 and its own: read, set with read-back, undone, stored. A load only reads."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from typing import Final

from epf_gcs.codec.frame import Frame
from epf_gcs.codec.messages_gen import COMMANDS_BY_ID
from epf_gcs.codec.tables import Message
from epf_gcs.codec.values import Json, Meaning, single
from epf_gcs.contract.answers import CommandOutcome, ParameterChange, WriteOutcome
from epf_gcs.contract.events import ParameterEvent
from epf_gcs.errors import BoardError, ConflictError, InvalidInputError, LinkError, NotFoundError
from epf_gcs.flight.board.commands import Commands
from epf_gcs.flight.board.journal import Journal
from epf_gcs.flight.board.own_gains import OwnGainValues
from epf_gcs.vehicle import parameters as gains
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.journal import Kind, Step
from epf_gcs.vehicle.outside import Outlet
from epf_gcs.vehicle.own_gains import as_held
from epf_gcs.vehicle.parameters import BY_NAME, UNKNOWN, Held17

# Some seconds also on a busy computer: who reads has pressed a key and sees that it is under way.
_READ_S: Final = 3.0


class Parameters:
    """Holds the values that the board reported last, never values that were only requested.

    `unconfirmed` are the gains whose last write the board refused or did not answer. `own` are those that the board
    describes itself: a write of both kinds is a step of the journal for each kind.
    """

    def __init__(self, board: Board, commands: Commands, outlet: Outlet, journal: Journal, own: OwnGainValues) -> None:
        self._board = board
        self._commands = commands
        self._outlet = outlet
        self._lock = asyncio.Lock()
        self._session = 0
        self._is_writing = False
        self._was_known = False
        self.journal = journal
        self.own = own
        self.held: Held17 = UNKNOWN
        self.unconfirmed: tuple[str, ...] = ()
        self._unstored: dict[str, None] = {}
        board.listen("autopilot_parameters", self._on_frame)

    def forget(self) -> None:
        """Forget all values and undo steps: the board is gone or was restarted."""
        self._session += 1
        self._was_known |= any(one.value is not None for one in self.held.values())
        self._replace(UNKNOWN)
        self.own.forget()
        self.journal.forget_steps()

    def accept_unconfirmed(self) -> None:
        """The operator acknowledged the unconfirmed gains: stop listing them."""
        self.unconfirmed = ()

    async def load(self, client: str | None) -> None:
        """Read all from the board. Raises BoardError where it does not answer."""
        async with self._lock:
            await self._read(client, quiet=False)
            self._replace(gains.loaded_now(self.held))
            await self.own.read()
            self.own.mark_loaded()

    async def read_again(self) -> None:
        """Read all if they were known before they were last forgotten. Raises BoardError where it does not answer."""
        if self._was_known:
            async with self._lock:
                await self._read("gateway")
                self._replace(gains.loaded_now(self.held))

    async def set(self, changes: Mapping[str, float], client: str | None) -> None:
        """Set some and read all back. Raises InvalidInputError before anything is sent, BoardError without answer."""
        own = {name: value for name, value in changes.items() if name in self.own}
        built_in = {name: value for name, value in changes.items() if name not in own}
        self._check(built_in)
        for name, value in own.items():
            self.own.check(name, value)
        async with self._lock:
            if built_in:
                await self._write("write", built_in, client)
            if own:
                await self._write_own("write", own, client)

    async def undo(self, client: str | None) -> None:
        """Undo the newest step, with read-back. Raises ConflictError if there is none."""
        none = "Nothing was undone because nothing was written to this board since it opened."
        await self._step("undo", lambda: self.journal.steps.undo, ConflictError("nothing_to_undo", none), client)

    async def redo(self, client: str | None) -> None:
        """Redo the step undone last, with read-back. Raises ConflictError if there is none."""
        none = "Nothing was done again because nothing was undone since the last write."
        await self._step("redo", lambda: self.journal.steps.redo, ConflictError("nothing_to_redo", none), client)

    async def _step(self, kind: Kind, due: Callable[[], Step | None], none: ConflictError, client: str | None) -> None:
        """Write the step that is `due` when its turn has come; raise `none` if nothing waits then."""
        async with self._lock:
            step = due()
            if step is None:
                raise none
            write = self._write_own if step[0].name in self.own else self._write
            await write(kind, {move.name: move.after for move in step}, client)

    async def _write_own(self, kind: Kind, changes: Mapping[str, float], client: str | None) -> None:
        session, tried = self._session, list[ParameterChange]()
        try:
            for name, value in changes.items():
                before = await self.own.value_before(name)
                try:
                    outcome = await self.own.set(name, value, client)
                except BaseException as error:
                    if not isinstance(error, ConflictError):
                        tried.append(ParameterChange(name, before, as_held(value), "timed_out"))
                    raise
                tried.append(ParameterChange(name, before, as_held(value), outcome))
        finally:
            self._note(kind, tried, client, session)

    async def set_by_command(self, command: Message, value: float, client: str | None) -> CommandOutcome:
        """Send one set command without our own read-back, and note it in the journal."""
        name = command.parameter
        async with self._lock:
            session, before = self._session, self._before(name)
            try:
                result = await self._commands.run(command.name, (value,), client=client)
            except LinkError:
                # It was sent, and nobody knows what became of it.
                self._note(
                    "write", [ParameterChange(name, before, gains.as_held(name, value), "timed_out")], client, session
                )
                raise
            outcome: WriteOutcome = (
                "confirmed" if result.done else "rejected" if result.state == "rejected" else "timed_out"
            )
            if session == self._session:
                self._replace(self._after_command(name, value, outcome))
            self._note("write", [ParameterChange(name, before, gains.as_held(name, value), outcome)], client, session)
            return result

    async def store(self, client: str | None) -> CommandOutcome:
        """Store the gains on the board's card."""
        written = tuple(self._unstored)
        result = await self._commands.run("store_parameters", client=client)
        if result.state == "confirmed":
            for name in written:
                self._unstored.pop(name, None)
        return result

    def take_unstored(self) -> tuple[str, ...]:
        """Return the gains written but not stored on the card, and clear that list."""
        unstored, self._unstored = tuple(self._unstored), {}
        return unstored

    async def _write(self, kind: Kind, changes: Mapping[str, float], client: str | None) -> None:
        session = self._session
        if any(self.held[name].value is None for name in changes):
            # The journal and undo need the values from before the write.
            await self._read(client)
        held = self.held
        before = {name: self._before(name) for name in changes}
        self._replace(gains.with_state(held, changes, "pending"))
        results: dict[str, CommandOutcome | None] = {}
        try:
            with self._read_back_follows():
                for name, value in changes.items():
                    results[name] = None
                    results[name] = await self._set(name, value, client)
                values = await self._read(client)
        except BaseException as error:
            if isinstance(error, ConflictError):
                # What was refused before it was sent has not changed.
                results = {name: result for name, result in results.items() if result is not None}
            unsent = {name: held[name] for name in changes if name not in results and session == self._session}
            self._replace({**gains.forgotten(self.held, results), **unsent})
            lost = [
                ParameterChange(name, before[name], gains.as_held(name, changes[name]), "timed_out") for name in results
            ]
            self._end(kind, lost, results, client, session)
            raise
        refused = dict.fromkeys(gains.differing(changes, values))
        taken = {name: None for name in changes if name not in refused}
        read = gains.after_read(self.held, values)
        self._replace(gains.with_state(gains.with_state(read, refused, "rejected"), taken, "confirmed"))
        tried = [
            ParameterChange(
                name,
                before[name],
                gains.as_held(name, value),
                "confirmed" if name in taken else _why_not(results[name]),
            )
            for name, value in changes.items()
        ]
        self._end(kind, tried, results, client, session)

    async def _set(self, name: str, value: float, client: str | None) -> CommandOutcome:
        parameter = BY_NAME[name]
        argument = int(value) if parameter.is_integer else value
        command = COMMANDS_BY_ID[parameter.set_id].name
        return await self._commands.run(command, (argument,), client=client, quiet=True, is_read_back=True)

    @contextmanager
    def _read_back_follows(self) -> Iterator[None]:
        """Inside, do not report gains that arrive: `_write` reports them once, together with the write's outcome."""
        self._is_writing = True
        try:
            yield
        finally:
            self._is_writing = False

    def _end(
        self,
        kind: Kind,
        changes: Iterable[ParameterChange],
        results: Mapping[str, CommandOutcome | None],
        client: str | None,
        session: int,
    ) -> None:
        """Report each gain's outcome once, and note all of them in the journal as one step."""
        changes = list(changes)
        for change in changes:
            result = results[change.name]
            reason = None if result is None or change.state != "rejected" else result.reason or "not_taken"
            ms = 0.0 if result is None else result.ms
            self._commands.tell_outcome(
                COMMANDS_BY_ID[BY_NAME[change.name].set_id].name,
                (change.after,),
                client,
                CommandOutcome(change.state, "read_back", ms, reason),
            )
        self._note(kind, changes, client, session)

    def _note(self, kind: Kind, changes: Iterable[ParameterChange], client: str | None, session: int) -> None:
        changes = list(changes)
        if not changes:
            return
        failed = dict.fromkeys(self.unconfirmed)
        for change in changes:
            if change.state == "confirmed":
                self._unstored[change.name] = None
                failed.pop(change.name, None)
            else:
                failed[change.name] = None
        self.unconfirmed = tuple(failed)
        self.journal.note(kind, changes, client, undoable=session == self._session)

    def _before(self, name: str) -> float | None:
        value = self.held[name].value
        return None if value is None else gains.shown(name, value)

    def _after_command(self, name: str, value: float, outcome: WriteOutcome) -> Held17:
        if outcome == "timed_out":
            return gains.forgotten(self.held, [name])
        if outcome == "rejected":
            return gains.with_state(self.held, {name: None}, "rejected")
        on_the_wire = value if BY_NAME[name].is_integer else single(value)
        return {**self.held, name: replace(self.held[name], value=on_the_wire, state="confirmed")}

    async def _read(self, client: str | None, *, quiet: bool = True) -> Mapping[str, Json]:
        heard: asyncio.Future[Mapping[str, Json]] = asyncio.get_running_loop().create_future()

        def listen(frame: Frame, meant: Meaning) -> None:
            if frame.message.name == "autopilot_parameters" and not heard.done():
                heard.set_result(meant.values)

        with self._board.listening(listen):
            result = await self._commands.run("load_autopilot_parameters", client=client, quiet=quiet)
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
                    f"There is no parameter '{name}': GET /api/v1/parameters lists all.",
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
        self._was_known = False
        if not self._is_writing:
            self._replace(gains.after_read(self.held, meant.values))

    def _replace(self, held: Held17) -> None:
        """Take the new state and send the viewers what changed."""
        changed = {name: gains.gain_state(name, one) for name, one in held.items() if one != self.held[name]}
        self.held = held
        if changed:
            self._outlet.event(ParameterEvent(changed))


def _why_not(result: CommandOutcome | None) -> WriteOutcome:
    """The outcome where the read-back shows another value: refused, or the command never arrived."""
    return "timed_out" if result is None or result.state == "timed_out" else "rejected"
