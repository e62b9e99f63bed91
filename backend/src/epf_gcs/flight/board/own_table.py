"""Reads the table in which a board describes its own gains; a table that is known by its checksum is not read again."""

from __future__ import annotations

import asyncio
import zlib
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Final

import orjson

from epf_gcs.codec.messages_gen import TELEMETRY_BY_NAME
from epf_gcs.codec.values import meaning
from epf_gcs.contract.own_gains import MOST_ROWS
from epf_gcs.disk import KeptFile
from epf_gcs.errors import BoardError, GatewayError
from epf_gcs.flight.board.answers import answer_of
from epf_gcs.flight.board.commands import Commands
from epf_gcs.vehicle.board import Board

# A progress that people see move, in a few events.
_TOLD_EVERY: Final = 8
_ROW_SIZE: Final = TELEMETRY_BY_NAME["description_row"].size


class OwnTableReader:
    """Keeps the rows that were read last in the file `path`; `report` is told where the disk refuses."""

    def __init__(self, board: Board, commands: Commands, path: Path, report: Callable[[GatewayError], None]) -> None:
        self._board = board
        self._commands = commands
        self._file = KeptFile(path, _decode, _encode)
        self._report = report
        self._kept: tuple[bytes, ...] | None = None

    async def read(self, on_progress: Callable[[int, int], None]) -> list[bytes | None]:
        """The payloads of all rows, None for those that the board did not send; BoardError where it does not describe.

        `on_progress` is told how many rows were asked for, and how many there are.
        """
        told = await answer_of(self._board, self._commands, "describe", "description")
        values = {} if told is None else meaning(told).values
        count, checksum = values.get("row_count"), values.get("table_crc32")
        if not isinstance(count, int) or not isinstance(checksum, int):
            raise BoardError(
                "parameters_not_read",
                "The board's own gains were not read because the board did not describe them: try again.",
                state="timed_out",
            )
        kept = await self._kept_rows()
        if len(kept) == count and _checksum(kept) == checksum:
            return list(kept)
        rows: list[bytes | None] = []
        for row in range(min(count, MOST_ROWS)):
            if row % _TOLD_EVERY == 0:
                on_progress(row, count)
            frame = await answer_of(self._board, self._commands, "describe_item", "description_row", row)
            rows.append(None if frame is None else frame.payload)
        whole = tuple(row for row in rows if row is not None)
        if len(whole) == count and _checksum(whole) == checksum:
            await self._keep(whole)
        return rows

    async def _kept_rows(self) -> tuple[bytes, ...]:
        if self._kept is None:
            try:
                found = await asyncio.to_thread(self._file.read_or_set_aside, lambda _: None)
            except OSError:
                found = None  # the table is read from the board, and a disk that refuses is told when it is kept
            self._kept = found or ()
        return self._kept

    async def _keep(self, rows: tuple[bytes, ...]) -> None:
        self._kept = rows
        try:
            await asyncio.to_thread(self._file.write, rows)
        except OSError as error:
            self._report(
                GatewayError(
                    "memory_not_written",
                    f"The board's table could not be kept in {self._file.path} ({error.strerror or error}): "
                    "free the disk or correct its permissions, or it is read again at the next start.",
                    path=str(self._file.path),
                )
            )


def _checksum(rows: Sequence[bytes]) -> int:
    return zlib.crc32(b"".join(rows))


def _encode(rows: tuple[bytes, ...]) -> bytes:
    return orjson.dumps({"rows": [row.hex() for row in rows]}, option=orjson.OPT_INDENT_2)


def _decode(text: bytes) -> tuple[bytes, ...]:
    rows = tuple(bytes.fromhex(row) for row in orjson.loads(text)["rows"])
    if any(len(row) != _ROW_SIZE for row in rows):
        raise ValueError("a row of another size")
    return rows
