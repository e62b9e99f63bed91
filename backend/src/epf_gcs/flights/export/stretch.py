"""The stretch of an indexed flight that is exported: its tables, read batch by batch."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, Final

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

from epf_gcs.flights.events import Event, read_events
from epf_gcs.flights.export.asked import ExportRequest, Progress, unknown_topic
from epf_gcs.flights.export.number_names import named_rows, named_schema
from epf_gcs.flights.indexed import not_indexed
from epf_gcs.recordings.flight_summary import FlightSummary
from epf_gcs.recordings.places import SUMMARY, Places
from epf_gcs.recordings.table_names import EVENTS, KEYFRAMES

ROWS: Final = 8192
"""Rows of a batch."""


class Stretch:
    """The asked part of a flight: it began at `start_ns`, and the part ends with `last_ns` (both Unix ns).

    Raises ConflictError if the flight has no columns, NotFoundError for a topic that it has not, OSError.
    """

    def __init__(self, asked: ExportRequest, progress: Progress) -> None:
        folder = Places(asked.recording.parent.parent).made_of(asked.flight)
        try:
            if folder is None:
                raise FileNotFoundError
            summary = FlightSummary.from_json((folder / SUMMARY).read_bytes())
        except (FileNotFoundError, ValueError) as error:
            raise not_indexed(asked.flight) from error
        self.folder = folder
        self.start_ns = summary.started_ns
        self.is_whole = asked.is_whole
        self._first_ns, self.last_ns = asked.span_ns(self.start_ns)
        self._progress = progress
        there = sorted(path.stem for path in folder.glob("*.parquet") if path.stem != KEYFRAMES)
        for topic in asked.topics or ():
            if topic not in there:
                raise unknown_topic(topic)
        self.topics = there if asked.topics is None else list(dict.fromkeys(asked.topics))
        self._all_rows = self._read_rows = 0
        self._base, self._share = 0.0, 1.0

    def path(self, topic: str) -> Path:
        """The Parquet file of a topic."""
        return self.folder / f"{topic}.parquet"

    def schema(self, topic: str) -> pa.Schema:
        """The columns of a topic with their units, and those with the names of numbers."""
        return named_schema(topic, pq.read_schema(self.path(topic)))

    def events(self) -> list[Event]:
        """What happened in the stretch, in order of time; also what nothing came of."""
        path = self.path(EVENTS)
        found = read_events(path) if path.exists() else []
        return [event for event in found if self._first_ns <= event.t_ns <= self.last_ns]

    def expect(self, topics: Sequence[str], base: float = 0.0, share: float = 1.0) -> None:
        """These topics are read next: the progress goes from `base` on by `share` while they are."""
        self._all_rows = max(1, sum(pq.ParquetFile(self.path(topic)).metadata.num_rows for topic in topics))
        self._read_rows, self._base, self._share = 0, base, share

    def batches(self, topic: str, columns: list[str] | None = None, rows: int = ROWS) -> Iterator[pa.RecordBatch]:
        """The rows of the stretch in the order of the file, none of the batches empty; without `columns` all of them,
        with the names of numbers."""
        # Without reading ahead: what a prefetch holds grows with the file.
        with pq.ParquetFile(self.path(topic), pre_buffer=False) as file:
            for group in range(file.metadata.num_row_groups):
                if not self._touches(file.metadata.row_group(group)):
                    self._count(file.metadata.row_group(group).num_rows)
                    continue
                for batch in file.iter_batches(rows, row_groups=[group], columns=columns, use_threads=False):
                    self._count(batch.num_rows)
                    chosen = self._chosen(batch)
                    if chosen.num_rows:
                        yield named_rows(topic, chosen) if columns is None else chosen

    def _chosen(self, batch: pa.RecordBatch) -> pa.RecordBatch:
        if self.is_whole:
            return batch
        t_ns = batch.column("t_ns").to_numpy()
        inside = (t_ns >= self._first_ns) & (t_ns <= self.last_ns)
        return batch if inside.all() else batch.filter(pa.array(inside))

    def _touches(self, group: Any) -> bool:
        """Whether a row group can have rows of the stretch, by the smallest and greatest time that the file gives."""
        for index in range(group.num_columns):
            column = group.column(index)
            if column.path_in_schema == "t_ns" and column.statistics is not None and column.statistics.has_min_max:
                return bool(column.statistics.max >= self._first_ns and column.statistics.min <= self.last_ns)
        return True

    def _count(self, rows: int) -> None:
        self._read_rows += rows
        self._progress.at(self._base + self._share * min(1.0, self._read_rows / self._all_rows))


def times_of(batch: pa.RecordBatch) -> np.ndarray[Any, np.dtype[np.int64]]:
    """The times of a batch, Unix ns."""
    found: np.ndarray[Any, np.dtype[np.int64]] = batch.column("t_ns").to_numpy()
    return found
