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
    FilePlan,
    Note,
    Place,
    Point,
    number,
    place_params,
)
from epf_gcs.formats.plan_altitudes import is_admissible
from epf_gcs.formats.sheet_number import plain_decimal, readings
from epf_gcs.units import ft_from_m, kt_from_mps

_COLUMNS: Final = ("latitude_deg", "longitude_deg", "altitude_ft", "speed_kt")
_METRIC: Final = {"altitude_m": ("altitude_ft", ft_from_m), "speed_m_s": ("speed_kt", kt_from_mps)}
_NEEDED: Final = ("latitude_deg", "longitude_deg")


def write_csv(waypoints: Sequence[Waypoint]) -> bytes:
    """A CSV with commas, decimal points and a header, as in RFC 4180; no number in it has two readings."""
    text = io.StringIO()
    table = csv.writer(text)
    table.writerow(_COLUMNS)
    table.writerows([plain_decimal(str(getattr(waypoint, column))) for column in _COLUMNS] for waypoint in waypoints)
    return text.getvalue().encode("ascii")


def read_csv(data: bytes) -> FilePlan:
    """The rows in order; columns by their names in the first line, in any order. Raises FileFault with the line.

    The separator is `,`, `;` or a tab; decimal commas are understood if the separator is not a comma. A number that can
    be thousands or a decimal is taken as the one that the board accepts, and refused if it accepts both.
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
    used = {*_COLUMNS, *(metric for metric, (name, _) in _METRIC.items() if name not in names)}
    unknown = [name for name in names if name and name not in used]
    notes = [Note("columns_skipped", {"names": ", ".join(unknown)[:200]})] if unknown else []
    filled = ((line, cells) for line, cells in rows if any(cell.strip() for cell in cells))
    # Reading one more than a plan can hold is enough for `settle` to refuse the file.
    taken = islice(filled, MAX_WAYPOINTS + 1)
    points = [_point(_row(names, cells, Place("line", line)), Place("line", line)) for line, cells in taken]
    return FilePlan("csv", points, notes)


def _row(names: Sequence[str], cells: Sequence[str], place: Place) -> dict[str, str]:
    """The cells by their columns. Raises FileFault if there are more of them, as with decimal commas between commas."""
    if any(cell.strip() for cell in cells[len(names) :]):
        raise FileFault(
            "mission_file_cells",
            f"{place} has {len(cells)} values and the first line names {len(names)} columns",
            count=len(cells),
            columns=len(names),
            **place_params(place),
        )
    return dict(zip(names, cells, strict=False))


def _point(row: Mapping[str, str], place: Place) -> Point:
    return Point(
        place,
        _number(row, "latitude_deg", "latitude_deg", place),
        _number(row, "longitude_deg", "longitude_deg", place),
        _quantity(row, "altitude_ft", "altitude_m", place),
        _quantity(row, "speed_kt", "speed_m_s", place),
    )


def _quantity(row: Mapping[str, str], name: str, metric: str, place: Place) -> float | None:
    column = name if name in row else metric
    return _number(row, column, name, place) if row.get(column, "").strip() else None


def _number(row: Mapping[str, str], column: str, field: str, place: Place) -> float:
    """The number in the column, as the field of a waypoint."""
    text = row.get(column, "").strip()
    _, convert = _METRIC.get(column, (field, float))
    texts = readings(text)
    values = [convert(number(one, column, place)) for one in texts]
    admissible = [value for value in values if is_admissible(field, value)]
    if len(admissible) > 1:
        thousand, decimal = texts
        raise FileFault(
            "mission_file_which_number",
            f"{column} of {place} is {text!r}, which can be {thousand} or {decimal}",
            field=column,
            value=text,
            thousand=thousand,
            decimal=decimal,
            **place_params(place),
        )
    return admissible[0] if admissible else values[-1]


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
