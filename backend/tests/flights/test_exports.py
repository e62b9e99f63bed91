"""Exports of one flight: the values that were recorded, whole or not at all, in memory of one size."""

from __future__ import annotations

import csv
import io
import os
import signal
import subprocess
import sys
import zipfile
from collections import Counter
from datetime import datetime
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import orjson
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from jsonschema import Draft202012Validator
from mcap.reader import make_reader

from epf_gcs.codec.messages_gen import TELEMETRY_BY_NAME
from epf_gcs.errors import ConflictError, GatewayError
from epf_gcs.flights.export.asked import Progress
from epf_gcs.flights.export.verb import run
from epf_gcs.flights.importing import run as import_run
from epf_gcs.recordings.mcap_file import Tally, closing, data_end, message_record, metadata_record, opening
from epf_gcs.recordings.notes import EVENT, IDENTITY, PLAN, written
from epf_gcs.recordings.packing import pack
from epf_gcs.recordings.reading import Message, notes_of, read_file, walk
from epf_gcs.recordings.topics import TOPICS
from tests.codec.streams import mixed_frames
from tests.flights.flown_flights import FLIGHT, indexed, quiet, recording
from tests.flights.test_columns import recording as recording_of
from tests.recordings.files import START_NS
from tests.support.waiting import DEADLINE_S


