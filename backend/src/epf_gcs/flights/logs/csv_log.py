"""A table of numbers as text, with a column of times: CSV with commas, semicolons or tabs."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Final

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.csv as pa_csv

from epf_gcs.errors import InvalidInputError
from epf_gcs.flights.logs.log import Log, Piece, cut, unreadable
from epf_gcs.flights.logs.naming import field_names
from epf_gcs.recordings.log_table import MOST_FIELDS

_TOPIC: Final = "csv"
_DELIMITERS: Final = (";", "\t", ",")
_UNIT: Final = re.compile(r"^(?P<name>.*?)\s*[\[(](?P<unit>[^\])]{1,24})[\])]\s*$")
_TIME: Final = re.compile(r"(?i)^(utc|date_?time|date|time|timestamp|log_?time|t)(_?(utc|unix|s|ms|us|ns|usec|sec))?$")
_COMMA: Final = re.compile(rb"^-?\d+,\d+$")
# Nanoseconds in one of each, by how the column says it and by how large its numbers are (Unix time).
_SCALES: Final = {"s": 1e9, "sec": 1e9, "ms": 1e6, "us": 1e3, "usec": 1e3, "ns": 1.0}
_UNIX: Final = ((1e17, 1.0), (1e14, 1e3), (1e11, 1e6), (3e8, 1e9))
_LONGEST_HEAD: Final = 1 << 16
_NO_TIME: Final = -(1 << 63)


def looks_like(head: bytes) -> bool:
    """Whether a file that begins so is text with a line of names."""
    line = head.split(b"\n", 1)[0]
    if not line.strip() or b"\0" in head:
        return False
    try:
        text = line.decode("utf-8-sig")
    except UnicodeDecodeError:
        return False
    return any(one in text for one in _DELIMITERS) and any(_time_of(name) is not None for name in _names(text))


def read(path: Path) -> Log:
    """Raises InvalidInputError."""
    with path.open("rb") as file:
        head = file.read(_LONGEST_HEAD)
    lines = head.split(b"\n")
    delimiter = _delimiter(lines[0].decode("utf-8-sig", "replace"))
    cells = [cell.strip() for line in lines[1:50] for cell in line.split(delimiter.encode())]
    has_commas = delimiter != "," and any(_COMMA.match(cell) for cell in cells)
    skipped: list[pa_csv.InvalidRow] = []

    def skip(row: pa_csv.InvalidRow) -> str:
        skipped.append(row)
        return "skip"

    try:
        table = pa_csv.read_csv(
            path,
            parse_options=pa_csv.ParseOptions(delimiter=delimiter, invalid_row_handler=skip),
            convert_options=pa_csv.ConvertOptions(decimal_point="," if has_commas else "."),
        )
    except (pa.ArrowException, ValueError, OSError) as error:
        raise unreadable(error) from error
    units = [_time_of(name) for name in table.column_names]
    time = next((place for place, unit in enumerate(units) if unit is not None), None)
    if time is None:
        raise _no_time()
    t_ns, is_dated = _times(table.column(time), units[time] or "")
    said = [f"Rows with too many or too few cells are left out: {len(skipped)}."] if skipped else []
    left_out = [one.name for place, one in enumerate(table.schema) if place != time and not _is_number(one.type)]
    if left_out:
        said.append(f"Columns that are no numbers are left out: {', '.join(left_out[:20])}.")
    return Log("csv", _pieces(table, time, t_ns), is_dated, said)


def _pieces(table: pa.Table, time: int, t_ns: np.ndarray) -> Iterator[Piece]:
    names = field_names()
    units: dict[str, str] = {}
    columns: list[np.ndarray] = []
    known = t_ns != _NO_TIME
    for place, one in enumerate(table.schema):
        if place == time or not _is_number(one.type) or len(columns) >= MOST_FIELDS:
            continue
        name, unit = _name_and_unit(one.name)
        units[names.new(name)] = unit
        values = table.column(place).cast(pa.float64()).to_numpy()
        columns.append(values[known])
    if columns:
        for part in cut(_TOPIC, units, t_ns[known], columns):
            yield Piece(part, 0.5)


def _times(column: pa.ChunkedArray, unit: str) -> tuple[np.ndarray, bool]:
    """The times of the rows in nanoseconds, `_NO_TIME` for an empty cell; and whether they count from 1970."""
    if pa.types.is_timestamp(column.type):
        unix = pc.fill_null(column.cast(pa.timestamp("ns", tz=column.type.tz)).cast(pa.int64()), _NO_TIME)
        return unix.to_numpy(), True
    if not _is_number(column.type):
        raise _no_time()
    values = column.cast(pa.float64()).to_numpy()
    known = np.isfinite(values)
    largest = float(np.abs(values[known]).max()) if known.any() else 0.0
    for least, scale in _UNIX:
        if largest >= least:
            return _as_ns(values, known, scale), True
    return _as_ns(values, known, _SCALES.get(unit, 1e9)), False


def _no_time() -> InvalidInputError:
    return InvalidInputError("log_no_time", "This table has no column of times: name one 'time'.")


def _as_ns(values: np.ndarray, known: np.ndarray, scale: float) -> np.ndarray:
    # Whole seconds and their parts apart: nanoseconds of this century are no whole numbers of a float64.
    whole = np.floor(np.where(known, values, 0.0))
    parts = np.round((np.where(known, values, 0.0) - whole) * scale)
    found: np.ndarray = whole.astype(np.int64) * int(scale) + parts.astype(np.int64)
    return np.where(known, found, _NO_TIME)


def _is_number(kind: pa.DataType) -> bool:
    return bool(pa.types.is_integer(kind) or pa.types.is_floating(kind) or pa.types.is_boolean(kind))


def _delimiter(line: str) -> str:
    return max(_DELIMITERS, key=line.count)


def _names(line: str) -> list[str]:
    return [name.strip().strip('"') for name in line.strip().split(_delimiter(line))]


def _name_and_unit(name: str) -> tuple[str, str]:
    found = _UNIT.match(name.strip())
    return (found["name"].strip(), found["unit"].strip()) if found else (name.strip(), "1")


def _time_of(name: str) -> str | None:
    """The unit that a column of times says, "" if none; None where it is no such column."""
    plain, unit = _name_and_unit(name)
    found = _TIME.match(plain.replace(" ", "_"))
    return None if found is None else (unit if unit != "1" else found[3] or "").lower()
