"""Recordings read back: whole, growing, cut at any byte, packed, damaged, and made by strangers."""

from __future__ import annotations

import random
import struct
from contextlib import suppress
from io import BytesIO
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from mcap.opcode import Opcode
from mcap.records import ChunkIndex
from mcap.stream_reader import StreamReader
from mcap.writer import CompressionType, IndexType

from epf_gcs.recordings import reading
from epf_gcs.recordings.mcap_file import MAGIC, message_record, metadata_record, opening
from epf_gcs.recordings.notes import MARK, Note
from epf_gcs.recordings.reading import Limits, Reader, RecordingError, notes_of, read_file, walk
from epf_gcs.recordings.topics import TOPICS
from tests.recordings.files import EVERY_NS, START_NS, Said, heard, mark, messages, packed, plain, said_by


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "20260131T120000Z.mcap"


def test_a_finished_file_gives_every_message_and_note(path: Path) -> None:
    said = messages(3000)
    path.write_bytes(b"".join(plain(said, mark_every=100)))
    recording = read_file(path)
    assert said_by(recording) == said
    assert heard(walk(path)) == said
    assert (recording.is_whole, recording.damage, recording.topics) == (True, None, TOPICS)
    assert [note.t_ns for note in recording.notes] == [START_NS + index * 100 * EVERY_NS for index in range(30)]
    assert notes_of(path) == recording.notes


def test_notes_are_walked_where_they_were_written(path: Path) -> None:
    said = messages(500)
    path.write_bytes(b"".join(plain(said, mark_every=7)))
    items = list(walk(path))
    for item, following in pairwise(items):
        if isinstance(item, Note):
            assert following.t_ns == item.t_ns, "each mark was written before the message of its time"
    assert sum(isinstance(item, Note) for item in items) == 72


@pytest.mark.uncounted
def test_a_file_cut_at_any_byte_opens_with_every_whole_record(path: Path) -> None:
    said = messages(9)
    body, end = plain(said, mark_every=4)
    whole = body + end
    edges = []  # where each message ends
    at = len(opening("test 1.0", TOPICS))
    for index, (channel, t_ns, payload) in enumerate(said):
        at += len(mark(t_ns, str(index))) if index % 4 == 0 else 0
        at += len(message_record(channel, 0, t_ns, payload))
        edges.append(at)
    for size in range(len(whole) + 1):
        path.write_bytes(whole[:size])
        recording = read_file(path)
        expected = said[: sum(edge <= size for edge in edges)]
        assert said_by(recording) == expected, size
        assert heard(walk(path)) == expected, size
        assert recording.is_whole == (size == len(whole)), size
        assert recording.damage is None, size


