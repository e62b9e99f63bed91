"""A recording's columns are what the live decoder would have said, and its key frames lead to the right place."""

from __future__ import annotations

import random
from collections.abc import Iterable
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import orjson
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from epf_gcs.codec.encode import frame_bytes
from epf_gcs.codec.frame import FROM_BOARD, TO_BOARD, Direction, Frame, FrameDecoder
from epf_gcs.codec.messages_gen import COMMANDS, COMMANDS_BY_ID, TELEMETRY, XPLANE_ROWS
from epf_gcs.codec.values import meaning, steps
from epf_gcs.flights.bulk import BulkDecoder, Frames
from epf_gcs.flights.columns import TableFolder, write_columns
from epf_gcs.flights.convert import layout, schema, table
from epf_gcs.flights.index import run
from epf_gcs.flights.keyframes import EVERY_NS
from epf_gcs.flights.tables import Tables
from epf_gcs.recordings.mcap_file import message_record, metadata_record, opening
from epf_gcs.recordings.notes import IDENTITY, LINE, written
from epf_gcs.recordings.reading import Message, RecordingError, walk
from epf_gcs.recordings.topics import BOARD_RECEIVED, BOARD_SENT, SIMULATOR_RECEIVED, TOPICS
from epf_gcs.vehicle.simulator_samples import SimulatorSamples
from epf_gcs.xplane.datagram import Record, build
from tests.codec.streams import damage, mixed_frames
from tests.recordings.files import START_NS, packed

RECORD_NS = 5_000_000


def quiet(_progress: float, _doing: str) -> None:
    """No progress is looked at."""


def recording(received: bytes, sent: bytes = b"", notes: tuple[bytes, ...] = (), chunk: int = 40) -> bytes:
    """A recording of both directions, a record each 5 ms; the notes come first."""
    data = [opening("test 1.0", TOPICS), *notes]
    t_ns = START_NS
    for at in range(0, max(len(received), len(sent)), chunk):
        for channel, stream in ((BOARD_RECEIVED, received), (BOARD_SENT, sent)):
            if stream[at : at + chunk]:
                data.append(message_record(channel, 0, t_ns, stream[at : at + chunk]))
        t_ns += RECORD_NS
    return b"".join(data)


def made(tmp_path: Path, data: bytes) -> TableFolder:
    path = tmp_path / "recordings" / "20260131T120000Z.mcap"
    path.parent.mkdir(exist_ok=True)
    path.write_bytes(data)
    return write_columns(path, tmp_path / "columns", quiet)


def rows(folder: Path, topic: str) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = pq.read_table(folder / f"{topic}.parquet", partitioning=None).to_pylist()
    return found


def live(stream: bytes, way: Direction, chunk: int = 40) -> dict[str, list[dict[str, Any]]]:
    """What the live decoder makes of it, by topic, with the time of the record that completed each frame."""
    decoder = FrameDecoder(way)
    found: dict[str, list[dict[str, Any]]] = {}
    for index, at in enumerate(range(0, len(stream), chunk)):
        for event in decoder.feed(stream[at : at + chunk]):
            if isinstance(event, Frame):
                row = {"t_ns": START_NS + index * RECORD_NS, **meaning(event).values}
                found.setdefault(event.message.name, []).append(row)
    return found


def test_every_topic_has_the_live_values_and_times(tmp_path: Path) -> None:
    received = damage(mixed_frames(3000, seed=1), 0.0003, seed=2).data
    sent = b"".join(mixed_frames(600, seed=3, way=TO_BOARD))
    folder = made(tmp_path, recording(received, sent)).folder
    for name, expected in live(received, FROM_BOARD).items():
        assert rows(folder, name) == expected, name
    for name, expected in live(sent, TO_BOARD).items():
        assert rows(folder, f"sent_{name}") == expected, name


def _wild(slot: Any, rng: random.Random) -> Any:
    """Any wire value, often one at or beyond a limit."""
    if slot.kind == "S":
        return rng.choice((b"", b"board", b"a\0b", b"\xff\x01", bytes(range(48, 64)), b"x" * 16))
    if slot.kind == "f":
        edges = (float("nan"), float("inf"), -1.0, 1.0, 0.0, 99.99, -500.0, 360.0, 1e30, rng.uniform(-400, 400))
        return rng.choice(edges)
    info = np.iinfo(slot)
    numbers = (0, 1, 2, 3, -1, 0x38, 0x3132, 0x41, 0x56, 100, info.min, info.max, rng.randrange(info.min, info.max))
    return min(info.max, max(info.min, rng.choice(numbers)))


