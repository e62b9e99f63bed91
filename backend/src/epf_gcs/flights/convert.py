"""Payloads in bulk -> columns, by the same steps, limits and readers as the live decoder's values."""

from __future__ import annotations

import math
import re
from functools import cache
from typing import Any, Final, NamedTuple

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from epf_gcs.codec.messages_gen import TELEMETRY_BY_NAME
from epf_gcs.codec.tables import Message, Value
from epf_gcs.codec.values import Step, steps
from epf_gcs.contract.own_topics import OWN_TYPE_WORDS
from epf_gcs.flights.bulk import Frames
from epf_gcs.recordings.log_table import LogTable
from epf_gcs.recordings.table_names import is_reserved

_NUMPY: Final = {"f": "<f4", "d": "<f8", "i": "<i4", "I": "<u4", "h": "<i2", "H": "<u2", "b": "i1", "B": "u1"}
_FORMAT: Final = re.compile(r"(\d*)([a-zA-Z])")
_ARROW: Final = {"number": pa.float64(), "integer": pa.int32(), "boolean": pa.bool_(), "text": pa.string()}

DESCRIPTION: Final = b"description"
"""Key of a table's metadata that says what its readers have to know."""
OWN: Final = b"own"
"""Key in a table's metadata: its topic is no built-in one, but of another program's log, or one that the board
described itself."""
T_NS: Final = pa.field("t_ns", pa.int64(), nullable=False, metadata={"unit": "ns"})


class Column(NamedTuple):
    """One column; `implausible`: how many of its nulls the board did not send on purpose."""

    values: pa.Array
    implausible: int


@cache
def layout(message: Message) -> np.dtype[Any]:
    """The payload of a generated message as a numpy structure; the name of each field is its slot."""
    kinds: list[str] = []
    for count, letter in _FORMAT.findall(message.struct.format.lstrip("<")):
        if letter == "x":
            kinds += [f"V{count}"] if int(count) else []
        else:
            kinds += [f"S{count or 1}"] if letter == "s" else [_NUMPY[letter]] * int(count or 1)
    made = np.dtype([(str(slot), kind) for slot, kind in enumerate(kinds)])
    if made.itemsize != message.size:
        raise ValueError(f"the layout of {message.name} is not the struct's")
    return made


@cache
def schema(message: Message) -> pa.Schema:
    """`t_ns` and the definition's names with their units."""
    fields = [pa.field(value.name, _kind(message, value), metadata={"unit": value.unit}) for value in message.values]
    is_own = message.id in OWN_TYPE_WORDS
    return pa.schema([T_NS, *fields], metadata={OWN: message.name} if is_own else None)


def table(message: Message, frames: Frames) -> tuple[pa.Table, dict[str, int]]:
    """The values of frames of one message, and how many of each name were implausible (only names that had any)."""
    columns = [pa.array(frames.t_ns)]
    implausible: dict[str, int] = {}
    payload = frames.payload.view(layout(message)) if message.size else None
    for step, value in zip(steps(message), message.values, strict=True):
        column = _column(step, value, payload[str(step.slot)], schema(message).field(step.name).type)  # type: ignore[index]
        columns.append(column.values)
        if column.implausible:
            implausible[step.name] = column.implausible
    return pa.Table.from_arrays(columns, schema=schema(message)), implausible


def log_rows(found: LogTable) -> pa.Table | None:
    """Rows of another program's log, numbers all; those that were made of it by a name of ours have our kinds.

    None for what a stranger's file gives a name of ours and is not as ours.
    """
    values = [pa.array(one, from_pandas=True) for one in found.columns]
    if not is_reserved(found.topic):
        fields = [pa.field(name, pa.float64(), metadata={"unit": unit}) for name, unit in found.units.items()]
        kept = pa.schema([T_NS, *fields], metadata={OWN: found.topic})
        return pa.Table.from_arrays([pa.array(found.t_ns), *values], schema=kept)
    message = TELEMETRY_BY_NAME.get(found.topic)
    if message is None or list(found.units) != [value.name for value in message.values]:
        return None
    kept = schema(message)
    try:
        rows = [one.cast(field.type) for one, field in zip(values, list(kept)[1:], strict=True)]
    except pa.ArrowInvalid:
        return None
    return pa.Table.from_arrays([pa.array(found.t_ns), *rows], schema=kept)


def _kind(message: Message, value: Value) -> pa.DataType:
    wire = layout(message)[str(value.slot)]
    if value.kind == "number" and wire == np.dtype("<f4"):
        return pa.float32()
    if value.kind == "integer" and wire == np.dtype("<u4"):
        return pa.int64()
    return _ARROW[value.kind]


def _column(step: Step, value: Value, raw: NDArray[Any], kind: pa.DataType) -> Column:
    if step.read is not None:
        read = _read(step, raw)
        column = pa.array(read, type=kind)
        return Column(column, column.null_count)
    good = (raw >= step.minimum) & (raw <= step.maximum)
    if good.all():
        return Column(pa.array(np.ascontiguousarray(raw), type=kind), 0)
    absent = np.zeros(len(raw), dtype=bool) if step.absent is None else raw == step.absent
    if step.absent is not None and math.isnan(step.absent):
        absent = np.isnan(raw)
    column = pa.array(np.ascontiguousarray(raw), type=kind, mask=~good)
    return Column(column, int(np.count_nonzero(~good & ~absent)))


def _read(step: Step, raw: NDArray[Any]) -> NDArray[Any]:
    """What the live reader makes of each wire value; each different value is read once."""
    read = step.read
    if read is None:
        raise ValueError(f"{step.name} needs no reading")
    if raw.dtype.itemsize == 1 and raw.dtype.kind == "i":
        meanings = np.array([read(number) for number in np.arange(256, dtype=np.uint8).view(np.int8).tolist()], object)
        return meanings[raw.view(np.uint8)]
    different, which = np.unique(raw, return_inverse=True)
    known = [_padded(one, raw.dtype) for one in different.tolist()]
    return np.array([read(one) for one in known], dtype=object)[which]


def _padded(one: Any, kind: np.dtype[Any]) -> Any:
    """Numpy drops the zeros at the end of a text; the wire has them."""
    return one.ljust(kind.itemsize, b"\0") if isinstance(one, bytes) else one
