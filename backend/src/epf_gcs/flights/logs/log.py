"""What the readers of other programs' logs give."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Final, NamedTuple, TypeVar

import numpy as np

from epf_gcs.contract.flights import LogKind
from epf_gcs.errors import InvalidInputError
from epf_gcs.flights.logs.naming import Names, field_names, topic_names
from epf_gcs.recordings.log_table import LONGEST_UNIT, MOST_FIELDS, MOST_ROWS, LogTable

MOST_TOPICS: Final = 1000
EARLIEST_S: Final = 946_684_800
"""The year 2000: no clock of a flight shows an earlier time."""
T = TypeVar("T")


class Piece(NamedTuple):
    """Some rows, and how far the log is read (0..1)."""

    table: LogTable
    share: float


@dataclass
class Log:
    """`pieces` may be read once. `said`: what was left out, in sentences; complete when all pieces are read.

    `is_dated`: the times are Unix times; else they count from the start of something.
    """

    kind: LogKind
    pieces: Iterator[Piece]
    is_dated: bool = True
    said: list[str] = field(default_factory=list)


def reason_of(error: Exception) -> str:
    """What a reader says of what it could not read."""
    return (str(error) or type(error).__name__)[:200]


def unreadable(error: Exception) -> InvalidInputError:
    """A log of a kind that is known, which its reader cannot read."""
    reason = reason_of(error)
    return InvalidInputError("log_unreadable", f"This log cannot be read: {reason}.", reason=reason)


def cut(topic: str, units: dict[str, str], t_ns: np.ndarray, columns: list[np.ndarray]) -> Iterator[LogTable]:
    """A whole topic as tables of few enough rows. t_ns: int64, (n,); columns: numbers, each (n,)."""
    values = [np.asarray(column, np.float64) for column in columns]
    for first in range(0, len(t_ns), MOST_ROWS):
        rows = slice(first, first + MOST_ROWS)
        yield LogTable(topic, units, t_ns[rows], [one[rows] for one in values])


def _unit(said: str | None) -> str:
    """What a log says, if it can be shown."""
    return said[:LONGEST_UNIT] if said and said.isprintable() else "1"


class _Gathering:
    """The rows of one topic that wait for a table. Its fields are those of its first row."""

    def __init__(self, topic: str, values: Mapping[str, float], units: Mapping[str, str]) -> None:
        self._topic = topic
        self._fields = list(values)[:MOST_FIELDS]
        names = field_names()
        self._units = {names.new(one): _unit(units.get(one)) for one in self._fields}
        self._t_ns: list[int] = []
        self._rows: list[list[float]] = []

    def add(self, t_ns: int, values: Mapping[str, float]) -> LogTable | None:
        self._t_ns.append(t_ns)
        self._rows.append([values.get(one, np.nan) for one in self._fields])
        return self.table() if len(self._t_ns) >= MOST_ROWS else None

    def table(self) -> LogTable | None:
        if not self._t_ns:
            return None
        rows = np.array(self._rows, np.float64)
        made = LogTable(self._topic, self._units, np.array(self._t_ns, np.int64), list(rows.T.copy()))
        self._t_ns, self._rows = [], []
        return made


def guarded(step: Callable[[], T]) -> T:
    """What a library's step gives. At a stranger's file it may break in any way: raises InvalidInputError."""
    try:
        # It may print, and standard output is where a worker says how far it is.
        with contextlib.redirect_stdout(sys.stderr):
            return step()
    except Exception as error:
        raise unreadable(error) from error


class Rows:
    """Gathers rows that come one after the other, of any topics, to tables."""

    def __init__(self) -> None:
        self._names: Names = topic_names()
        self._topics: dict[str, _Gathering] = {}
        self.left_out = 0

    def add(self, topic: str, t_ns: int, values: Mapping[str, float], units: Mapping[str, str] = {}) -> LogTable | None:
        """Take a row; gives a table whenever one is full."""
        found = self._topics.get(topic)
        if found is None:
            if len(self._topics) >= MOST_TOPICS or not values:
                self.left_out += bool(values)
                return None
            found = self._topics[topic] = _Gathering(self._names.new(topic), values, units)
        return found.add(t_ns, values)

    @property
    def has_any(self) -> bool:
        """Whether a row was taken."""
        return bool(self._topics)

    def rest(self) -> Iterator[LogTable]:
        """The tables that are not full."""
        for one in self._topics.values():
            if (table := one.table()) is not None:
                yield table


def flattened(values: object, most_items: int = 32, depth: int = 6) -> dict[str, float]:
    """Every number in nested mappings and short lists, by its names with an underscore between."""
    found: dict[str, float] = {}

    def take(name: str, value: object, left: int) -> None:
        if isinstance(value, bool | int | float):
            found[name] = float(value)
        elif left and isinstance(value, Mapping):
            for key, one in value.items():
                take(f"{name}_{key}" if name else str(key), one, left - 1)
        elif left and isinstance(value, list | tuple) and len(value) <= most_items:
            for place, one in enumerate(value):
                take(f"{name}_{place}", one, left - 1)

    take("", values, depth)
    return found
