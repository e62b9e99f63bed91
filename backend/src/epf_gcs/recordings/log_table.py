"""Some rows of one topic of another program's log, as the payload of a message.

The payload is the length of its head (u32), the head as JSON {"topic", "rows", "fields": [[name, unit], ...]}, the
times (int64, Unix ns), then each field's values (float64, NaN: none); all little-endian.
"""

from __future__ import annotations

import re
from struct import Struct
from typing import Final, NamedTuple

import msgspec
import numpy as np
from numpy.typing import NDArray

MOST_FIELDS: Final = 256
MOST_ROWS: Final = 4096
"""In one payload."""
NAME: Final = re.compile(r"[A-Za-z0-9_]{1,64}")
LONGEST_UNIT: Final = 24
T_NS: Final = "t_ns"
_LENGTH: Final = Struct("<I")
_BYTES: Final = 8


class LogTable(NamedTuple):
    """n rows. `units`: each field's, in the order of `columns`; "1" where a field has none, or the log does not say it.

    t_ns: int64, (n,), Unix ns. columns: float64, each (n,); NaN where there was no value.
    """

    topic: str
    units: dict[str, str]
    t_ns: NDArray[np.int64]
    columns: list[NDArray[np.float64]]


class _Head(msgspec.Struct):
    topic: str
    rows: int
    fields: list[tuple[str, str]]


def packed(table: LogTable) -> bytes:
    """The payload."""
    head = msgspec.json.encode(_Head(table.topic, len(table.t_ns), list(table.units.items())))
    times = np.ascontiguousarray(table.t_ns, "<i8").tobytes()
    return b"".join(
        (_LENGTH.pack(len(head)), head, times, *(np.ascontiguousarray(one, "<f8").tobytes() for one in table.columns))
    )


def unpacked(payload: bytes) -> LogTable | None:
    """What it holds; None if it is no such payload, which a stranger's file may have in its place."""
    if len(payload) < _LENGTH.size:
        return None
    body = _LENGTH.size + _LENGTH.unpack_from(payload)[0]
    try:
        head = msgspec.json.decode(payload[_LENGTH.size : body], type=_Head)
    except msgspec.DecodeError:
        return None
    if not _is_usable(head) or len(payload) - body != _BYTES * head.rows * (1 + len(head.fields)):
        return None
    t_ns = np.frombuffer(payload, "<i8", head.rows, body)
    columns = np.frombuffer(payload, "<f8", head.rows * len(head.fields), body + _BYTES * head.rows)
    return LogTable(head.topic, dict(head.fields), t_ns, list(columns.reshape(len(head.fields), head.rows)))


def _is_usable(head: _Head) -> bool:
    names = [name for name, _ in head.fields]
    return (
        0 < head.rows <= MOST_ROWS
        and 0 < len(names) <= MOST_FIELDS
        and len({name.lower() for name in names} | {T_NS}) == len(names) + 1
        and all(NAME.fullmatch(name) for name in (head.topic, *names))
        and all(len(unit) <= LONGEST_UNIT and unit.isprintable() for _, unit in head.fields)
    )
