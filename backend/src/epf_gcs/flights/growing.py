"""The flight that is being recorded: decoded in memory as it grows, by the same steps as the index worker."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa

from epf_gcs.errors import NotFoundError
from epf_gcs.flights.columns import TableMaker
from epf_gcs.flights.fields import FieldMeaning, fields_of, fields_of_table
from epf_gcs.flights.flight_data import Damage, Samples, TopicSpan, in_order, unknown_signal
from epf_gcs.recordings.notes import Note
from epf_gcs.recordings.table_names import DAMAGE


class GrowingFlight:
    """Call `advance` before a question; the answers are of what the file had then. Raises RecordingError, OSError."""

    def __init__(self, path: Path) -> None:
        self._kept = _TableParts()
        self._making = TableMaker(self._kept, path)
        self._flight = path.stem

    def advance(self) -> None:
        """Take what was written since. Raises NotFoundError while there is no message yet."""
        self._making.advance()
        if self._making.counts.first_ns is None:
            raise NotFoundError(
                "flight_unknown", f"The flight '{self._flight}' has no message yet.", flight=self._flight
            )

    @property
    def start_ns(self) -> int:
        """Unix time of the first message."""
        return self._making.counts.first_ns or 0

    @property
    def end_ns(self) -> int:
        """Unix time of the last message so far."""
        return self._making.counts.last_ns or 0

    @property
    def silences(self) -> list[tuple[int, int]]:
        """Stretches (Unix ns) without a byte of the board while its line was open."""
        return self._making.counts.gaps

    def topics(self) -> list[TopicSpan]:
        """The topics that have samples."""
        found = []
        for topic in sorted(self._kept.topics()):
            t_ns = self._kept.column(topic, "t_ns")
            found.append(TopicSpan(topic, len(t_ns), int(t_ns.min()), int(t_ns.max())))
        return found

    def fields(self, topic: str) -> Mapping[str, FieldMeaning]:
        """The fields of a topic."""
        return self._kept.fields(topic)

    def samples(self, topic: str, field: str) -> Samples:
        """All samples of one field so far. Raises NotFoundError."""
        if field not in self.fields(topic) or topic not in self._kept.topics():
            raise unknown_signal(f"{topic}.{field}")
        return in_order((self._kept.column(topic, "t_ns") - self.start_ns) * 1e-9, self._kept.column(topic, field))

    def notes(self) -> list[Note]:
        """All notes so far."""
        return self._making.notes

    def damage(self, _table: str = DAMAGE) -> list[Damage]:
        """What the line damaged so far."""
        return self._kept.damage


class _TableParts:
    """The tables that questions need, one after the other; columns are joined when they are asked for."""

    def __init__(self) -> None:
        self.damage: list[Damage] = []
        self._tables: dict[str, list[pa.Table]] = {}
        self._columns: dict[tuple[str, str], Any] = {}

    def add(self, topic: str, table: pa.Table) -> None:
        if topic == DAMAGE:
            rows = zip(*(table.column(name).to_pylist() for name in ("t_ns", "direction", "kind")), strict=True)
            self.damage += [(t_ns, kind) for t_ns, direction, kind in rows if direction == "received"]
        elif table.num_rows and (topic in self._tables or fields_of(topic) or fields_of_table(table.schema)):
            self._tables.setdefault(topic, []).append(table)
            for name in table.column_names:
                self._columns.pop((topic, name), None)

    def topics(self) -> list[str]:
        return list(self._tables)

    def fields(self, topic: str) -> Mapping[str, FieldMeaning]:
        """The fields of a topic by name; of an own topic, read from its first table."""
        tables = self._tables.get(topic)
        return fields_of(topic) or ({} if tables is None else fields_of_table(tables[0].schema))

    def column(self, topic: str, name: str) -> Any:
        """Times as they are, values as numbers with NaN for none."""
        key = (topic, name)
        found = self._columns.get(key)
        if found is None:
            tables = self._tables[topic]
            if len(tables) > 1:
                tables[:] = [pa.concat_tables(tables).combine_chunks()]
            column = tables[0].column(name)
            if name != "t_ns":
                column = column.cast(pa.int8()) if pa.types.is_boolean(column.type) else column
                column = column.cast(pa.float64())
            found = self._columns[key] = np.asarray(column.to_numpy())
        return found