@pytest.mark.uncounted
def test_a_large_file_cut_at_a_thousand_places_opens_with_every_whole_record(
    path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("epf_gcs.recordings.parts._BLOCK_BYTES", 20_000)
    said = messages(5_000)
    whole = b"".join(plain(said, mark_every=500))
    path.write_bytes(whole)
    everything = read_file(path).messages
    ends = everything.start + everything.length
    # Where the messages are does not depend on the blocks; how many are whole is counted in the uncut file.
    offsets = []
    reader = Reader(path)
    for part in reader.parts():
        offsets += (part.messages.start + part.messages.length + part.place).tolist()
    assert len(offsets) == len(ends) == 5_000
    rng = random.Random(4)
    sizes = sorted((rng.randrange(len(whole)) for _ in range(1000)), reverse=True)
    with path.open("r+b") as file:
        for size in sizes:
            file.truncate(size)
            count = sum(len(part.messages.channel) for part in Reader(path).parts())
            assert count == sum(offset <= size for offset in offsets), size


@pytest.mark.parametrize(
    "options",
    [
        {},
        {"compression": CompressionType.NONE},
        {"use_chunking": False},
        {"use_statistics": False, "use_summary_offsets": False, "repeat_channels": False},
        {"index_types": IndexType.NONE},
        {"enable_crcs": False},
    ],
    ids=["zstd", "chunks unpacked", "no chunks", "no summary", "no index", "no checksums"],
)
def test_what_the_mcap_library_writes_is_read(path: Path, options: dict[str, Any]) -> None:
    said = messages(3000)
    path.write_bytes(packed(said, **options))
    recording = read_file(path)
    assert said_by(recording) == said
    assert (recording.is_whole, recording.damage) == (True, None)
    assert heard(walk(path)) == said
    assert heard(walk(path, START_NS + 1500 * EVERY_NS)) == said[1500:]


def test_a_packed_file_cut_anywhere_gives_what_came_of_its_last_chunk_too(path: Path) -> None:
    said = messages(20_000)
    whole = packed(said, chunk_size=2_000_000)
    counts = []
    for size in range(8, len(whole), 17_011):
        path.write_bytes(whole[:size])
        read = said_by(read_file(path))
        assert read == said[: len(read)], size
        counts.append(len(read))
    assert counts == sorted(counts)
    assert len(set(counts)) > 5, "more than none or all of the one chunk"


@pytest.mark.uncounted
def test_a_small_packed_file_cut_at_any_byte_and_a_large_one_at_a_thousand_places(path: Path) -> None:
    small, large = messages(40), messages(1_500)
    rng = random.Random(6)
    for said, whole in ((small, packed(small, chunk_size=400)), (large, packed(large, chunk_size=6_000))):
        chunks = _chunk_ends(whole)
        count = min(1000, len(whole))
        for size in range(len(whole)) if said is small else sorted(rng.sample(range(len(whole)), count)):
            path.write_bytes(whole[:size])
            read = said_by(read_file(path))
            assert read == said[: len(read)], size
            assert len(read) >= max([held for end, held in chunks if end <= size], default=0), size


def _chunk_ends(whole: bytes) -> list[tuple[int, int]]:
    """Where each chunk ends, and how many messages the file holds up to there."""
    found, count, at = [], 0, len(MAGIC)
    while whole[at] != Opcode.DATA_END:
        opcode, length = struct.unpack_from("<BQ", whole, at)
        at += 9 + length
        if opcode == Opcode.CHUNK:
            found.append((at, 0))
        elif opcode == Opcode.MESSAGE_INDEX:
            # An entry of 16 bytes for each message of the channel.
            count += (length - 6) // 16
            found[-1] = (found[-1][0], count)
    return found


def test_a_second_recording_behind_the_end_of_the_first_is_told(path: Path) -> None:
    said = messages(50)
    for whole in (b"".join(plain(said)), packed(said, chunk_size=400)):
        for more in (whole, bytes(20) + MAGIC, b"x" * 9):
            path.write_bytes(whole + more)
            recording = read_file(path)
            assert said_by(recording) == said
            assert recording.damage == "The file goes on after its end, what follows was not read."
        path.write_bytes(whole)
        assert read_file(path).damage is None


def test_the_index_spares_reading_what_is_before(path: Path) -> None:
    said = messages(20_000)
    path.write_bytes(packed(said))
    reader = Reader(path)
    first = next(iter(reader.items(START_NS + 19_000 * EVERY_NS)))
    assert first == said[19_000]
    assert reader.place > path.stat().st_size * 0.8


def test_an_index_that_lies_costs_time_and_no_message(path: Path) -> None:
    said = messages(3000)
    whole = packed(said)
    for lie in (0, 100, len(whole) + 5, 2**63):
        index = whole.rindex(struct.pack("<QQ", *_chunk_times(whole)[-1]))
        path.write_bytes(whole[: index + 16] + struct.pack("<Q", lie) + whole[index + 24 :])
        assert heard(walk(path, said[-1][1])) == said[-1:]
    # The first chunk's times at the place of another chunk.
    earlier = [part.place for part in _parts_of(path, whole)][3]
    index = whole.rindex(struct.pack("<QQ", *_chunk_times(whole)[0]))
    path.write_bytes(whole[: index + 16] + struct.pack("<Q", earlier) + whole[index + 24 :])
    assert heard(walk(path, START_NS + 5 * EVERY_NS)) == said[5:]


def _chunk_times(whole: bytes) -> list[tuple[int, int]]:
    found = [record for record in StreamReader(BytesIO(whole)).records if isinstance(record, ChunkIndex)]
    return [(one.message_start_time, one.message_end_time) for one in found]


def test_each_part_gives_the_place_to_begin_at(path: Path) -> None:
    said = messages(2000)
    for whole in (b"".join(plain(said, mark_every=50)), packed(said)):
        path.write_bytes(whole)
        index = 0
        for part in Reader(path).parts():
            for number in range(0, len(part.messages.channel), 111):
                rest = heard(walk(path, place=reading.place_of(part, number)))
                assert rest == said[-len(rest) :]
                missed = len(said) - len(rest)
                assert missed == index + (0 if part.is_chunk else number)
            index += len(part.messages.channel)


def test_a_growing_file_is_read_on_from_where_it_ended(path: Path) -> None:
    said = messages(300)
    body, end = plain(said)
    reader = Reader(path)
    read: list[Said] = []
    path.write_bytes(b"")
    for begin in range(0, len(body), 700):
        with path.open("ab") as file:
            file.write(body[begin : begin + 700])
        read += heard(reader.items())
        assert not reader.is_whole
    assert read == said
    with path.open("ab") as file:
        file.write(end)
    assert list(reader.items()) == []
    assert reader.is_whole


def test_zeros_at_the_end_are_told(path: Path) -> None:
    said = messages(50)
    path.write_bytes(plain(said)[0] + bytes(10_000))
    recording = read_file(path)
    assert said_by(recording) == said
    assert recording.damage == "The file ends in 10000 zero bytes."


RUBBISH = [b"\x77" * 40, b"\x05" + b"\xff" * 8, b"\x05" + struct.pack("<Q", 3) + b"abc", bytes(50) + b"x"]


@pytest.mark.parametrize("rubbish", RUBBISH)
def test_damage_is_told_and_what_was_before_it_stands(path: Path, rubbish: bytes) -> None:
    said = messages(50)
    body = plain(said)[0]
    path.write_bytes(body + rubbish)
    recording = read_file(path)
    assert said_by(recording) == said
    assert recording.damage == f"Byte {len(body)} begins no record, what follows it was not read."


def test_a_damaged_chunk_costs_that_chunk_alone(path: Path) -> None:
    said = messages(3000)
    whole = bytearray(packed(said))
    place = next(part.place for part in _parts_of(path, bytes(whole)) if part.messages.t_ns[0] > START_NS)
    whole[place + 9 + 60] ^= 0xFF
    path.write_bytes(whole)
    recording = read_file(path)
    read = said_by(recording)
    assert len(said) - 200 < len(read) < len(said)
    assert set(read) <= set(said)
    assert read[-1] == said[-1]
    assert recording.damage is not None
    assert "chunk" in recording.damage


def _parts_of(path: Path, data: bytes) -> list[reading.Part]:
    path.write_bytes(data)
    return list(Reader(path).parts())


def test_old_notes_get_the_time_of_the_message_before_them(path: Path) -> None:
    old = metadata_record("board_link", {"url": "tcp://h:1"})
    body = opening("test 1.0", TOPICS) + old + message_record(1, 0, 5000, b"a") + old + message_record(1, 1, 6000, b"b")
    path.write_bytes(body)
    content = {"url": "tcp://h:1"}
    assert read_file(path).notes == [Note(5000, "board_link", content), Note(5000, "board_link", content)]


def test_a_note_that_cannot_be_read_is_told(path: Path) -> None:
    bad = bytearray(metadata_record(MARK, {"t_ns": "1"}))
    bad[9:13] = struct.pack("<I", 2**31)
    path.write_bytes(opening("x", TOPICS) + bytes(bad) + message_record(1, 0, 5, b"a"))
    recording = read_file(path)
    assert (recording.notes, recording.damage) == ([], "A note cannot be read.")
    assert len(recording.messages.channel) == 1


def test_a_clock_that_runs_backwards_is_counted_and_an_impossible_time_left_out(path: Path) -> None:
    times = [9000, 8000, 8000, 7000, 2**63, 9500]
    records = b"".join(message_record(1, 0, t_ns, bytes([index])) for index, t_ns in enumerate(times))
    path.write_bytes(opening("x", TOPICS) + records)
    recording = read_file(path)
    assert [t_ns for _, t_ns, _ in said_by(recording)] == [9000, 8000, 8000, 7000, 9500]
    assert recording.clock_steps == 2
    assert recording.damage == "A message has a time that no clock gives, it was left out."


def _refused(path: Path, data: bytes, limits: Limits = reading.LIMITS) -> str:
    path.write_bytes(data)
    with pytest.raises(RecordingError) as bulk:
        read_file(path, limits=limits)
    with pytest.raises(RecordingError) as stream:
        list(walk(path, limits=limits))
    assert bulk.value.code == stream.value.code
    assert bulk.value.detail.endswith(".")
    return bulk.value.code


def test_files_of_strangers_are_refused_with_a_sentence(path: Path) -> None:
    assert _refused(path, b"PK\x03\x04 something else") == "recording_foreign"
    channel = opening("x", {1: "camera"})
    end = plain([])[1]
    assert _refused(path, channel + message_record(1, 0, 5, b"a") + end) == "recording_foreign"
    two = opening("x", TOPICS) + opening("x", {8: TOPICS[1]})[len(MAGIC) :]
    assert _refused(path, two + message_record(8, 0, 5, b"a")) == "recording_two_boards"
    body = struct.pack("<QQQI", 1, 2, 3, 0) + struct.pack("<I", 3) + b"lz4" + struct.pack("<Q", 3) + b"abc"
    named = opening("x", TOPICS) + b"\x06" + struct.pack("<Q", len(body)) + body
    assert _refused(path, named) == "recording_packing_unknown"


def test_limits_hold_whatever_a_file_claims(path: Path) -> None:
    said = messages(2000)
    whole = b"".join(plain(said, mark_every=2))
    assert _refused(path, whole, Limits(messages=1999)) == "recording_too_large"
    assert _refused(path, whole, Limits(notes=999)) == "recording_too_large"
    zipped = packed([(1, START_NS, bytes(1_000_000))] * 20, chunk_size=20_000_000)
    assert len(zipped) < 100_000
    assert _refused(path, zipped, Limits(chunk_bytes=10_000_000)) == "recording_too_large"
    assert _refused(path, packed(said), Limits(unpacked_bytes=10_000)) == "recording_too_large"
    path.write_bytes(whole)
    with pytest.raises(RecordingError):
        read_file(path, limits=Limits(whole_bytes=1000))
    assert heard(walk(path, limits=Limits(whole_bytes=1000))) == said


def test_a_chunk_unpacks_to_no_more_than_it_claims(path: Path) -> None:
    zipped = packed([(1, START_NS, bytes(1_000_000))] * 20, chunk_size=20_000_000)
    head = zipped.index(struct.pack("<QQ", START_NS, START_NS)) + 16
    path.write_bytes(zipped[:head] + struct.pack("<Q", 3_000_000) + zipped[head + 8 :])
    recording = read_file(path)
    assert len(recording.messages.data) <= 3_000_000
    assert recording.damage is not None


def test_no_bytes_make_it_fail_in_another_way(path: Path) -> None:
    rng = random.Random(9)
    for seed in range(100):
        whole = bytearray(packed(messages(60, seed), chunk_size=900) if seed % 2 else b"".join(plain(messages(60), 9)))
        for _ in range(rng.randrange(1, 6)):
            whole[rng.randrange(8, len(whole))] = rng.choice((0, 255, rng.randrange(256)))
        path.write_bytes(whole)
        with suppress(RecordingError):
            heard(walk(path))
        with suppress(RecordingError):
            said_by(read_file(path))
        with suppress(RecordingError):
            heard(walk(path, START_NS + 30 * EVERY_NS))
