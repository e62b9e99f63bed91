"""Flight plans as CSV: written for any program; read also as a Spanish spreadsheet writes it (`;`, decimal commas)."""

from __future__ import annotations

import codecs
import csv
import io
from collections.abc import Iterator, Mapping, Sequence
from itertools import islice
from typing import Final

from epf_gcs.codec.tables import Waypoint
from epf_gcs.formats.mission_file import (
    MAX_WAYPOINTS,
    FileFault,
    MissionFile,
    Note,
    Place,
    Point,
    is_ambiguous,
    number,
    place_params,
    settle,
)
from epf_gcs.formats.units import ft_from_m, kt_from_m_s

_COLUMNS: Final = ("latitude_deg", "longitude_deg", "altitude_ft", "speed_kt")
_METRIC: Final = {"altitude_m": ft_from_m, "speed_m_s": kt_from_m_s}
# No value of a kind is larger; what a thousand times as much exceeds is not taken for thousands.
_LARGEST: Final = {
    "latitude_deg": 90.0,
    "longitude_deg": 180.0,
    "altitude_ft": 60_000.0,
    "altitude_m": 20_000.0,
    "speed_kt": 1_000.0,
    "speed_m_s": 500.0,
}
_NEEDED: Final = ("latitude_deg", "longitude_deg")


def write_csv(waypoints: Sequence[Waypoint]) -> bytes:
    """A CSV with commas, decimal points and a header, as in RFC 4180."""
    text = io.StringIO()
    table = csv.writer(text)
    table.writerow(_COLUMNS)
    table.writerows([_written(getattr(waypoint, column), column) for column in _COLUMNS] for waypoint in waypoints)
    return text.getvalue().encode("ascii")


def _written(value: float, column: str) -> str:
    """With one decimal more where three of them could be taken for thousands."""
    text = repr(value)
    return f"{text}0" if is_ambiguous(text, _LARGEST[column]) else text


def read_csv(data: bytes) -> MissionFile:
    """The rows in order; columns by their names in the first line, in any order. Raises FileFault with the line.

    The separator is `,`, `;` or a tab; decimal commas are understood if the separator is not a comma.
    """
    rows = _rows(_text(data))
    header_line, header = next(rows, (1, []))
    names = [name.strip().lower() for name in header]
    missing = [name for name in _NEEDED if name not in names]
    if missing:
        raise FileFault(
            "mission_file_header",
            f"line {header_line} does not name the columns {', '.join(missing)}: the first line must be "
            f"{','.join(_COLUMNS)}",
            missing=", ".join(missing),
            line=header_line,
        )
    unknown = [name for name in names if name and name not in (*_COLUMNS, *_METRIC)]
    notes = [Note("columns_skipped", {"names": ", ".join(unknown)[:200]})] if unknown else []
    filled = ((line, cells) for line, cells in rows if any(cell.strip() for cell in cells))
    # Reading one more than a plan can hold is enough for `settle` to refuse the file.
    taken = islice(filled, MAX_WAYPOINTS + 1)
    points = [_point(dict(zip(names, cells, strict=False)), Place("line", line)) for line, cells in taken]
    return settle("csv", points, notes)


def _point(row: Mapping[str, str], place: Place) -> Point:
    return Point(
        place,
        _number(row, "latitude_deg", place),
        _number(row, "longitude_deg", place),
        _quantity(row, "altitude_ft", "altitude_m", place),
        _quantity(row, "speed_kt", "speed_m_s", place),
    )


def _quantity(row: Mapping[str, str], name: str, metric: str, place: Place) -> float | None:
    if row.get(name, "").strip():
        return _number(row, name, place)
    if row.get(metric, "").strip():
        return _METRIC[metric](_number(row, metric, place))
    return None


def _number(row: Mapping[str, str], name: str, place: Place) -> float:
    text = row.get(name, "").strip()
    if is_ambiguous(text, _LARGEST[name]):
        raise FileFault(
            "mission_file_which_number",
            f"{name} of {place} is {text!r}, which may be a thousand or one: write it without thousands mark, or with "
            "one decimal",
            field=name,
            value=text[:30],
            **place_params(place),
        )
    return number(text.replace(",", "."), name, place)


def _rows(text: str) -> Iterator[tuple[int, list[str]]]:
    """Line number and cells of each row. A spreadsheet's first line such as `sep=;` only sets the separator."""
    first = text.split("\n", 1)[0].strip()
    if first.lower().startswith("sep=") and len(first) == len("sep=") + 1:
        separator = first[-1]
    else:
        separator = next((letter for letter in ";\t" if letter in first), ",")
        first = ""
    table = csv.reader(io.StringIO(text), delimiter=separator)
    try:
        for cells in table:
            if not (first and table.line_num == 1):
                yield table.line_num, cells
    except csv.Error as error:
        raise FileFault(
            "mission_file_damaged",
            f"line {table.line_num} is no row of a table ({error})",
            format="csv",
            line=table.line_num,
        ) from error


def _text(data: bytes) -> str:
    """Decode UTF-8, UTF-16 or Windows-1252, which spreadsheets write. Raises FileFault if it is not text."""
    is_utf16 = data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    for encoding in ("utf-16",) if is_utf16 else ("utf-8-sig", "cp1252"):
        try:
            text = data.decode(encoding)
        except UnicodeDecodeError:
            continue
        if all(letter.isprintable() or letter in "\r\n\t\xa0" for letter in text):
            return text
    raise FileFault(
        "mission_file_unknown",
        "it is neither KML, GPX, CSV, a .plan of QGroundControl nor .waypoints of Mission Planner",
    )
