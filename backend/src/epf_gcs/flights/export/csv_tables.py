"""CSV: a file for each topic in an archive, or one file for one topic. The values are those that were recorded.

The first columns are `t_s` (Unix seconds, as everywhere in the interface) and `time` (the same moment in ISO 8601,
to the nanosecond). An empty field is a value that the board did not have. Bytes are hexadecimal.
"""

from __future__ import annotations

import zipfile
from pathlib import Path
from typing import IO, Any, Final

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.csv as pa_csv

from epf_gcs.flights.export.asked import ExportRequest, Progress
from epf_gcs.flights.export.stretch import Stretch, times_of
from epf_gcs.recordings.export_names import is_single

_ISO: Final = "%Y-%m-%dT%H:%M:%SZ"


def write(asked: ExportRequest, target: Path, _aside: Path, progress: Progress) -> None:
    """Raises GatewayError, OSError."""
    stretch = Stretch(asked, progress)
    stretch.expect(stretch.topics)
    if is_single(asked.format, asked.topics):
        with target.open("wb") as file:
            _write_topic(stretch, stretch.topics[0], file)
        return
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED, compresslevel=3) as archive:
        for topic in stretch.topics:
            with archive.open(f"{asked.flight}/{topic}.csv", "w", force_zip64=True) as entry:
                _write_topic(stretch, topic, entry)


def _write_topic(stretch: Stretch, topic: str, file: IO[bytes]) -> None:
    schema = _schema(stretch.schema(topic))
    with pa_csv.CSVWriter(pa.PythonFile(file, "w"), schema) as writer:
        for batch in stretch.batches(topic):
            writer.write_batch(_rows(batch, schema))


def _schema(schema: pa.Schema) -> pa.Schema:
    rest = [pa.field(field.name, _kind(field.type)) for field in schema if field.name != "t_ns"]
    return pa.schema([pa.field("t_s", pa.float64()), pa.field("time", pa.string()), *rest])


def _kind(kind: pa.DataType) -> pa.DataType:
    return pa.string() if pa.types.is_binary(kind) else kind


def _rows(batch: pa.RecordBatch, schema: pa.Schema) -> pa.RecordBatch:
    t_ns = times_of(batch)
    iso = pc.strftime(pa.array(t_ns).cast(pa.timestamp("ns", "UTC")), format=_ISO)
    columns: list[Any] = [pa.array(t_ns.astype(np.float64) * 1e-9), iso]
    for name in schema.names[2:]:
        column = batch.column(name)
        if pa.types.is_binary(column.type):
            column = pa.array([None if one is None else one.hex() for one in column.to_pylist()], pa.string())
        columns.append(column)
    return pa.record_batch(columns, schema=schema)
