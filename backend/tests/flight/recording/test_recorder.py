"""The recorder on a real disk, a full one too."""

from __future__ import annotations

import contextlib
import os
import resource
import shutil
import struct
from collections.abc import Iterator
from pathlib import Path

import pytest
import structlog
from mcap.exceptions import EndOfFile
from mcap.records import Message
from mcap.stream_reader import StreamReader

from epf_gcs.contract.answers import DiskPolicy
from epf_gcs.disk import sync_folder
from epf_gcs.flight.clock.line_clock import LineClock
from epf_gcs.flight.recording.recorder import Recorder
from epf_gcs.recordings.notes import LINE, LOST, MARK, REPAIRED
from epf_gcs.recordings.reading import notes_of
from epf_gcs.recordings.topics import TOPICS
from tests.support.waiting import eventually


def messages(path: Path) -> list[tuple[str, bytes]]:
    """What is in a file, also where it ends in the middle of a record: there the library stops with an error."""
    found: list[tuple[str, bytes]] = []
    with path.open("rb") as file, contextlib.suppress(EndOfFile, struct.error):
        records = (record for record in StreamReader(file).records if isinstance(record, Message))
        found.extend((TOPICS[record.channel_id], record.data) for record in records)
    return found


@contextlib.contextmanager
def recording(folder: Path, *, retry_s: float = 0.0) -> Iterator[Recorder]:
    recorder = Recorder(folder, LineClock(), "test", retry_s=retry_s)
    recorder.start()
    try:
        yield recorder
    finally:
        recorder.stop()


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Path]:
    """A folder where no file gets longer than 64 kB."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (65536, hard))
    yield tmp_path
    resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


def test_every_byte_of_both_lines_is_in_the_file_in_order(tmp_path: Path) -> None:
    with recording(tmp_path) as recorder:
        recorder.board_tap.sent(b"#QT\n")
        recorder.board_tap.received(b"\x00\xff")
        recorder.simulator_tap.received(b"DATA@")
        recorder.simulator_tap.sent(b"DATA\x00")
        recorder.board_tap.received(b"")
    (file,) = tmp_path.glob("*.mcap")
    assert messages(file) == [
        ("board/sent", b"#QT\n"),
        ("board/received", b"\x00\xff"),
        ("simulator/received", b"DATA@"),
        ("simulator/sent", b"DATA\x00"),
        ("board/received", b""),
    ]
    assert recorder.bytes_lost == 0


def test_without_a_byte_there_is_no_file(tmp_path: Path) -> None:
    with recording(tmp_path):
        pass
    assert list(tmp_path.iterdir()) == []


def test_what_was_recorded_is_on_the_disk_while_the_flight_goes_on(tmp_path: Path) -> None:
    with recording(tmp_path) as recorder:
        recorder.board_tap.received(b"in flight")
        eventually(lambda: recorder.bytes_written > 0 and recorder.file is not None, "the file is begun")
        file = recorder.file
        assert file is not None
        eventually(lambda: messages(file) == [("board/received", b"in flight")], "the byte is readable")


def test_a_file_cut_anywhere_is_read_up_to_the_cut(tmp_path: Path) -> None:
    with recording(tmp_path) as recorder:
        for index in range(20):
            recorder.simulator_tap.received(b"DATA %d" % index)
    (file,) = tmp_path.glob("*.mcap")
    whole = messages(file)
    data = file.read_bytes()
    cut = tmp_path / "cut"
    counts = []
    for size in range(len(data) // 2, len(data), 7):
        cut.write_bytes(data[:size])
        read = messages(cut)
        # The library hands out the beginning of a message that was cut; all before it are whole.
        assert read[:-1] == whole[: len(read) - 1]
        assert whole[len(read) - 1][1].startswith(read[-1][1])
        counts.append(len(read))
    assert counts == sorted(counts)
    assert counts[-1] == 20


def test_a_session_that_ended_is_followed_by_a_file_of_its_own(tmp_path: Path) -> None:
    with recording(tmp_path) as recorder:
        recorder.board_tap.received(b"one")
        recorder.end_session()
        recorder.board_tap.received(b"two")
    first, second = sorted(tmp_path.glob("*.mcap"), key=lambda file: file.stat().st_mtime_ns)
    contents = sorted([messages(first), messages(second)])
    assert contents == [[("board/received", b"one")], [("board/received", b"two")]]


def test_notes_are_in_the_file(tmp_path: Path) -> None:
    with recording(tmp_path) as recorder:
        recorder.know(LINE, "board", 5, {"line": "board", "open": True})
        recorder.know(LINE, "board", 6, {"line": "board", "open": True})
        recorder.board_tap.received(b"x")
        eventually(lambda: recorder.file is not None, "it records")
        recorder.note(MARK, 7, {"text": "aquí", "by": None, "id": "1"})
        recorder.end_session()
        recorder.board_tap.received(b"y")
    first, second = sorted(tmp_path.glob("*.mcap"), key=lambda file: file.stat().st_mtime_ns)
    assert [note.name for note in notes_of(first)] == [LINE, MARK]
    assert [note.content for note in notes_of(second)] == [{"line": "board", "open": True}], "known from the start"


def test_a_folder_that_cannot_be_written_is_told_and_counted_and_tried_again(tmp_path: Path) -> None:
    folder = tmp_path / "recordings"
    folder.write_text("a file where the folder should be")
    with recording(folder) as recorder:
        recorder.board_tap.received(b"lost")
        eventually(lambda: recorder.failure is not None, "the failure is told")
        eventually(lambda: recorder.bytes_lost == 4, "the bytes are counted")
        folder.unlink()
        recorder.board_tap.received(b"kept")
        eventually(lambda: recorder.failure is None and recorder.file is not None, "it records again")
    (file,) = folder.glob("*.mcap")
    assert messages(file) == [("board/received", b"kept")]


def test_a_full_disk_is_told_and_what_is_on_it_stays_readable(small_disk: Path) -> None:
    with recording(small_disk, retry_s=3600.0) as recorder:
        recorder.board_tap.received(b"before")
        eventually(lambda: recorder.file is not None and recorder.bytes_written > 100, "it records")
        file = recorder.file
        assert file is not None
        for _ in range(100):
            recorder.board_tap.received(b"x" * 1000)
        eventually(lambda: recorder.failure is not None, "the failure is told")
        assert recorder.failure == "File too large"
        recorder.board_tap.received(b"after")
        eventually(lambda: recorder.bytes_lost >= 5, "what came after is counted")
        assert messages(file)[0] == ("board/received", b"before")


def test_a_disk_that_does_not_keep_up_costs_bytes_and_no_memory(tmp_path: Path) -> None:
    recorder = Recorder(tmp_path, LineClock(), "test")  # its thread is not started: it writes nothing
    for _ in range(100_500):
        recorder.board_tap.received(b"x")
    assert recorder.bytes_lost == 500
    recorder.start()
    recorder.stop()


def test_a_folder_that_is_removed_in_flight_is_told_and_the_flight_goes_into_a_new_one(tmp_path: Path) -> None:
    folder = tmp_path / "recordings"
    with recording(folder) as recorder:
        recorder.board_tap.received(b"before")
        eventually(lambda: recorder.file is not None, "it records")
        shutil.rmtree(folder)
        eventually(lambda: "removed" in (recorder.failure or ""), "it is noticed and told")
        recorder.board_tap.received(b"after")
        eventually(lambda: recorder.file is not None, "it records again")
        assert recorder.failure is not None, "it is told long enough to be heard"
    (file,) = folder.glob("*.mcap")
    assert messages(file) == [("board/received", b"after")]


def test_a_folder_that_is_removed_before_its_first_sync_is_told_and_what_it_held_is_counted(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "recordings"

    def removed_just_before(path: Path) -> None:
        monkeypatch.undo()
        shutil.rmtree(path)
        sync_folder(path)

    monkeypatch.setattr("epf_gcs.flight.recording.recording_file.sync_folder", removed_just_before)
    with recording(folder) as recorder:
        recorder.board_tap.received(b"before")
        eventually(lambda: "removed" in (recorder.failure or ""), "it is noticed and told")
        assert recorder.bytes_lost >= len(b"before")
        recorder.board_tap.received(b"after")
        eventually(lambda: recorder.file is not None, "it records again")
    (file,) = folder.glob("*.mcap")
    assert messages(file) == [("board/received", b"after")]


def test_a_loss_that_was_mended_is_not_told_for_ever(tmp_path: Path) -> None:
    recorder = Recorder(tmp_path, LineClock(), "test", told_s=0.0)
    recorder.start()
    recorder.board_tap.received(b"before")
    eventually(lambda: recorder.file is not None, "it records")
    first = recorder.file
    assert first is not None
    first.rename(tmp_path / "moved")
    eventually(lambda: recorder.failure is not None, "it is noticed")
    recorder.board_tap.received(b"after")
    eventually(lambda: recorder.failure is None and recorder.file is not None, "all is well again")
    recorder.stop()
    assert messages(tmp_path / "moved") == [("board/received", b"before")]


def test_a_disk_without_room_gets_no_empty_files(tmp_path: Path) -> None:
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    with recording(tmp_path) as recorder:
        resource.setrlimit(resource.RLIMIT_FSIZE, (0, hard))
        try:
            for count in range(1, 4):
                recorder.board_tap.received(b"lost")
                eventually(lambda count=count: recorder.bytes_lost == 4 * count, "it could not be written")  # type: ignore[misc]
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
        assert recorder.failure is not None
        assert list(tmp_path.iterdir()) == []


def test_a_disk_that_is_nearly_full_is_not_begun_on_and_said_once(tmp_path: Path) -> None:
    with structlog.testing.capture_logs() as logged:
        recorder = Recorder(tmp_path, LineClock(), "test", retry_s=0.0, least_bytes=2**62)
        recorder.start()
        for count in range(1, 4):
            recorder.board_tap.received(b"lost")
            eventually(lambda count=count: recorder.bytes_lost == 4 * count, "it could not be written")  # type: ignore[misc]
        recorder.stop()
    assert f"less than {2**62 // 1_000_000} MB free on the disk" in (recorder.failure or "")
    assert [line["free_megabytes"] < 2**62 // 1_000_000 for line in logged if line["event"] == "disk low"] == [True]
    assert list(tmp_path.iterdir()) == []
    assert [line["event"] for line in logged if line["event"] != "disk low"] == ["recording failed"]


def test_the_log_says_when_a_recording_begins_and_ends(tmp_path: Path) -> None:
    with structlog.testing.capture_logs() as logged, recording(tmp_path) as recorder:
        recorder.board_tap.received(b"x")
    (file,) = tmp_path.glob("*.mcap")
    said = [(line["event"], line["file"]) for line in logged if line["event"] != "disk low"]
    assert said == [("recording begun", file.name), ("recording ended", file.name)]
    assert logged[-1]["bytes"] == file.stat().st_size


def test_what_was_recorded_is_pushed_to_the_disk_in_flight(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pushed: list[int] = []
    push = os.fdatasync

    def note(descriptor: int) -> None:
        push(descriptor)
        pushed.append(os.fstat(descriptor).st_size)

    monkeypatch.setattr(os, "fdatasync", note)
    with recording(tmp_path) as recorder:
        for count in range(1, 4):
            recorder.board_tap.received(b"x")
            eventually(lambda count=count: len(pushed) >= count, "it is pushed")  # type: ignore[misc]
        eventually(lambda: pushed[-1] == recorder.bytes_written, "all of it")


def test_a_torn_recording_is_mended_at_the_start_and_the_new_one_left_alone(tmp_path: Path) -> None:
    with recording(tmp_path) as recorder:
        recorder.board_tap.received(b"before the kill")
    (file,) = tmp_path.glob("*.mcap")
    whole = file.read_bytes()
    torn = tmp_path / "20260101T000000Z.mcap"
    torn.write_bytes(whole[: whole.rindex(b"before the kill") + 15] + b"\x05\xff")
    file.unlink()
    with recording(tmp_path) as recorder:
        recorder.board_tap.received(b"now")
        eventually(lambda: torn.read_bytes().endswith(b"MCAP0\r\n"), "it is mended")
        eventually(lambda: recorder.file is not None, "the new one is begun")
    assert torn.read_bytes().startswith(whole[: whole.rindex(b"before the kill") + 15])
    assert [note.content for note in notes_of(torn) if note.name == REPAIRED] == [{"bytes_cut": 2}]


def test_at_the_policys_limit_recording_stops_unless_older_flights_are_deleted(tmp_path: Path) -> None:
    with recording(tmp_path) as recorder:
        recorder.board_tap.received(b"before")
        eventually(lambda: recorder.file is not None, "it records")
        recorder.policy = DiskPolicy(keep_free_bytes=2**62)
        eventually(lambda: "free on the disk" in (recorder.failure or ""), "the alarm's cause is there")
        recorder.board_tap.received(b"lost")
        eventually(lambda: recorder.bytes_lost == 4, "it is counted")
        recorder.policy = DiskPolicy(delete_oldest=True, keep_free_bytes=2**62)
        recorder.board_tap.received(b"after")
        eventually(lambda: recorder.file is not None, "it records again")
    (lost,) = [note for file in tmp_path.glob("*.mcap") for note in notes_of(file) if note.name == LOST]
    assert lost.content["bytes"] == 4
    assert "free on the disk" in lost.content["reason"]
