"""A packed recording is the same recording: every byte, time, channel, note and their order."""

from __future__ import annotations

import os
import random
import subprocess
import sys
from io import BytesIO
from pathlib import Path

import pytest
from mcap.reader import make_reader

from epf_gcs.recordings import packed_file
from epf_gcs.recordings.limits import RecordingError
from epf_gcs.recordings.mcap_file import Tally, closing, data_end, message_record, metadata_record, opening
from epf_gcs.recordings.notes import MARK, written
from epf_gcs.recordings.packing import PackingCancelledError, pack
from epf_gcs.recordings.reading import notes_of, read_file, walk
from epf_gcs.recordings.topics import TOPICS

NAME = "20260101T000000Z.mcap"
START_NS = 1_700_000_000_000_000_000


def a_recording(count: int = 3000, *, notes_every: int = 700) -> bytes:
    rng, tally = random.Random(7), Tally()
    data = opening("test 1.0", TOPICS) + metadata_record("board_link", {"url": "tcp://h:1"})
    tally.metadata_count = 1
    for index in range(count):
        time_ns, topic = START_NS + 1_000_000 * index, rng.choice(list(TOPICS))
        payload = rng.randbytes(rng.choice([0, 1, 20, 300]))
        data += message_record(topic, tally.add(topic, time_ns), time_ns, payload)
        if index % notes_every == 0:
            data += metadata_record(MARK, written(time_ns, {"text": f"mark {index}", "by": None, "id": str(index)}))
            tally.metadata_count += 1
    end = data_end()
    return data + end + closing(TOPICS, tally, len(data) + len(end))


