"""Reads the table in which a board describes itself; a table that is known by its checksum is not read again."""

from __future__ import annotations

import asyncio
import zlib
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Final, NamedTuple

import orjson

from epf_gcs.codec.description import BLOCK_SIZE, BLOCKS_AT_ONCE, block_count
from epf_gcs.codec.frame import Frame
from epf_gcs.codec.values import Meaning, meaning
from epf_gcs.disk import KeptFile
from epf_gcs.errors import BoardError, GatewayError
from epf_gcs.flight.board.answers import answer_of
from epf_gcs.flight.board.commands import Commands
from epf_gcs.vehicle.board import Board

_TRIES: Final = 4
# A board whose line is busy with other frames sends a block each half second.
_SILENCE_S: Final = 0.6
_SLOW_LINE_BAUD: Final = 57600
_SLOW_LINE_FACTOR: Final = 5


class ReadTable(NamedTuple):
    """A table that is not `is_whole` ends before a block that the board did not send; where `is_sure`, its checksum
    holds."""

    table: bytes
    is_whole: bool
    is_sure: bool


class OwnTableReader:
    """Keeps the table that was read last in the file `path`; `report` is told where the disk refuses."""

    def __init__(self, board: Board, commands: Commands, path: Path, report: Callable[[GatewayError], None]) -> None:
        self._board = board
        self._commands = commands
        self._file = KeptFile(path, _decode, _encode)
        self._report = report
        self._kept: bytes | None = None

    async def read(self, on_progress: Callable[[int, int], None]) -> ReadTable:
        """What the board says about itself.

        `on_progress` is told how many blocks have come, and how many there are. Raises BoardError where the board does
        not describe itself, ConflictError and LinkError where it cannot be asked.
        """
        told = await answer_of(self._board, self._commands, "describe", "description")
        values = {} if told is None else meaning(told).values
        size, checksum = values.get("table_size"), values.get("table_crc32")
        if not isinstance(size, int) or not isinstance(checksum, int):
            raise BoardError(
                "parameters_not_read",
                "The board's own gains were not read because the board did not describe them: try again.",
                state="timed_out",
            )
        kept = await self._kept_table()
        if len(kept) == size and zlib.crc32(kept) == checksum:
            return ReadTable(kept, is_whole=True, is_sure=True)
        blocks = await self._blocks(block_count(size), on_progress)
        table = b"".join(_up_to_the_first_gap(blocks))[:size]
        is_sure = len(table) == size and zlib.crc32(table) == checksum
        if is_sure:
            await self._keep(table)
        return ReadTable(table, len(table) == size, is_sure)

    async def _blocks(self, count: int, on_progress: Callable[[int, int], None]) -> list[bytes | None]:
        """All blocks, None for those that did not come; lost ones are asked for again, after the others.

        A board that answers none of a few questions in a row is asked no more.
        """
        blocks, unanswered = _Blocks(count), 0
        on_progress(0, count)
        with self._board.listening(blocks.take):
            for _ in range(_TRIES):
                for first, number in _runs(blocks.missing()):
                    came = blocks.came
                    await self._ask(blocks, first, number)
                    on_progress(count - len(blocks.missing()), count)
                    unanswered = 0 if blocks.came > came else unanswered + 1
                    if unanswered == _TRIES:
                        return blocks.found
        return blocks.found

    async def _ask(self, blocks: _Blocks, first: int, number: int) -> None:
        """Ask for a few blocks, and wait until the last of them is there, or none comes for a while."""
        last = blocks.awaited(first + number - 1)
        asking = asyncio.ensure_future(self._commands.run("describe_blocks", (first, number), quiet=True))
        try:
            # The blocks are proof enough: an acknowledgement that the line lost is not waited for.
            await asyncio.wait((asking, last), return_when=asyncio.FIRST_COMPLETED)
            if last.done() or asking.result().state == "rejected":
                return
            came = -1
            while came != blocks.came and not last.done():
                came = blocks.came
                await asyncio.wait((last,), timeout=self._silence_s())
        finally:
            asking.cancel()
            with suppress(asyncio.CancelledError):
                await asking

    def _silence_s(self) -> float:
        return _SILENCE_S * (_SLOW_LINE_FACTOR if self._board.baud < _SLOW_LINE_BAUD else 1)

    async def _kept_table(self) -> bytes:
        if self._kept is None:
            try:
                found = await asyncio.to_thread(self._file.read_or_set_aside, lambda _: None)
            except OSError:
                found = None  # the table is read from the board, and a disk that refuses is told when it is kept
            self._kept = found or b""
        return self._kept

    async def _keep(self, table: bytes) -> None:
        self._kept = table
        try:
            await asyncio.to_thread(self._file.write, table)
        except OSError as error:
            self._report(
                GatewayError(
                    "memory_not_written",
                    f"The board's table could not be kept in {self._file.path} ({error.strerror or error}): "
                    "free the disk or correct its permissions, or it is read again at the next start.",
                    path=str(self._file.path),
                )
            )


class _Blocks:
    """The blocks that have come, in whatever order."""

    def __init__(self, count: int) -> None:
        self.found: list[bytes | None] = [None] * count
        self.came = 0
        self._last_number = -1
        self._last: asyncio.Future[None] | None = None

    def missing(self) -> list[int]:
        return [number for number, block in enumerate(self.found) if block is None]

    def awaited(self, last_number: int) -> asyncio.Future[None]:
        """Done as soon as this one comes: the board sends them in order, so those before it are there or lost."""
        self._last_number = last_number
        self._last = asyncio.get_running_loop().create_future()
        return self._last

    def take(self, frame: Frame, meant: Meaning) -> None:
        number = meant.values.get("block")
        if frame.message.name != "description_block" or not isinstance(number, int) or number >= len(self.found):
            return
        self.found[number] = frame.payload[-BLOCK_SIZE:]
        self.came += 1
        if number == self._last_number and self._last is not None and not self._last.done():
            self._last.set_result(None)


def _runs(numbers: list[int]) -> Iterator[tuple[int, int]]:
    """First and length of the runs of neighbours among these ascending numbers, each no longer than one question."""
    start = 0
    for at in range(1, len(numbers) + 1):
        is_end = at == len(numbers) or numbers[at] != numbers[at - 1] + 1 or at - start == BLOCKS_AT_ONCE
        if is_end:
            yield numbers[start], at - start
            start = at


def _up_to_the_first_gap(blocks: list[bytes | None]) -> Iterator[bytes]:
    for block in blocks:
        if block is None:
            return
        yield block


def _encode(table: bytes) -> bytes:
    return orjson.dumps({"table": table.hex()}, option=orjson.OPT_INDENT_2)


def _decode(text: bytes) -> bytes:
    return bytes.fromhex(orjson.loads(text)["table"])
