"""Recordings after a kill or a power cut: cut at the last whole record and given their end, or left alone."""

from __future__ import annotations

import os
import struct
import time
from contextlib import suppress
from io import BytesIO
from pathlib import Path

import pytest
import structlog
from hypothesis import given
from hypothesis import strategies as st
from mcap.opcode import Opcode
from mcap.reader import make_reader
from mcap.records import Message, Metadata
from mcap.stream_reader import StreamReader

from epf_gcs.flight.recording import repair as repair_module
from epf_gcs.flight.recording.repair import BeyondRepairError, recordings_in, repair, repair_all
from epf_gcs.recordings.mcap_file import Tally, closing, data_end, message_record, metadata_record, opening
from epf_gcs.recordings.notes import REPAIRED, written
from epf_gcs.recordings.packing import pack
from epf_gcs.recordings.reading import read_file

TOPICS = {1: "board/received", 2: "board/sent"}
NAME = "20260101T000000Z.mcap"


@pytest.fixture(autouse=True)
def this_process_stays_in_its_place(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whoever has gone last stays there: all later tests of this worker would, and the stations that they start."""
    monkeypatch.setattr(repair_module, "go_last", lambda: None)


def a_recording(payloads: list[bytes]) -> tuple[bytes, bytes, int]:
    """Head with messages, end, and where the messages begin."""
    tally = Tally()
    head = opening("test 1.0", TOPICS)
    data = head + metadata_record("board_link", {"url": "tcp://h:1"})
    tally.metadata_count = 1
    for index, payload in enumerate(payloads):
        time_ns = 1_000 + index
        data += message_record(1, tally.add(1, time_ns), time_ns, payload)
    end = data_end()
    return data, end + closing(TOPICS, tally, len(data) + len(end)), len(head)


def repaired(data: bytes, cut: int, last_ns: int = 1_000, notes: int = 1, messages: int = 1) -> bytes:
    """These records of a recording with the note and the end that its repair adds."""
    data += metadata_record(REPAIRED, written(last_ns, {"bytes_cut": cut}))
    tally = Tally({1: messages}, notes + 1, 1_000, last_ns)
    end = data_end()
    return data + end + closing(TOPICS, tally, len(data) + len(end))


def payloads(data: bytes) -> list[bytes]:
    return [record.data for record in StreamReader(BytesIO(data)).records if isinstance(record, Message)]


def test_a_link_out_of_the_folder_and_a_pipe_are_left_as_they_are(tmp_path: Path) -> None:
    data, _, _ = a_recording([b"one"])
    foreign = tmp_path / "foreign.mcap"
    foreign.write_bytes(data)
    folder = tmp_path / "recordings"
    folder.mkdir()
    (folder / "20260101T000001Z.mcap").symlink_to(foreign)
    (folder / "20260101T000002Z.mcap").symlink_to("/dev/null")
    os.mkfifo(folder / "20260101T000003Z.mcap")
    (folder / "20260101T000004Z.mcap").write_bytes(data)
    there = set(folder.iterdir())
    assert [path.name for path in recordings_in(folder)] == ["20260101T000004Z.mcap"]
    for path in there:
        with suppress(OSError):
            repair(path)
    assert foreign.read_bytes() == data
    assert set(folder.iterdir()) == there
    assert (folder / "20260101T000004Z.mcap").read_bytes() != data, "its own recording is repaired"


def test_a_file_that_was_cut_anywhere_is_mended_up_to_its_last_whole_record(tmp_path: Path) -> None:
    data, end, first = a_recording([b"one", b"two", b"three"])
    path = tmp_path / NAME
    counts = []
    for size in range(first, len(data + end)):
        path.write_bytes((data + end)[:size])
        assert repair(path) is not None
        mended = path.read_bytes()
        read = payloads(mended)
        counts.append(len(read))
        summary = make_reader(BytesIO(mended)).get_summary()
        assert summary is not None
        assert summary.statistics is not None
        assert summary.statistics.message_count == len(read)
        assert repair(path) is None, "there is nothing left to do"
    assert counts == sorted(counts)
    assert (counts[0], counts[-1]) == (0, 3)
    assert path.read_bytes() == data + end, "what lacked only its last byte is as it would have been"


def test_what_was_cut_off_is_noted_in_the_recording_and_a_missing_summary_is_no_damage(tmp_path: Path) -> None:
    data, end, _ = a_recording([b"one", b"two"])
    path = tmp_path / NAME
    path.write_bytes(data[:-2])
    cut = repair(path)
    assert [note.content for note in read_file(path).notes if note.name == REPAIRED] == [{"bytes_cut": cut}]
    for size in range(len(data), len(data + end)):
        path.write_bytes((data + end)[:size])
        assert repair(path) is not None
        assert path.read_bytes() == data + end


def test_the_notes_stay(tmp_path: Path) -> None:
    data, _, _ = a_recording([b"one"])
    path = tmp_path / NAME
    path.write_bytes(data)
    repair(path)
    records = StreamReader(BytesIO(path.read_bytes())).records
    assert [r.metadata for r in records if isinstance(r, Metadata)] == [{"url": "tcp://h:1"}]


def test_zeros_after_a_power_cut_are_cut_off(tmp_path: Path) -> None:
    data, _, _ = a_recording([b"one"])
    path = tmp_path / NAME
    path.write_bytes(data + bytes(5000))
    assert repair(path) == 5000
    assert path.read_bytes() == repaired(data, 5000)


@pytest.mark.parametrize("torn_at", range(1, 8))
def test_a_last_message_whose_end_became_zeros_is_not_taken_for_one(tmp_path: Path, torn_at: int) -> None:
    """A power cut leaves zeros from some byte on; a datagram has no checksum that would tell."""
    data, _, _ = a_recording([b"one", b"datagram"])
    whole, _, _ = a_recording([b"one"])
    path = tmp_path / NAME
    path.write_bytes(data[: torn_at - 8] + bytes(5000))
    cut = repair(path)
    assert cut is not None
    assert path.read_bytes() == repaired(whole, cut)


def test_a_message_that_ends_in_zeros_stays_where_another_follows_or_the_file_just_ends(tmp_path: Path) -> None:
    path = tmp_path / NAME
    for behind, said in (([b"two"], bytes(100)), ([], b"")):
        data, end, _ = a_recording([b"one", b"zeros\0\0", *behind])
        path.write_bytes(data + said)
        repair(path)
        messages = 2 + len(behind)
        mended = repaired(data, len(said), 999 + messages, messages=messages) if said else data + end
        assert path.read_bytes() == mended


def test_a_whole_file_is_not_touched(tmp_path: Path) -> None:
    data, end, _ = a_recording([b"one"])
    path = tmp_path / NAME
    path.write_bytes(data + end)
    before = path.stat().st_mtime_ns
    assert repair(path) is None
    assert path.stat().st_mtime_ns == before


@given(st.binary(min_size=1, max_size=200))
def test_no_file_makes_it_fail_in_another_way(tmp_path_factory: pytest.TempPathFactory, rubbish: bytes) -> None:
    data, _, _ = a_recording([b"one"])
    path = tmp_path_factory.mktemp("any") / NAME
    for content in (rubbish, data + rubbish):
        path.write_bytes(content)
        try:
            repair(path)
        except BeyondRepairError:
            assert path.read_bytes() == content, "it is left as it is"
        else:
            assert payloads(path.read_bytes())[:1] in ([], [b"one"])


def test_what_is_beyond_repair_is_kept_and_told_and_the_others_are_mended(tmp_path: Path) -> None:
    data, end, _ = a_recording([b"one"])
    (tmp_path / "20260103T000000Z.mcap").write_bytes(b"abc")
    (tmp_path / "20260102T000000Z-2.mcap").write_bytes(data)
    (tmp_path / "20260101T000000Z.mcap").write_bytes(b"")
    (tmp_path / "holiday.mcap").write_bytes(b"")
    with structlog.testing.capture_logs() as logged:
        repair_all(recordings_in(tmp_path))
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == {
        "20260103T000000Z.mcap": b"abc",
        "20260102T000000Z-2.mcap": data + end,
        "holiday.mcap": b"",
    }
    assert [(line["event"], line["file"]) for line in logged] == [
        ("recording damaged, left as it is", "20260103T000000Z.mcap"),
        ("recording repaired", "20260102T000000Z-2.mcap"),
        ("recording repaired", "20260101T000000Z.mcap"),
    ]


def test_it_stops_where_the_flight_ends(tmp_path: Path) -> None:
    data, _, _ = a_recording([b"one"] * 1000)
    path = tmp_path / NAME
    path.write_bytes(data)
    assert repair(path, lambda: True) is None
    repair_all([path], lambda: True)
    assert path.read_bytes() == data


@pytest.mark.parametrize("cut", [0, 1, 30, 300])
def test_a_packed_file_is_never_touched(tmp_path: Path, cut: int) -> None:
    data, end, _ = a_recording([b"one", b"two"] * 100)
    path = tmp_path / NAME
    path.write_bytes(data + end)
    pack(path)
    whole = path.read_bytes()
    content = whole[: len(whole) - cut]
    path.write_bytes(content)
    with structlog.testing.capture_logs() as logged:
        repair_all([path])
    assert path.read_bytes() == content
    assert [line["event"] for line in logged] == ([] if cut == 0 else ["recording damaged, left as it is"])
    assert len(read_file(path).messages.t_ns) == 200, "all its messages can be read all the same"


@pytest.mark.parametrize(
    ("behind", "why"),
    [
        (bytes(3_000_000) + b"x", "something in it that is no record"),
        (b"\x05" + struct.pack("<Q", 2**40) + bytes(100), "something in it that is no record"),
        (b"\x05" + struct.pack("<Q", 3) + b"abc", "a record in it that makes no sense"),
        (b"\x04" + struct.pack("<QHHI", 9, 3, 0, 1) + b"\xff", "a record in it that makes no sense"),
    ],
    ids=["data behind zeros", "endless record", "message of three bytes", "topic that is no text"],
)
def test_what_is_no_torn_end_is_left_as_it_is_and_its_reason_is_told(tmp_path: Path, behind: bytes, why: str) -> None:
    data, _, _ = a_recording([b"one"])
    path = tmp_path / NAME
    path.write_bytes(data + behind)
    with structlog.testing.capture_logs() as logged:
        repair_all([path])
    assert path.read_bytes() == data + behind
    (line,) = logged
    assert (line["event"], line["log_level"]) == ("recording damaged, left as it is", "warning")
    assert why in line["reason"]


def test_a_wrong_length_is_no_torn_end_while_records_stand_behind_it(tmp_path: Path) -> None:
    data, _, first_at = a_recording([b"one", b"two", b"three", b"four", b"five"])
    note = len(metadata_record("board_link", {"url": "tcp://h:1"}))
    damaged = bytearray(data)
    damaged[first_at + note + 2] ^= 0x80  # the second byte of the first message's length
    path = tmp_path / NAME
    path.write_bytes(damaged)
    with pytest.raises(BeyondRepairError, match="something in it that is no record"):
        repair(path)
    assert path.read_bytes() == damaged
    assert len(read_file(path).messages.t_ns) == 4


def test_a_file_that_the_disk_does_not_give_is_told_and_the_next_one_is_mended(tmp_path: Path) -> None:
    data, _, _ = a_recording([b"one"])
    folder = tmp_path / "20260103T000000Z.mcap"
    folder.mkdir()
    torn = tmp_path / NAME
    torn.write_bytes(data + b"\x05\xff")
    with structlog.testing.capture_logs() as logged:
        repair_all([folder, torn])
    assert torn.read_bytes() == repaired(data, 2)
    assert [(line["event"], line.get("reason"), line.get("bytes_cut")) for line in logged] == [
        ("recording not repaired", "Is a directory", None),
        ("recording repaired", None, 2),
    ]


def test_mending_pushes_the_file_to_the_disk_at_the_lowest_priority_and_pauses(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    done: list[str] = []
    monkeypatch.setattr(repair_module, "go_last", lambda: done.append("last"))
    monkeypatch.setattr(time, "sleep", lambda _: done.append("pause"))
    monkeypatch.setattr(os, "fsync", lambda descriptor: done.append(f"push {os.fstat(descriptor).st_size}"))
    data, end, _ = a_recording([b"one"] * 300)
    path = tmp_path / NAME
    path.write_bytes(data)
    repair_all([path])
    assert done == ["last", "pause", "pause", "pause", f"push {len(data + end)}"]


def test_a_record_cut_short_is_cut_off_and_one_longer_than_any_of_ours_is_damage(tmp_path: Path) -> None:
    data, _, _ = a_recording([b"one"])
    longest = 16 * 1024 * 1024
    path = tmp_path / NAME
    path.write_bytes(data + struct.pack("<BQ", Opcode.MESSAGE, longest) + b"its beginning")
    assert repair(path) == 9 + 13
    assert payloads(path.read_bytes()) == [b"one"]
    path.write_bytes(data + struct.pack("<BQ", Opcode.MESSAGE, longest + 1) + b"its beginning")
    with pytest.raises(BeyondRepairError):
        repair(path)