@pytest.mark.parametrize("message", [*TELEMETRY.values(), *COMMANDS_BY_ID.values()], ids=lambda one: f"{one.name}")
def test_values_in_bulk_are_the_live_ones_whatever_the_wire_brings(message: Any) -> None:
    rng = random.Random(message.id)
    way = FROM_BOARD if message in TELEMETRY.values() else TO_BOARD
    kinds = [layout(message)[index] for index in range(len(layout(message).fields or ()))] if message.size else []
    payloads = [message.struct.pack(*(_wild(kind, rng) for kind in kinds)) for _ in range(200)]
    stream = b"".join(frame_bytes(way, message, payload) for payload in payloads)
    frames = (
        BulkDecoder(way).feed(np.frombuffer(stream, np.uint8), np.array([len(stream)]), np.array([7])).frames[message]
    )
    read, implausible = table(message, frames)
    expected = [meaning(Frame(message, payload)) for payload in payloads]
    assert read.drop_columns(["t_ns"]).to_pylist() == [one.values for one in expected] or not message.values
    counted = {step.name: sum(step.name in one.implausible for one in expected) for step in steps(message)}
    assert implausible == {name: count for name, count in counted.items() if count}


def test_names_and_units_are_the_definitions(tmp_path: Path) -> None:
    folder = made(tmp_path, recording(b"".join(mixed_frames(50, seed=1)))).folder
    shape = pq.read_schema(folder / "analog.parquet")
    assert shape.equals(schema(TELEMETRY[3]), check_metadata=False)
    for value in TELEMETRY[3].values:
        assert shape.field(value.name).metadata[b"unit"].decode() == value.unit
    assert shape.field("t_ns").metadata == {b"unit": b"ns"}
    assert shape.field("t_ns").type == pa.int64()


def test_the_folder_is_named_by_aircraft_day_and_flight_and_replaced_whole(tmp_path: Path) -> None:
    first = made(tmp_path, recording(b"".join(mixed_frames(50, seed=1)))).folder
    assert first == tmp_path / "columns/vehicle=unknown/date=2026-01-31/flight=20260131T120000Z"
    named = metadata_record(IDENTITY, written(START_NS, {"aircraft": "../Skyw alker", "board": {}}))
    second = made(tmp_path, recording(b"".join(mixed_frames(50, seed=1)), notes=(named,))).folder
    assert second == tmp_path / "columns/vehicle=Skyw_alker/date=2026-01-31/flight=20260131T120000Z"
    assert not first.exists()
    assert second.exists()


def test_a_failure_leaves_no_half_columns_and_keeps_the_earlier_ones(tmp_path: Path) -> None:
    good = made(tmp_path, recording(b"".join(mixed_frames(50, seed=1)))).folder
    path = tmp_path / "recordings" / "20260131T120000Z.mcap"
    path.write_bytes(path.read_bytes() + opening("x", {8: TOPICS[1]})[8:])
    with pytest.raises(RecordingError):
        write_columns(path, tmp_path / "columns", quiet)
    assert [one.name for one in (tmp_path / "columns").iterdir()] == ["vehicle=unknown"]
    assert rows(good, "ahrs")


def test_counts_say_what_was_damaged_and_where_the_line_was_silent(tmp_path: Path) -> None:
    frame = frame_bytes(FROM_BOARD, TELEMETRY[1], bytes(12))
    opened = metadata_record(LINE, written(START_NS, {"line": "board", "open": True}))
    closed = metadata_record(LINE, written(START_NS + 4 * 10**9, {"line": "board", "open": False}))
    again = metadata_record(LINE, written(START_NS + 30 * 10**9, {"line": "board", "open": True}))
    data = opening("test 1.0", TOPICS) + opened
    for second, payload in ((0, frame), (1, frame[:-9] + b"\x55" + frame[-8:]), (4, frame[:20])):
        data += message_record(BOARD_RECEIVED, 0, START_NS + second * 10**9, payload)
    data += closed + again + message_record(BOARD_RECEIVED, 0, START_NS + 30 * 10**9, frame)
    found = made(tmp_path, data)
    counts = found.counts
    assert counts.frames == {"ahrs": 2}
    assert counts.damaged == {"bad_checksum": 1, "remains": 2, "cut_short": 1}
    assert (counts.frames_heard, counts.frames_damaged) == (2, 2)
    assert counts.gaps == [(START_NS + 10**9, START_NS + 4 * 10**9)], "while the line was closed is no gap"
    assert [row["kind"] for row in rows(found.folder, "damage")] == ["bad_checksum", "remains", "cut_short", "remains"]
    per_second = rows(found.folder, "link")
    assert [row["board_received_bytes"] for row in per_second] == [28, 28, 20, 28]


def test_rows_of_text_are_written_before_they_fill_the_memory(tmp_path: Path) -> None:
    tables = Tables(tmp_path)
    for letter in "abcdefgh":
        tables.add("keyframes", pa.table({"newest": [letter * 3_000_000]}))
        tables.add("ahrs", pa.table({"roll_rad": [0.5]}))
    assert (tmp_path / "keyframes.parquet").exists()
    assert not (tmp_path / "ahrs.parquet").exists()  # numbers wait for more: small groups pack badly
    tables.close()
    assert pq.read_table(tmp_path / "keyframes.parquet").num_rows == 8


