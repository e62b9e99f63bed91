"""What the board describes itself: its table, the values of its gains, read and written with read-back; its topics."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from dataclasses import replace
from typing import Any, Final

from epf_gcs.codec.description import rows_of
from epf_gcs.codec.frame import Frame
from epf_gcs.codec.values import Json, Meaning, meaning
from epf_gcs.contract.answers import CommandOutcome, WriteOutcome
from epf_gcs.contract.events import OwnGainsEvent
from epf_gcs.contract.own_gains import (
    MOST_ROWS,
    LeftOutRow,
    OwnGainDefinition,
    OwnGains,
    OwnGainState,
    OwnGainTable,
)
from epf_gcs.errors import BoardError, ConflictError, InvalidInputError
from epf_gcs.flight.board.answers import answer_of
from epf_gcs.flight.board.commands import Commands
from epf_gcs.flight.board.own_table import OwnTableReader, ReadTable
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.outside import Clock, Outlet
from epf_gcs.vehicle.own_gains import after_read, as_held, unknown_values, usable_rows, value_fault
from epf_gcs.vehicle.own_topics import known_topics, own_messages, usable_topics

_TRIES: Final = 3


class OwnGainValues:
    """Holds the table and the values that the board reported last, never values that were only requested."""

    def __init__(self, board: Board, commands: Commands, outlet: Outlet, clock: Clock, reader: OwnTableReader) -> None:
        self._board = board
        self._commands = commands
        self._outlet = outlet
        self._clock = clock
        self._reader = reader
        self._reading = asyncio.Lock()
        self._session = 0
        self.known = OwnGains()
        board.listen("own_gain", self._on_frame)

    def __contains__(self, name: object) -> bool:
        return name in self.known.values

    def forget(self) -> None:
        """The board is gone, was restarted, or opened: its values are unknown until they are read."""
        self._session += 1
        describes = self._board.capabilities().get("describes_itself") is True
        if self._board.is_open and not describes:
            self._tell_table(OwnGainTable())
        elif describes or self.known.table.state != "none":
            self._tell_unread()

    async def read(self) -> None:
        """Read the table unless its checksum is known, then every value. Nothing if the board does not describe itself.

        Raises BoardError where it does not answer, ConflictError and LinkError where the line is gone.
        """
        async with self._reading:
            if self.known.table.state == "none":
                return
            session = self._session
            if self.known.table.state == "unknown":
                try:
                    read = await self._reader.read(self._progress)
                except BaseException:
                    if session == self._session:
                        self._tell_unread()
                    raise
                if session != self._session:
                    return
                self._take_rows(read)
            await self._switch_topics_on()
            for gain in self.known.table.gains:
                await answer_of(self._board, self._commands, "own_gain_get", "own_gain", gain.row)
                if session != self._session:
                    return

    def mark_loaded(self) -> None:
        """The operator loaded all gains: changes are counted from the present values."""
        self._tell_values({name: replace(one, loaded=one.value) for name, one in self.known.values.items()})

    def check(self, name: str, value: float) -> None:
        """Raise InvalidInputError where this gain cannot have this value, ConflictError while its row is not sure."""
        gain = self._sure_gain(name)
        fault = value_fault(gain, value)
        if fault is not None:
            raise InvalidInputError(
                "parameter_out_of_range",
                fault,
                field=name,
                value=value,
                minimum=gain.minimum,
                maximum=gain.maximum,
            )

    async def value_before(self, name: str) -> float | None:
        """The board's value, for the journal and undo; asked for if it is not known."""
        gain = self._sure_gain(name)
        if self.known.values[name].value is None:
            await answer_of(self._board, self._commands, "own_gain_get", "own_gain", gain.row)
        return self.known.values[name].value

    async def set(self, name: str, value: float, client: str | None) -> WriteOutcome:
        """Write one that was checked, and read it back; tells the outcome.

        Raises ConflictError if it was not sent, LinkError and BoardError if nobody knows what became of it.
        """
        gain, before, session = self._sure_gain(name), self.known.values[name], self._session
        self._change(name, state="pending")
        try:
            result, found = await self._write(gain, value, client)
        except BaseException as error:
            if isinstance(error, ConflictError):
                self._tell_values({name: before})
            else:
                self._change(name, value=None, state="unknown")
            raise
        if session != self._session:
            found = None  # what was read back is of a board that has been restarted
        outcome: WriteOutcome = (
            "confirmed"
            if found == as_held(value)
            else "timed_out"
            if found is None or result.state == "timed_out"
            else "rejected"
        )
        if found is None:
            self._change(name, value=None, state="unknown")
        else:
            self._change(name, state="confirmed" if outcome == "confirmed" else "rejected")
        reason = result.reason or "not_taken" if outcome == "rejected" else None
        self._commands.tell_outcome(
            "own_gain_set",
            (gain.row, as_held(value)),
            client,
            CommandOutcome(outcome, "read_back", result.ms, reason),
        )
        if found is None:
            raise BoardError(
                "parameters_not_read",
                f"Nobody knows whether the board took '{name}' because it did not send it back: load it.",
                state=result.state,
            )
        return outcome

    async def _write(
        self, gain: OwnGainDefinition, value: float, client: str | None
    ) -> tuple[CommandOutcome, float | None]:
        """What became of the command, and the value that was read back after it, None if none came."""
        heard: list[float | None] = []

        def listen(frame: Frame, meant: Meaning) -> None:
            if frame.message.name == "own_gain" and meant.values["row"] == gain.row:
                heard.append(_number(meant.values["value"]))

        with self._board.listening(listen):
            result = await self._commands.run("own_gain_set", (gain.row, value), client=client, quiet=True)
        if not heard:
            # The board sends the value before the acknowledgement: it was lost, or nothing acknowledges.
            frame = await answer_of(self._board, self._commands, "own_gain_get", "own_gain", gain.row)
            heard = [] if frame is None else [_number(meaning(frame).values["value"])]
        found = heard[-1] if heard else None
        return result, None if found is None else as_held(found)

    def _take_rows(self, read: ReadTable) -> None:
        rows = rows_of(read.table)
        gains, faulty_gains = usable_rows(rows, is_whole=read.is_whole)
        topics, faulty_topics = usable_topics(rows, is_whole=read.is_whole)
        if not read.is_sure:
            # A gain is proved by reading it back; a topic that is laid out otherwise would show false values.
            faulty_topics = (*faulty_topics, *(LeftOutRow(topic.row, topic.name, "checksum") for topic in topics))
            topics = ()
        left_out = sorted((*faulty_gains, *faulty_topics), key=lambda one: one.row)
        self._tell_table(OwnGainTable("known", 0, 0, gains, topics, tuple(left_out[:MOST_ROWS])))

    async def _switch_topics_on(self) -> None:
        """The board sends its own topics from now on. A board that does not say so is asked again, as for a row."""
        for _ in range(_TRIES if self.known.table.topics else 0):
            if (await self._commands.run("own_topics", (1,), quiet=True)).done:
                break

    def _progress(self, read: int, count: int) -> None:
        self._tell_table(replace(self.known.table, state="reading", blocks_read=read, block_count=count))

    def _sure_gain(self, name: str) -> OwnGainDefinition:
        """Raises ConflictError while the board may have another table."""
        if self.known.table.state != "known":
            raise ConflictError(
                "own_gains_not_read",
                f"'{name}' was not written because the board's table of its own gains is not read yet: "
                "wait, or load the gains.",
                field=name,
            )
        return next(gain for gain in self.known.table.gains if gain.name == name)

    def _on_frame(self, _: Frame, meant: Meaning) -> None:
        row, table = meant.values["row"], self.known.table
        gain = next((gain for gain in table.gains if gain.row == row), None)
        if gain is not None and table.state == "known":
            held = self.known.values[gain.name]
            self._tell_values({gain.name: after_read(held, meant.values["value"], self._clock.now_s())})

    def _change(self, name: str, **changes: Any) -> None:
        if name in self:
            self._tell_values({name: replace(self.known.values[name], **changes)})

    def _tell_unread(self) -> None:
        self._tell_table(replace(self.known.table, state="unknown", blocks_read=0, block_count=0))

    def _tell_table(self, table: OwnGainTable) -> None:
        """Take the new table and send it to the viewers; no value is known after it."""
        values = unknown_values(table.gains)
        self._board.learn(own_messages(known_topics(table)))
        if OwnGains(table, values) != self.known:
            self.known = OwnGains(table, values)
            self._outlet.event(OwnGainsEvent(table, values))

    def _tell_values(self, news: Mapping[str, OwnGainState]) -> None:
        changed = {name: one for name, one in news.items() if name in self and one != self.known.values[name]}
        if changed:
            self.known = replace(self.known, values={**self.known.values, **changed})
            self._outlet.event(OwnGainsEvent(None, changed))


def _number(value: Json) -> float | None:
    return float(value) if isinstance(value, int | float) else None
