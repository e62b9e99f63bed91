"""A table of campaigns: the same conditions flown by each law, a row for each, held against what it must show.

flights = 20
seed = 1
laws = ["bearing", "line"]
[[rows]]
name = "Gando, 25 kt"
route = "gando"
fixed = { wind_kt = 25 }
drawn = { wind_from_deg = { uniform = [0, 360] } }
must = { leg_m = 6, near_m = 12 }
"""

from __future__ import annotations

import math
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from epf_gcs.lab import campaign as campaigns
from epf_gcs.lab.campaign import Campaign
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.laws import LAWS
from epf_gcs.lab.rows import Row

_KEYS: Final = {"flights", "seed", "laws", "rows"}
_ROW_KEYS: Final = {"name", "route", "flights", "fixed", "drawn", "must"}


@dataclass(frozen=True, slots=True)
class Figure:
    """A column of the table: of all flights together, the root of the mean square or the largest."""

    name: str
    column: str
    title: str
    is_largest: bool = False

    def of(self, rows: Sequence[Row]) -> float:
        """NaN of nothing."""
        values = [float(row[self.column]) for row in rows if row[self.column] is not None]
        if not values:
            return math.nan
        return max(values) if self.is_largest else math.sqrt(sum(value**2 for value in values) / len(values))


FIGURES: Final = (
    Figure("leg_m", "leg_rms_m", "leg m"),
    Figure("leg_largest_m", "leg_largest_m", "largest", is_largest=True),
    Figure("near_m", "near_rms_m", "near m"),
    Figure("altitude_ft", "altitude_rms_ft", "altitude ft"),
    Figure("altitude_largest_ft", "altitude_largest_ft", "largest", is_largest=True),
    Figure("speed_kt", "speed_rms_kt", "speed kt"),
)


@dataclass(frozen=True, slots=True)
class TableRow:
    """One campaign of a table. `must`: limits by the names of `FIGURES`, for every law but the deployed one."""

    name: str
    law: str
    campaign: Campaign
    must: Mapping[str, float]

    def folder(self, into: Path) -> Path:
        """Where its results are kept."""
        plain = "".join(letter if letter.isalnum() else "-" for letter in self.name.lower())
        return into / f"{plain}-{self.law}"

    def cells(self, rows: Sequence[Row]) -> list[str]:
        """Its line of the table; a figure beyond its limit is followed by the limit."""
        flown = [row for row in rows if row["error"] is None]
        lost = sum(row["lost_by"] is not None for row in flown)
        waypoints = sum(row["waypoints"] for row in flown)
        honest = sum(row["captured_honestly"] for row in flown)
        figures = (self._cell(figure, figure.of(flown)) for figure in FIGURES)
        return [self.name, self.law, str(len(flown)), *figures, f"{honest}/{waypoints}", str(lost)]

    def _cell(self, figure: Figure, value: float) -> str:
        limit = self.must.get(figure.name)
        text = f"{value:.1f}"
        return text if limit is None or self.law == LAWS[0] or value <= limit else f"{text} (> {limit:g})"


def read(path: Path) -> list[TableRow] | None:
    """The rows of a table; None for the file of a single campaign. Raises LabError with what is wrong in it."""
    try:
        given = tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, tomllib.TOMLDecodeError, UnicodeDecodeError):
        return None  # said by the reader of a single campaign
    if "rows" not in given:
        return None
    unknown = given.keys() - _KEYS
    if unknown or not isinstance(given["rows"], list):
        raise LabError(f"{path} is no table of campaigns: it may have {', '.join(sorted(_KEYS))}")
    return [row for one in given["rows"] for row in _rows(path, given, one)]


def _rows(path: Path, given: Mapping[str, Any], one: Mapping[str, Any]) -> Iterator[TableRow]:
    unknown = one.keys() - _ROW_KEYS
    if unknown or "name" not in one:
        raise LabError(f"a row of {path} needs a `name`, and may have {', '.join(sorted(_ROW_KEYS))}")
    must = dict(one.get("must", {}))
    if must.keys() - {figure.name for figure in FIGURES}:
        raise LabError(f"{one['name']} must be held against {', '.join(figure.name for figure in FIGURES)}")
    for law in given.get("laws", LAWS):
        single = {
            "route": one.get("route", "gando"),
            "flights": one.get("flights", given.get("flights")),
            "seed": given.get("seed", 1),
            "fixed": {**one.get("fixed", {}), "law": law},
            "drawn": dict(one.get("drawn", {})),
        }
        yield TableRow(one["name"], law, campaigns.of(single, f"{single}\n", path), must)


def lines(cells: Sequence[Sequence[str]]) -> Iterator[str]:
    """The table as Markdown, with its head."""
    head = ["condition", "law", "flights", *(figure.title for figure in FIGURES), "captured", "lost"]
    widths = [max(len(line[column]) for line in (head, *cells)) for column in range(len(head))]
    for number, line in enumerate((head, *cells)):
        yield "| " + " | ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)) + " |"
        if number == 0:
            yield "|" + "|".join("-" * (width + 2) for width in widths) + "|"
