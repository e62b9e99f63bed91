"""MCAP with every topic decoded: JSON with a schema, in order of time; position, attitude and events also as Foxglove's
published schemas have them, and what is known of the flight as metadata.

Lichtblick and PlotJuggler show it as it is. The time of a message is the recorded one; that of a position is when it
may have been taken (see `spread.py`).
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, Final, NamedTuple

import numpy as np
import orjson
import pyarrow as pa
from mcap.records import Channel, Schema

from epf_gcs.flights.export.asked import ExportRequest, Progress
from epf_gcs.flights.export.flight_facts import flight_facts
from epf_gcs.flights.export.flown import TOPICS, WHERE, FlownLine, Source, attitudes, flown_lines
from epf_gcs.flights.export.foxglove_messages import Batches, locations, logs, poses, poses_in_place
from epf_gcs.flights.export.foxglove_schemas import LOCATION_FIX_SCHEMA, LOG_SCHEMA, POSE_SCHEMA
from epf_gcs.flights.export.json_schemas import schema_of
from epf_gcs.flights.export.stretch import Stretch, times_of
from epf_gcs.recordings.export_names import stretch_empty
from epf_gcs.recordings.mcap_file import Contents, encoded, message_record, metadata_record
from epf_gcs.recordings.packed_file import PackedFile
from epf_gcs.recordings.parts import Messages
from epf_gcs.recordings.scan import Places
from epf_gcs.recordings.table_names import EVENTS

_LIBRARY: Final = "epf-gcs export"
_LEVEL: Final = 3
_READING: Final = 0.1
# A batch of every topic is held at once, as JSON.
_ROWS: Final = 512
_SOURCES: Final[tuple[Source, ...]] = ("flight", "hil")


class _Stream(NamedTuple):
    topic: str
    schema: dict[str, Any]
    batches: Batches


def write(asked: ExportRequest, target: Path, aside: Path, progress: Progress) -> None:
    """Raises GatewayError, OSError."""
    stretch = Stretch(asked, progress)
    tracks: dict[Source, list[FlownLine]] = {}
    stretch.expect([topic for topic in TOPICS if topic in stretch.topics], share=_READING)
    for source in _SOURCES:
        tracks[source] = flown_lines(stretch, source, aside)
    stretch.expect(stretch.topics, _READING, 1.0 - _READING)
    streams = [
        _Stream(topic, schema_of(topic, stretch.schema(topic)), _topic(stretch, topic)) for topic in stretch.topics
    ]
    for source, lines in tracks.items():
        streams += _of_aircraft(stretch, source, lines)
    if EVENTS in stretch.topics:
        streams.append(_Stream("log", LOG_SCHEMA, logs(stretch.events(), asked.language)))
    with target.open("wb") as file:
        output = PackedFile(file, _LIBRARY, _contents(streams), _LEVEL)
        for name, values in flight_facts(asked.recording, stretch.last_ns).items():
            output.note(name, metadata_record(name, values))
        if not _merge([stream.batches for stream in streams], output):
            raise stretch_empty()
        output.finish()


def _of_aircraft(stretch: Stretch, source: Source, lines: list[FlownLine]) -> list[_Stream]:
    if lines:
        return [
            _Stream(f"location_{source}", LOCATION_FIX_SCHEMA, locations(source, lines)),
            _Stream(f"pose_{source}", POSE_SCHEMA, poses(source, lines)),
        ]
    if WHERE[source].attitude_topic not in stretch.topics:
        return []
    return [_Stream(f"pose_{source}", POSE_SCHEMA, poses_in_place(source, attitudes(stretch, source)))]


def _contents(streams: list[_Stream]) -> Contents:
    """One schema and channel for each stream, whose numbers begin at 1."""
    records = b""
    for number, stream in enumerate(streams, 1):
        name = str(stream.schema["title"])
        records += encoded(Schema(id=number, data=orjson.dumps(stream.schema), encoding="jsonschema", name=name))
    for number, stream in enumerate(streams, 1):
        records += encoded(
            Channel(id=number, topic=stream.topic, message_encoding="json", metadata={}, schema_id=number)
        )
    return Contents(records, len(streams), len(streams))


def _topic(stretch: Stretch, topic: str) -> Batches:
    for batch in stretch.batches(topic, rows=_ROWS):
        yield times_of(batch), _rows(batch)


def _rows(batch: pa.RecordBatch) -> list[bytes]:
    """The rows as JSON, without what is null."""
    names = [name for name in batch.schema.names if name != "t_ns"]
    columns = [_values(batch.column(name)) for name in names]
    if not names:
        return [b"{}"] * batch.num_rows
    rows = zip(*columns, strict=True)
    if any(batch.column(name).null_count for name in names):
        return [
            orjson.dumps({name: value for name, value in zip(names, row, strict=True) if value is not None})
            for row in rows
        ]
    return [orjson.dumps(dict(zip(names, row, strict=True))) for row in rows]


def _values(column: pa.Array) -> list[Any]:
    if pa.types.is_binary(column.type):
        return [None if one is None else one.hex() for one in column.to_pylist()]
    if pa.types.is_float32(column.type):
        # The shortest text that is the same single float: as a double it would have twice as many digits.
        column = column.cast(pa.string()).cast(pa.float64())
    if column.null_count or not (pa.types.is_floating(column.type) or pa.types.is_integer(column.type)):
        return column.to_pylist()  # type: ignore[no-any-return]
    return column.to_numpy().tolist()  # type: ignore[no-any-return]


def _merge(sources: list[Batches], output: PackedFile) -> bool:
    """Write the messages of all streams in order of time; False if there was none.

    One batch of each stream is held. All that is not later than the earliest end of a batch can be written.
    """
    held: dict[int, tuple[Places, list[bytes]]] = {}
    counts = [0] * len(sources)
    waiting = set(range(len(sources)))
    wrote = False
    while True:
        for index in sorted(waiting):
            batch = next(sources[index], None)
            if batch is not None:
                held[index] = batch
        waiting.clear()
        if not held:
            return wrote
        until_ns = min(int(t_ns.max()) for t_ns, _ in held.values())
        taken = []
        for index, (t_ns, rows) in list(held.items()):
            # Up to the first later one: where the clock was set back, the order of the file stays.
            late = np.flatnonzero(t_ns > until_ns)
            count = int(late[0]) if len(late) else len(t_ns)
            taken.append((index, t_ns[:count], rows[:count], counts[index]))
            counts[index] += count
            if count == len(t_ns):
                del held[index]
                waiting.add(index)
            else:
                held[index] = (t_ns[count:], rows[count:])
        _put(taken, output)
        wrote = True


def _put(taken: list[tuple[int, Places, list[bytes], int]], output: PackedFile) -> None:
    records: list[bytes] = []
    for index, t_ns, rows, first in taken:
        records += [
            message_record(index + 1, first + place, time_ns, row)
            for place, (time_ns, row) in enumerate(zip(t_ns.tolist(), rows, strict=True))
        ]
    t_ns = np.concatenate([one[1] for one in taken])
    channel = np.concatenate([np.full(len(one[1]), one[0] + 1, dtype=np.uint16) for one in taken])
    order = np.argsort(t_ns, kind="stable")
    joined = [records[place] for place in order.tolist()]
    length = np.fromiter((len(record) for record in joined), np.int64, len(joined))
    at = np.cumsum(length) - length
    data = np.frombuffer(b"".join(joined), dtype=np.uint8)
    output.put(data, at, Messages(channel[order], t_ns[order], at, length, data))