@pytest.mark.uncounted
def test_key_frames_lead_to_a_place_with_the_newest_samples_before_it(tmp_path: Path) -> None:
    received = b"".join(mixed_frames(9000, seed=1))
    plain = recording(received, chunk=60)
    path = tmp_path / "recordings" / "20260131T120000Z.mcap"
    path.parent.mkdir()
    path.write_bytes(plain)
    said = [(one.channel, one.t_ns, one.data) for one in walk(path) if isinstance(one, Message)]
    for data in (plain, packed(said)):
        folder = made(tmp_path, data).folder
        keys = rows(folder, "keyframes")
        times = [key["t_ns"] for key in keys]
        assert len(keys) > 10
        assert all(EVERY_NS <= after - before < EVERY_NS * 1.01 for before, after in pairwise(times))
        samples = {name: rows(folder, name) for name in ("ahrs", "gps", "heartbeat")}
        for key in keys:
            items = walk(path, place=key["place"])
            first = next(one for one in items if isinstance(one, Message) and one.t_ns >= key["t_ns"])
            assert first.t_ns == key["t_ns"]
            newest = orjson.loads(key["newest"])
            for name, table_rows in samples.items():
                before = [row for row in table_rows if row["t_ns"] < key["t_ns"]]
                told = newest.get(name)
                assert (told is None) == (not before)
                if before:
                    assert {"t_ns": told["t_ns"], **told["values"]} == before[-1]


def _datagrams(numbers: list[int], count: int, rng: random.Random, wild: float = 0.0) -> list[list[Record]]:
    made = []
    for _ in range(count):
        records = []
        for number in numbers:
            values = [0.0] * 8
            for wanted in XPLANE_ROWS["xp10"][number].values if number in XPLANE_ROWS["xp10"] else ():
                values[wanted.index] = rng.uniform(wanted.minimum, wanted.maximum)
                if rng.random() < wild:
                    values[wanted.index] = rng.choice((-999.0, float("nan"), 1e9, -1e9))
            records.append(Record(number, tuple(values)))
        made.append(records)
    return made


class _Viewer:
    """Hears the samples that the live part makes."""

    def __init__(self) -> None:
        self.t_ns = 0
        self.heard: dict[str, list[dict[str, Any]]] = {"simulator": [], "xplane_info": [], "xplane_rows": []}

    def take(self, topic: str, t_s: float, values: Any, _implausible: Iterable[str] = ()) -> None:
        assert t_s == self.t_ns * 1e-9
        self.heard[topic].append({"t_ns": self.t_ns, **values})


@pytest.mark.parametrize(("wild", "split", "lost"), [(0.0, 11, 0), (0.01, 11, 0), (0.0, 4, 0), (0.0, 11, 7)], ids=str)
def test_the_simulators_topics_have_what_live_shows(tmp_path: Path, wild: float, split: int, lost: int) -> None:
    """Whole frames; some with values that no simulator sends; in several datagrams; rows that come and go."""
    rng = random.Random(5)
    numbers = [3, 4, 6, 8, 11, 16, 17, 18, 20, 25, 99]
    datagrams = []
    for index, records in enumerate(_datagrams(numbers, 300, rng, wild)):
        some = records[:-1] if lost and index // 40 % 2 else records
        for first in range(0, len(some), split):
            t_ns = START_NS + index * 20_000_000 + first * 100_000
            datagrams.append((t_ns, build(some[first : first + split], 0x40)))
    datagrams.insert(50, (datagrams[50][0], b"no datagram"))
    viewer = _Viewer()
    samples = SimulatorSamples(viewer)
    data = opening("test 1.0", TOPICS)
    for t_ns, datagram in datagrams:
        data += message_record(SIMULATOR_RECEIVED, 0, t_ns, datagram)
        viewer.t_ns = t_ns
        reading = samples.read(datagram, t_ns * 1e-9)
        if reading is not None:
            samples.show(reading)
    folder = made(tmp_path, data).folder
    assert len(viewer.heard["simulator"]) > 200
    assert rows(folder, "simulator") == viewer.heard["simulator"]
    assert rows(folder, "xplane_info") == viewer.heard["xplane_info"]
    told: dict[int, dict[str, Any]] = {}
    for row in rows(folder, "xplane_rows"):
        told.setdefault(row["t_ns"], {})[str(row["row"])] = [row[f"value_{slot}"] for slot in range(8)]
    expected = {
        one["t_ns"]: {
            row: [None if value == -999.0 else value for value in eight] for row, eight in one["rows"].items()
        }
        for one in viewer.heard["xplane_rows"]
    }
    described = pq.read_schema(folder / "xplane_rows.parquet").metadata[b"description"]
    assert b"thinned" in described
    assert repr(told) == repr(expected), "as text, for there are values that are not equal to themselves"


def test_index_says_its_progress_and_what_it_counted(tmp_path: Path) -> None:
    path = tmp_path / "recordings" / "20260131T120000Z.mcap"
    path.parent.mkdir()
    path.write_bytes(recording(b"".join(mixed_frames(400, seed=1))))
    said: list[tuple[float, str]] = []
    done = run([str(path)], lambda progress, doing: said.append((progress, doing)))
    assert said[-1][0] > 0.9
    assert done["frames"] == 400
    assert Path(str(done["folder"])).is_dir()


def test_commands_and_messages_of_one_name_are_kept_apart() -> None:
    assert {message.name for message in TELEMETRY.values()} & set(COMMANDS)
    assert Frames._fields == ("t_ns", "payload")