@pytest.fixture(scope="module")
def flight(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return indexed(tmp_path_factory.mktemp("exports"), recording(30))


@pytest.fixture(scope="module")
def every_topic(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Frames of every kind, both ways."""
    received = b"".join(mixed_frames(2000, seed=5))
    return indexed(tmp_path_factory.mktemp("topics"), recording_of(received, b"".join(mixed_frames(300, seed=3))))


def export(path: Path, kind: str, *options: str, name: str = "one") -> Path:
    target = path.parent.parent / "exports" / name
    target.unlink(missing_ok=True)
    run([str(path), kind, str(target), *options], quiet)
    return target


def columns_of(path: Path) -> dict[str, pa.Table]:
    """The tables that were made of a recording."""
    (folder,) = (path.parent.parent / "columns").glob("vehicle=*/date=*/flight=*")
    found = {file.stem: pq.read_table(file, partitioning=None) for file in folder.glob("*.parquet")}
    return {topic: table for topic, table in found.items() if topic != "keyframes"}


def decoded(path: Path) -> list[tuple[str, int, dict[str, Any], dict[str, Any]]]:
    """Topic, time, message and schema of every message, in the order of the file, by the mcap library."""
    with path.open("rb") as file:
        return [
            (channel.topic, message.log_time, orjson.loads(message.data), orjson.loads(schema.data))
            for schema, channel, message in make_reader(file, validate_crcs=True).iter_messages(log_time_order=False)
            if schema is not None
        ]


def test_the_recording_is_exported_as_it_is(flight: Path) -> None:
    assert export(flight, "mcap").read_bytes() == flight.read_bytes()


@pytest.mark.parametrize("is_packed", [False, True])
def test_a_stretch_of_the_recording_has_its_bytes_and_what_was_known_before_it(
    flight: Path, tmp_path: Path, is_packed: bool
) -> None:
    source = flight
    if is_packed:
        source = tmp_path / "recordings" / flight.name
        source.parent.mkdir()
        pack(flight, source)
    target = export(source, "mcap", "--from-s", "10", "--to-s", "20.5")
    begin_ns, end_ns = START_NS + 10 * 10**9, START_NS + 20_500_000_000
    expected = [one for one in walk(flight) if isinstance(one, Message) and begin_ns <= one.t_ns <= end_ns]
    found = read_file(target)
    assert found.is_whole
    assert [one for one in walk(target) if isinstance(one, Message)] == expected
    assert [note.name for note in found.notes] == [IDENTITY, PLAN]


def test_what_happened_after_a_stretch_is_not_in_its_recording(tmp_path: Path) -> None:
    path = tmp_path / "recordings" / f"{FLIGHT}.mcap"
    path.parent.mkdir()
    tally, body = Tally(), opening("test", TOPICS)
    for second in range(10):
        t_ns = START_NS + second * 10**9
        body += message_record(1, tally.add(1, t_ns), t_ns, b"\rQT,")
        if second in (3, 9):
            body += metadata_record(EVENT, written(t_ns + 1, {"event": "mark", "data": {"second": second}}))
    tally.metadata_count = 2
    body += data_end()
    path.write_bytes(body + closing(TOPICS, tally, len(body)))
    target = export(path, "mcap", "--from-s", "2", "--to-s", "5.5")
    assert [note.content["data"]["second"] for note in notes_of(target)] == [3]


def test_every_format_is_refused_for_a_stretch_without_anything(flight: Path) -> None:
    for kind, begin, end in (("mcap", "40", "50"), ("mcap-decoded", "40", "50"), ("csv", "5", "5"), ("csv", "6", "5")):
        with pytest.raises(GatewayError) as fault:
            export(flight, kind, "--from-s", begin, "--to-s", end)
        assert fault.value.code == "export_stretch_empty"


def test_csv_has_the_recorded_values_and_both_times(every_topic: Path) -> None:
    tables = columns_of(every_topic)
    with zipfile.ZipFile(export(every_topic, "csv")) as archive:
        assert {Path(name).stem for name in archive.namelist()} == set(tables)
        for topic, table in tables.items():
            rows = list(csv.DictReader(io.StringIO(archive.read(f"{FLIGHT}/{topic}.csv").decode())))
            assert len(rows) == table.num_rows, topic
            for row, expected in zip(rows, table.to_pylist(), strict=True):
                t_ns = expected.pop("t_ns")
                assert float(row.pop("t_s")) == t_ns * 1e-9
                time = row.pop("time")
                assert datetime.fromisoformat(time).timestamp() == pytest.approx(t_ns * 1e-9, abs=1e-6)
                assert int(time[-10:-1]) == t_ns % 10**9
                assert {name: _read(text, table.schema.field(name).type) for name, text in row.items()} == expected


def _read(text: str, kind: pa.DataType) -> Any:
    if pa.types.is_string(kind):
        return text or None
    if text == "":
        return None
    if pa.types.is_boolean(kind):
        return text == "true"
    if pa.types.is_binary(kind):
        return bytes.fromhex(text)
    return int(text) if pa.types.is_integer(kind) else float(np.float32(text)) if kind == pa.float32() else float(text)


def test_one_topic_is_one_file(flight: Path) -> None:
    table = columns_of(flight)["gps"]
    text = export(flight, "csv", "--topics", "gps").read_text()
    assert len(text.splitlines()) == table.num_rows + 1
    assert pq.read_table(export(flight, "parquet", "--topics", "gps")).equals(table)


def test_parquet_is_the_flights_part_of_the_dataset(every_topic: Path, tmp_path: Path) -> None:
    with zipfile.ZipFile(export(every_topic, "parquet")) as archive:
        archive.extractall(tmp_path)
    assert {path.parts[-4] for path in tmp_path.glob("*/*/*/*")} == {"vehicle=unknown"}
    found = {
        path.stem: pq.read_table(path, partitioning=None)
        for path in tmp_path.glob(f"vehicle=*/date=2026-01-31/flight={FLIGHT}/*.parquet")
    }
    tables = columns_of(every_topic)
    assert set(found) == set(tables)
    assert all(found[topic].equals(table, check_metadata=True) for topic, table in tables.items())


@pytest.mark.parametrize("kind", ["csv", "parquet"])
def test_a_stretch_has_its_rows_alone(flight: Path, kind: str) -> None:
    table = columns_of(flight)["ahrs"]
    t_ns = table["t_ns"].to_numpy()
    expected = int(((t_ns >= START_NS + 10 * 10**9) & (t_ns <= START_NS + 12 * 10**9)).sum())
    path = export(flight, kind, "--topics", "ahrs", "--from-s", "10", "--to-s", "12")
    rows = len(path.read_text().splitlines()) - 1 if kind == "csv" else pq.read_table(path).num_rows
    assert rows == expected == 101


def test_decoded_mcap_has_every_value_in_order_of_time_and_fits_its_schemas(every_topic: Path) -> None:
    found = decoded(export(every_topic, "mcap-decoded"))
    assert all(one[1] <= other[1] for one, other in pairwise(found))
    tables = columns_of(every_topic)
    for topic, table in tables.items():
        rows = [(t_ns, message) for name, t_ns, message, _ in found if name == topic]
        single = {field.name for field in table.schema if pa.types.is_float32(field.type)}
        expected = [
            (
                row.pop("t_ns"),
                {name: _plain(value, is_single=name in single) for name, value in row.items() if value is not None},
            )
            for row in table.sort_by("t_ns").to_pylist()
        ]
        assert rows == expected, topic
    checkers: dict[str, Draft202012Validator] = {}
    for topic, _, message, schema in found:
        if topic not in checkers:
            Draft202012Validator.check_schema(schema)
            checkers[topic] = Draft202012Validator(schema)
        checkers[topic].validate(message)
        assert set(message) <= set(schema["properties"]), "every field is described"
    for topic, checker in checkers.items():
        if topic in TELEMETRY_BY_NAME:
            for value in TELEMETRY_BY_NAME[topic].values:
                said = checker.schema["properties"][value.name]
                assert value.doc in said["description"]
                assert value.unit == "1" or value.unit in said["description"]
                assert isinstance(said["type"], str), "readers do not know types that may be two"


def _plain(value: Any, *, is_single: bool) -> Any:
    """A single float has as few digits as make it the same single float."""
    if is_single:
        return float(str(np.float32(value)))
    return value.hex() if isinstance(value, bytes) else value


def test_decoded_mcap_is_found_by_time_through_its_index(flight: Path) -> None:
    with export(flight, "mcap-decoded").open("rb") as file:
        reader = make_reader(file)
        summary = reader.get_summary()
        assert summary is not None
        assert summary.statistics is not None
        assert summary.statistics.schema_count == len(summary.schemas) == len(summary.channels)
        assert {index.compression for index in summary.chunk_indexes} == {"zstd"}
        begin, end = START_NS + 5 * 10**9, START_NS + 6 * 10**9
        topics = Counter(
            channel.topic
            for _, channel, _ in reader.iter_messages(starting_at=begin, ending_before=end, log_time_order=True)
        )
    assert (topics["ahrs"], topics["gps"], topics["location_flight"]) == (50, 10, 10)
    assert topics["location_hil"] == pytest.approx(50, abs=1), "a place of the next moment may have been taken in this"


def test_an_exported_recording_is_imported_to_an_equal_flight(flight: Path, tmp_path: Path) -> None:
    checked = tmp_path / "recordings" / flight.name
    checked.parent.mkdir()
    answer = import_run([str(export(flight, "mcap")), str(checked)], quiet)
    assert answer["damage"] is None
    again = indexed(tmp_path, checked.read_bytes())
    assert columns_of(again).keys() == columns_of(flight).keys()
    assert all(columns_of(again)[topic].equals(table) for topic, table in columns_of(flight).items())
    assert notes_of(again) == notes_of(flight)


def test_a_topic_that_is_not_there_and_one_where_there_are_none_are_refused(flight: Path) -> None:
    for kind, code in (("csv", "export_topic_unknown"), ("kml", "export_topics_unused")):
        with pytest.raises(GatewayError) as fault:
            export(flight, kind, "--topics", "nothing")
        assert fault.value.code == code
    assert list((flight.parent.parent / "exports").glob(".*")) == [], "nothing half done stays"


def test_a_flight_that_is_not_indexed_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "recordings" / f"{FLIGHT}.mcap"
    path.parent.mkdir()
    path.write_bytes(recording(1))
    with pytest.raises(ConflictError) as fault:
        export(path, "csv")
    assert fault.value.code == "flight_not_indexed"
    assert export(path, "mcap").read_bytes() == path.read_bytes()


def test_an_export_ends_before_the_disk_is_full(tmp_path: Path) -> None:
    free = iter((10**10, 10**9))
    progress = Progress(quiet, tmp_path, "x.csv", lambda _: next(free))
    progress.at(0.5)
    with pytest.raises(ConflictError) as fault:
        progress.at(0.6)
    assert (fault.value.code, fault.value.params["free_mb"]) == ("flight_disk_full", 1000)


def worker(path: Path, kind: str, target: Path) -> subprocess.Popen[bytes]:
    """The program as the web process starts it."""
    command = [sys.executable, "-m", "epf_gcs.flights", "export", str(path), kind, str(target)]
    return subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)


def test_a_cancelled_export_leaves_nothing_and_tells_its_progress(flight: Path) -> None:
    exports = flight.parent.parent / "exports" / "cancelled"
    process = worker(flight, "mcap-decoded", exports / "file")
    assert process.stdout is not None
    first = orjson.loads(process.stdout.readline())
    assert first == {"progress": 0.0, "doing": "exporting"}
    process.send_signal(signal.SIGTERM)
    process.communicate(timeout=DEADLINE_S)
    assert process.returncode in (0, 128 + signal.SIGTERM)
    left = [path.name for path in exports.iterdir()]
    assert left in ([], ["file"]), "whole or not there"
    assert not [name for name in left if name.startswith(".")]


@pytest.fixture(scope="module")
def two_lengths(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """A flight and one of eight times its length."""
    return tuple(indexed(tmp_path_factory.mktemp("length"), recording(seconds)) for seconds in (60, 480))  # type: ignore[return-value]


@pytest.mark.uncounted
@pytest.mark.parametrize("kind", ["mcap", "mcap-decoded", "csv", "parquet", "kmz", "gpx", "czml"])
def test_the_memory_of_an_export_does_not_grow_with_the_flight(two_lengths: tuple[Path, Path], kind: str) -> None:
    short, long = (_peak_kb(path, kind) for path in two_lengths)
    # All samples of the longer flight are 20 MB as numbers, and several times that as text or objects.
    assert long - short < 12_000


def _peak_kb(path: Path, kind: str) -> int:
    process = worker(path, kind, path.parent.parent / "exports" / kind)
    assert process.stdout is not None
    lines = process.stdout.read().splitlines()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    assert "done" in orjson.loads(lines[-1])
    assert process.stdin is not None
    process.stdin.close()
    process.stdout.close()
    return usage.ru_maxrss
