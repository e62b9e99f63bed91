"""Logs of what speaks MAVLink, read by pymavlink: a board's DataFlash log and a ground station's telemetry log."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any, Final, NamedTuple

from epf_gcs.flights.logs.log import EARLIEST_S, Log, Piece, Rows, flattened, guarded

DATAFLASH: Final = b"\xa3\x95"
_STARTS: Final = (0xFD, 0xFE)
_STAMP_BYTES: Final = 8
_LATEST_S: Final = 4_102_444_800  # the year 2100
# What describes the log itself, and words.
_NO_TOPICS: Final = frozenset({"FMT", "FMTU", "UNIT", "MULT", "PARM", "MSG", "FILE", "BAD_DATA"})
_NO_FIELDS: Final = frozenset({"TimeUS", "TimeMS", "mavpackettype"})
_GROUND_STATION: Final = 255


def is_tlog(head: bytes) -> bool:
    """Whether a file that begins so has a time of this century and then a MAVLink frame."""
    if len(head) <= _STAMP_BYTES or head[_STAMP_BYTES] not in _STARTS:
        return False
    return EARLIEST_S < int.from_bytes(head[:_STAMP_BYTES], "big") / 1e6 < _LATEST_S


def read_dataflash(path: Path) -> Log:
    """Raises InvalidInputError."""
    from pymavlink.DFReader import DFReader_binary  # noqa: PLC0415 - an extra of the package

    reader = guarded(lambda: DFReader_binary(str(path)))
    first = guarded(reader.recv_msg)
    guarded(reader.rewind)
    is_dated = first is not None and getattr(first, "_timestamp", 0.0) > EARLIEST_S
    said: list[str] = []
    return Log("dataflash", _pieces(reader, _dataflash_row, said), is_dated, said)


def read_tlog(path: Path) -> Log:
    """Raises InvalidInputError."""
    os.environ["MAVLINK20"] = "1"
    from pymavlink.mavutil import mavlogfile  # noqa: PLC0415 - an extra of the package

    said: list[str] = []
    return Log("tlog", _pieces(guarded(lambda: mavlogfile(str(path))), _Systems().row, said), said=said)


class _Row(NamedTuple):
    topic: str
    t_ns: int
    values: dict[str, float]
    units: dict[str, str]


def _pieces(reader: Any, row_of: Callable[[Any], _Row], said: list[str]) -> Iterator[Piece]:
    rows = Rows()
    damaged = 0
    try:
        while (message := guarded(reader.recv_msg)) is not None:
            name = message.get_type()
            if name in _NO_TOPICS or name.startswith("UNKNOWN_"):
                damaged += name == "BAD_DATA"
                continue
            row = guarded(partial(row_of, message))
            if not 0 <= row.t_ns < _LATEST_S * 1_000_000_000:
                damaged += 1
                continue
            table = rows.add(*row)
            if table is not None:
                yield Piece(table, reader.percent / 100.0)
    finally:
        _close(reader)
    for table in rows.rest():
        yield Piece(table, 1.0)
    if damaged:
        said.append(f"{damaged} damaged pieces of this log are left out.")
    if rows.left_out:
        said.append(f"{rows.left_out} messages are left out: the log has more kinds of them than are taken.")


def _close(reader: Any) -> None:
    try:
        reader.close()
    except BufferError:
        # Something of the file is still looked at; its memory goes with this process.
        reader.filehandle.close()


def _row(message: Any, topic: str, units: dict[str, str]) -> _Row:
    given = message.to_dict()
    values = flattened({one: value for one, value in given.items() if one not in _NO_FIELDS})
    # The library's clocks count microseconds; more digits would be those of its float.
    return _Row(topic, round(message._timestamp * 1e6) * 1000, values, units)  # noqa: SLF001 - it has no other name


def _dataflash_row(message: Any) -> _Row:
    instance = message.fmt.instance_field
    name: str = message.get_type()
    topic = name if instance is None else f"{name}_{getattr(message, instance)}"
    return _row(message, topic, {one: message.fmt.get_unit(one) for one in message.fmt.columns})


class _Systems:
    """The first that is no ground station is the aircraft; topics of others have their number."""

    def __init__(self) -> None:
        self._aircraft: int | None = None

    def row(self, message: Any) -> _Row:
        system = message.get_srcSystem()
        if self._aircraft is None and system != _GROUND_STATION:
            self._aircraft = system
        name: str = message.get_type()
        topic = name if system == self._aircraft else f"{name}_of_{system}"
        return _row(message, topic, dict(message.fieldunits_by_name))