@pytest.fixture
def raw(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A finished recording, and chunks small enough that it has many."""
    monkeypatch.setattr(packed_file, "_CHUNK_BYTES", 20_000)
    path = tmp_path / NAME
    path.write_bytes(a_recording())
    return path


def content(path: Path) -> list[object]:
    return list(walk(path))


def test_every_message_and_note_is_what_and_where_it_was(raw: Path) -> None:
    before, size = content(raw), raw.stat().st_size
    os.utime(raw, ns=(1, 2_000_000_000))
    told: list[float] = []
    packed = pack(raw, progress=told.append)
    assert content(raw) == before
    assert (packed.bytes_before, packed.bytes_after) == (size, raw.stat().st_size)
    assert (packed.messages, packed.notes, packed.damage) == (3000, 6, None)
    assert raw.stat().st_mtime_ns == 2_000_000_000
    assert told == sorted(told)
    assert told[-1] == 1.0
    assert [*raw.parent.iterdir()] == [raw]


def test_the_library_reads_it_by_its_indexes(raw: Path) -> None:
    before = [(one.topic, one.t_ns, one.data) for one in _by_library(raw)]
    pack(raw)
    assert [(one.topic, one.t_ns, one.data) for one in _by_library(raw)] == before
    reader = make_reader(BytesIO(raw.read_bytes()), validate_crcs=True)
    summary = reader.get_summary()
    assert summary is not None
    assert summary.statistics is not None
    assert summary.statistics.message_count == 3000
    assert summary.statistics.metadata_count == 6
    assert summary.statistics.chunk_count == len(summary.chunk_indexes) > 10
    assert (summary.statistics.message_start_time, summary.statistics.message_end_time) == (
        START_NS,
        START_NS + 2999 * 1_000_000,
    )
    assert [note.name for note in reader.iter_metadata()] == ["board_link"] + [MARK] * 5
    from_ns, to_ns = START_NS + 1_500_000_000, START_NS + 1_600_000_000
    found = [message.log_time for _, _, message in reader.iter_messages(starting_at=from_ns, ending_before=to_ns)]
    assert found == list(range(from_ns, to_ns, 1_000_000))


class _Read:
    def __init__(self, topic: str, t_ns: int, data: bytes) -> None:
        self.topic, self.t_ns, self.data = topic, t_ns, data


def _by_library(path: Path) -> list[_Read]:
    reader = make_reader(BytesIO(path.read_bytes()), validate_crcs=True)
    return [_Read(channel.topic, message.log_time, message.data) for _, channel, message in reader.iter_messages()]


def test_a_message_larger_than_a_chunk_has_one_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(packed_file, "_CHUNK_BYTES", 100)
    path = tmp_path / NAME
    path.write_bytes(a_recording(40))
    before = content(path)
    pack(path)
    assert content(path) == before


def test_packing_again_changes_nothing(raw: Path) -> None:
    pack(raw)
    before = raw.read_bytes()
    pack(raw)
    assert raw.read_bytes() == before


def test_a_recording_without_messages_keeps_its_notes(tmp_path: Path) -> None:
    path = tmp_path / NAME
    path.write_bytes(a_recording(0))
    pack(path)
    assert [note.content for note in notes_of(path)] == [{"url": "tcp://h:1"}]


@pytest.mark.parametrize("cut", [1, 40, 5000])
def test_one_that_is_unfinished_is_left_alone(raw: Path, cut: int) -> None:
    raw.write_bytes(raw.read_bytes()[:-cut])
    before = raw.read_bytes()
    with pytest.raises(RecordingError, match="unfinished or damaged"):
        pack(raw)
    assert raw.read_bytes() == before
    assert [*raw.parent.iterdir()] == [raw]


def test_with_a_target_whatever_can_be_read_is_packed(raw: Path) -> None:
    raw.write_bytes(raw.read_bytes()[:-5000])
    target = raw.with_name("20260101T000000Z-2.mcap")
    pack(raw, target)
    assert content(target) == content(raw)
    assert read_file(target).is_whole
    with pytest.raises(FileExistsError):
        pack(raw, target)


def test_what_does_not_read_back_as_it_was_takes_nothing_s_place(raw: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    before = raw.read_bytes()
    put = packed_file.PackedFile.put

    def damage(self: packed_file.PackedFile, records: object, at: object, messages: object) -> None:
        if len(records):  # type: ignore[arg-type]
            records[-1] ^= 1  # type: ignore[index]
        put(self, records, at, messages)  # type: ignore[arg-type]

    monkeypatch.setattr(packed_file.PackedFile, "put", damage)
    with pytest.raises(RecordingError, match="read back"):
        pack(raw)
    assert raw.read_bytes() == before
    assert [*raw.parent.iterdir()] == [raw]


def test_a_recording_that_grows_meanwhile_is_not_replaced(raw: Path) -> None:
    def grow(share: float) -> None:
        if share == 1.0:
            with raw.open("ab") as file:
                file.write(b"more")

    with pytest.raises(RecordingError, match="changed"):
        pack(raw, progress=grow)
    assert raw.read_bytes().endswith(b"more")


@pytest.mark.parametrize("steps", [0, 3, 9])
def test_cancelled_it_leaves_no_trace(raw: Path, steps: int) -> None:
    before, left = raw.read_bytes(), iter([False] * steps + [True] * 1000)
    with pytest.raises(PackingCancelledError):
        pack(raw, is_over=lambda: next(left))
    assert raw.read_bytes() == before
    assert [*raw.parent.iterdir()] == [raw]


KILLED = """
import os, sys
from pathlib import Path
from epf_gcs.recordings import packed_file, packing
packed_file._CHUNK_BYTES = 20_000
left = int(sys.argv[2])
def count(original):
    def counted(*args, **named):
        global left
        left -= 1
        if left < 0:
            os._exit(9)
        return original(*args, **named)
    return counted
packed_file.PackedFile._put = count(packed_file.PackedFile._put)
os.fsync = count(os.fsync)
os.utime = count(os.utime)
Path.replace = count(Path.replace)
packing.sync_folder = count(packing.sync_folder)
packing.pack(Path(sys.argv[1]))
"""


def test_a_kill_at_any_step_leaves_the_old_file_or_the_new_one(raw: Path) -> None:
    before, after = raw.read_bytes(), raw.with_name("packed")
    messages = content(raw)
    pack(raw, after)
    packed = after.read_bytes()
    after.unlink()
    ends = set()
    for step in [0, 1, 5, 50, *range(95, 130, 2), 200]:
        raw.write_bytes(before)
        subprocess.run([sys.executable, "-c", KILLED, str(raw), str(step)], check=False, capture_output=True)
        now = raw.read_bytes()
        assert now in (before, packed), f"after {step} steps"
        ends.add(now == packed)
        assert content(raw) == messages
    assert ends == {False, True}
