"""What the list of flights is asked for: which flights, in which order, and by what it may be narrowed."""

from __future__ import annotations

import unicodedata
from dataclasses import dataclass
from typing import Final, Literal

Sort = Literal["started", "duration", "highest", "fastest", "bytes", "distance", "alarms", "marks", "title"]
_SORTS: Final[dict[Sort, str]] = {
    "started": "started_s",
    "duration": "duration_s",
    "highest": "highest_ft",
    "fastest": "fastest_kt",
    "bytes": "bytes",
    "distance": "json_extract(summary, '$.distance_nm')",
    "alarms": "json_extract(summary, '$.alarms')",
    "marks": "json_extract(summary, '$.marks')",
    "title": "nullif(json_extract(about, '$.title'), '') COLLATE NOCASE",
}


@dataclass(frozen=True, slots=True)
class FlightQuery:
    """Which flights: all words of `text` in what is said or known of it, a tag, a stretch of Unix time, and the names
    of board, aircraft and operator."""

    text: str = ""
    tag: str | None = None
    board: str | None = None
    aircraft: str | None = None
    operator: str | None = None
    from_s: float | None = None
    to_s: float | None = None
    sort: Sort = "started"
    descending: bool = True
    first: int = 0
    most: int = 50

    def terms(self) -> tuple[str, list[str | float]]:
        """The condition for a row of the library, as SQL with its values."""
        terms: list[str] = ["1"]
        values: list[str | float] = []
        for word in plain(self.text).split():
            terms.append("words LIKE ? ESCAPE '\\'")
            values.append(f"%{_escaped(word)}%")
        for term, value in (
            ("EXISTS (SELECT 1 FROM json_each(about, '$.tags') WHERE json_each.value = ?)", self.tag),
            ("board = ?", self.board),
            ("json_extract(summary, '$.aircraft') = ?", self.aircraft),
            ("json_extract(summary, '$.operator') = ?", self.operator),
            ("started_s >= ?", self.from_s),
            ("started_s <= ?", self.to_s),
        ):
            if value is not None:
                terms.append(term)
                values.append(value)
        return " AND ".join(terms), values

    def order(self) -> str:
        """The order of the rows, as SQL; what is not known comes last."""
        order = "DESC" if self.descending else "ASC"
        return f"ORDER BY {_SORTS[self.sort]} {order} NULLS LAST, id {order}"


@dataclass(frozen=True, slots=True)
class LibraryWords:
    """What the library may be narrowed by, of all flights; `unnamed` are files whose names are no flight's."""

    tags: list[str]
    boards: list[str]
    aircraft: list[str]
    operators: list[str]
    unnamed: list[str]


def plain(text: str) -> str:
    """Lower case without accents, so that a search for `avion` finds `Avión`."""
    parts = unicodedata.normalize("NFKD", text.casefold())
    return "".join(part for part in parts if not unicodedata.combining(part))


def _escaped(word: str) -> str:
    return word.replace("\\", "\\\\").replace("%", "\\%").replace("_", "\\_")
