"""A finished flight: its samples from the Parquet files that the index worker made, read by DuckDB."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, Final

import duckdb
import numpy as np

from epf_gcs.errors import ConflictError
from epf_gcs.flights.fields import FieldMeaning, fields_of, fields_of_file
from epf_gcs.flights.flight_data import Damage, Samples, TopicSpan, in_order, unknown_signal
from epf_gcs.recordings.flight_summary import FlightSummary
from epf_gcs.recordings.notes import Note
from epf_gcs.recordings.places import SUMMARY
from epf_gcs.recordings.reading import notes_of

_MOST_CACHED_BYTES: Final = 192_000_000
_MEMORY: Final = "400MB"

Key = tuple[str, str, str]


class Columns:
    """Reads columns with DuckDB and keeps the ones used last, up to a number of bytes. For one thread."""

    def __init__(self, most_bytes: int = _MOST_CACHED_BYTES) -> None:
        self._database = duckdb.connect(":memory:", config={"threads": 1, "memory_limit": _MEMORY})
        self._kept: OrderedDict[Key, Any] = OrderedDict()
        self._most_bytes = most_bytes
        self._bytes = 0

    def column(self, file: Path, name: str, stamp: str) -> Any:
        """One column of a Parquet file as a numpy array in the file's order; nulls are NaN. Raises OSError."""
        key = (str(file), name, stamp)
        if key in self._kept:
            self._kept.move_to_end(key)
            return self._kept[key]
        found = self._read(file, name)
        self._kept[key] = found
        self._bytes += found.nbytes
        while self._bytes > self._most_bytes and len(self._kept) > 1:
            _, old = self._kept.popitem(last=False)
            self._bytes -= old.nbytes
        return found

    def damage(self, file: Path) -> list[Damage]:
        """Time (Unix ns) and kind of each damage that came from the board. Raises OSError."""
        try:
            rows = self._database.execute(
                "SELECT t_ns, kind FROM read_parquet(?) WHERE direction = 'received' ORDER BY t_ns", [str(file)]
            ).fetchall()
        except duckdb.Error as error:
            raise OSError(f"{file.name} cannot be read: {error}") from error
        return [(int(t_ns), str(kind)) for t_ns, kind in rows]

    def _read(self, file: Path, name: str) -> Any:
        as_is = name == "t_ns"
        column = '"t_ns"' if as_is else f'CAST("{name}" AS DOUBLE)'
        try:
            found = self._database.execute(f"SELECT {column} AS v FROM read_parquet(?)", [str(file)]).fetchnumpy()  # noqa: S608 - names of the definition
        except duckdb.Error as error:
            raise OSError(f"{file.name} cannot be read: {error}") from error
        values = found["v"]
        if isinstance(values, np.ma.MaskedArray):
            return values.filled(0 if as_is else np.nan)
        return values


class IndexedFlight:
    """`folder` holds the columns; the times of the first and last message are Unix ns.

    `notes` are the recording's, or a function that reads them when they are asked for. `stamp` tells columns that were
    made at another time from those that are cached.
    """

    def __init__(
        self,
        folder: Path,
        noted: list[Note] | Callable[[], list[Note]],
        start_ns: int,
        end_ns: int,
        *,
        columns: Columns,
        stamp: str = "",
    ) -> None:
        self.start_ns = start_ns
        self.end_ns = end_ns
        self._folder = folder
        self._noted = noted
        self._columns = columns
        self._stamp = stamp
        self._times: dict[str, Any] = {}
        self._fields: dict[str, Mapping[str, FieldMeaning]] = {}

    def topics(self) -> list[TopicSpan]:
        """The topics that have samples."""
        found = []
        for file in sorted(self._folder.glob("*.parquet")):
            if self.fields(file.stem):
                t_ns = self._columns.column(file, "t_ns", self._stamp)
                if len(t_ns):
                    found.append(TopicSpan(file.stem, len(t_ns), int(t_ns.min()), int(t_ns.max())))
        return found

    def fields(self, topic: str) -> Mapping[str, FieldMeaning]:
        """The fields of a topic; of one that is not built in, as its table has them. Raises OSError."""
        found = self._fields.get(topic)
        if found is None:
            found = self._fields[topic] = fields_of(topic) or fields_of_file(self._folder / f"{topic}.parquet")
        return found

    def samples(self, topic: str, field: str) -> Samples:
        """All samples of one field. Raises NotFoundError, OSError."""
        file = self._folder / f"{topic}.parquet"
        if field not in self.fields(topic) or not file.exists():
            raise unknown_signal(f"{topic}.{field}")
        t_s = self._times.get(topic)
        if t_s is None:
            t_s = self._times[topic] = (self._columns.column(file, "t_ns", self._stamp) - self.start_ns) * 1e-9
        return in_order(t_s, self._columns.column(file, field, self._stamp))

    def notes(self) -> list[Note]:
        """All notes. Raises RecordingError, OSError."""
        if not isinstance(self._noted, list):
            self._noted = self._noted()
        return self._noted

    def times(self, table: str) -> Any:
        """Unix times (ns) of the rows of any table, sorted; empty where the table is missing. Raises OSError."""
        file = self._folder / f"{table}.parquet"
        return np.sort(self._columns.column(file, "t_ns", self._stamp)) if file.exists() else np.empty(0)

    def damage(self, table: str) -> list[Damage]:
        """What the line damaged, in the order of the file; `table` is the name of its table. Raises OSError."""
        file = self._folder / f"{table}.parquet"
        return self._columns.damage(file) if file.exists() else []


def open_indexed(folder: Path, recording: Path, columns: Columns) -> IndexedFlight:
    """A flight whose columns were made. Raises ConflictError where they are not whole yet."""
    try:
        summary = FlightSummary.from_json((folder / SUMMARY).read_bytes())
        stamp = str((folder / SUMMARY).stat().st_mtime_ns)
    except (OSError, ValueError) as error:
        raise not_indexed(recording.stem) from error
    return IndexedFlight(
        folder, lambda: notes_of(recording), summary.started_ns, summary.ended_ns, columns=columns, stamp=stamp
    )


def not_indexed(flight: str) -> ConflictError:
    """The flight's columns are not made yet."""
    return ConflictError(
        "flight_not_indexed", f"The flight '{flight}' is being prepared: wait until it is indexed.", flight=flight
    )
