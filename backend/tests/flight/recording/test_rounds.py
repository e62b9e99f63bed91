"""Round after round of the recorder's thread, at times and on a disk that the test gives."""

from __future__ import annotations

import os
import shutil
import time
from collections.abc import Callable, Iterator
from io import FileIO
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
import structlog
from mcap.reader import make_reader

from epf_gcs.contract.answers import DiskPolicy
from epf_gcs.flight.clock.line_clock import LineClock
from epf_gcs.flight.recording import recorder as recorder_module
from epf_gcs.flight.recording import recording_file as recording_file_module
from epf_gcs.flight.recording import taps as taps_module
from epf_gcs.flight.recording.recorder import Recorder
from epf_gcs.flight.recording.recording_file import RecordingFile
from epf_gcs.recordings.mcap_file import message_record
from epf_gcs.recordings.notes import EVENT, LINE, LOST, Note
from epf_gcs.recordings.reading import notes_of, read_file
from epf_gcs.recordings.topics import TOPICS
from tests.support.waiting import eventually


class Rounds:
    """A recorder whose thread does not run: the test does what it does."""

    def __init__(self, folder: Path, patch: pytest.MonkeyPatch) -> None:
        self.now_s = 100.0
        self.free = 100_000_000_000
        patch.setattr(recorder_module, "monotonic", lambda: self.now_s)
        patch.setattr(shutil, "disk_usage", lambda _: SimpleNamespace(free=self.free))
        self.folder = folder
        self.recorder = Recorder(folder, LineClock(), "test")

    def at(self, now_s: float, data: bytes = b"") -> Recorder:
        """One round; returns the recorder."""
        self.now_s = now_s
        if data:
            self.recorder.board_tap.received(data)
        self.recorder._write_queue()
        self.recorder._look_after()
        return self.recorder

    def ends(self) -> list[Path]:
        """The session ends; returns all files, the oldest first."""
        self.recorder.end_session()
        self.at(self.now_s)
        return sorted(self.folder.glob("*.mcap"), key=lambda path: (len(path.name), path.name))

    def lost(self) -> list[Note]:
        """The session ends; returns what its files say is missing."""
        return [note for file in self.ends() for note in notes_of(file) if note.name == LOST]


@pytest.fixture
def rounds(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Rounds]:
    made = Rounds(tmp_path / "far" / "recordings", monkeypatch)
    yield made
    made.recorder.end_session()
    made.at(made.now_s)


def test_after_a_failure_a_new_file_is_tried_after_five_seconds_and_says_what_is_missing(rounds: Rounds) -> None:
    rounds.free = 999_999_999
    with structlog.testing.capture_logs() as logged:
        assert rounds.at(100.0, b"lost").failure == "less than 1000 MB free on the disk"
        rounds.free = 1_000_000_000
        assert rounds.at(104.9, b"gone too").file is None
        assert rounds.at(105.0, b"kept").file is not None
    assert rounds.recorder.bytes_lost == 12
    assert rounds.recorder.failure is None
    (low,) = [line for line in logged if line["event"] == "disk low"]
    assert (low["free_megabytes"], low["log_level"]) == (999, "warning")
    rounds.recorder.end_session()
    rounds.at(106.0)
    (file,) = rounds.folder.glob("*.mcap")
    assert [note.content for note in notes_of(file) if note.name == LOST] == [
        {"bytes": 12, "reason": "less than 1000 MB free on the disk"}
    ]


def test_a_low_disk_is_said_each_time_that_it_becomes_low(rounds: Rounds) -> None:
    with structlog.testing.capture_logs() as logged:
        for now_s, free in (
            (100.0, 10**10),
            (101.0, 3_000_000),
            (110.0, 3_000_000),
            (120.0, 10**10),
            (130.0, 5_999_999),
        ):
            rounds.free = free
            rounds.at(now_s, b"data")
    assert [line["free_megabytes"] for line in logged if line["event"] == "disk low"] == [3, 5]


@pytest.mark.parametrize(
    ("keep", "delete", "needed"), [(2 * 10**9, False, 2 * 10**9), (0, False, 2**24), (2 * 10**9, True, 2**24)]
)
def test_a_disk_has_room_from_the_policys_bytes_on_or_from_16_mebibytes(
    rounds: Rounds, keep: int, delete: bool, needed: int
) -> None:
    rounds.recorder.policy = DiskPolicy(delete_oldest=delete, keep_free_bytes=keep)
    rounds.free = needed - 1
    assert f"less than {needed // 1_000_000} MB" in (rounds.at(100.0, b"data").failure or "")
    rounds.free = needed
    assert rounds.at(105.0, b"data").failure is None


def test_the_disk_is_looked_at_five_times_a_second(rounds: Rounds) -> None:
    assert rounds.at(100.0, b"data").failure is None
    rounds.free = 0
    assert rounds.at(100.19).failure is None
    assert rounds.at(100.2).failure is not None


def test_a_file_that_was_moved_is_followed_at_once_by_another_and_told_for_five_seconds(rounds: Rounds) -> None:
    first = rounds.at(100.0, b"data").file
    assert first is not None
    rounds.at(100.3, b"more")
    first.rename(first.with_name("moved"))
    assert rounds.at(101.0, b"unseen").file is None
    assert f"{first.name} was removed or moved" in (rounds.recorder.failure or "")
    assert rounds.recorder.bytes_lost > 0, "what came since the last look may be gone with it"
    assert rounds.at(101.1, b"kept").file is not None
    assert rounds.at(105.9, b"kept").failure is not None
    assert rounds.at(106.0, b"kept").failure is None


def test_the_hours_that_are_left_are_told_after_five_seconds_of_the_file(rounds: Rounds) -> None:
    rounds.recorder.policy = DiskPolicy(keep_free_bytes=20_000_000)
    assert rounds.recorder.hours_left is None
    assert rounds.at(100.0, b"data" * 1000).hours_left is None
    assert rounds.at(104.9, b"data" * 1000).hours_left is None
    rounds.free = 20_000_000 + 3600 * rounds.at(105.0).bytes_written
    assert rounds.at(110.0).hours_left == pytest.approx(10.0)
    rounds.free = 20_000_000
    assert rounds.at(120.0).hours_left == 0.0
    rounds.recorder.end_session()
    assert rounds.at(121.0).hours_left is None


def test_a_file_is_named_by_the_second_of_its_beginning_and_a_second_one_of_it_by_a_number(tmp_path: Path) -> None:
    begun_ns = 1_700_000_000_999_999_999
    names: list[str] = []
    for now_ns in (begun_ns, begun_ns, begun_ns, begun_ns + 1):
        file = RecordingFile(tmp_path, now_ns, "test", TOPICS)
        file.finish()
        names.append(file.path.name)
    assert names == [f"20231114T{end}.mcap" for end in ("221320Z", "221320Z-2", "221320Z-3", "221321Z")]


def test_the_folder_is_pushed_to_the_disk_with_the_first_bytes_of_a_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pushed: list[Path] = []
    monkeypatch.setattr(recording_file_module, "sync_folder", pushed.append)
    file = RecordingFile(tmp_path, 1_700_000_000_000_000_000, "test", TOPICS)
    for _ in range(3):
        file.sync()
        file.sync()
        file.put(b"data")
    file.give_up()
    assert pushed == [tmp_path], "once is enough, and each time makes the disk's thread wait"


def test_what_the_queue_could_not_hold_is_lost_of_either_line(rounds: Rounds, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(taps_module, "_MAX_QUEUED", 0)
    rounds.recorder.board_tap.received(b"four")
    rounds.recorder.simulator_tap.received(b"seven..")
    assert rounds.recorder.bytes_lost == 11


def test_what_is_known_stands_in_a_later_file_at_its_first_byte(rounds: Rounds) -> None:
    rounds.recorder.know(LINE, "board", 5, {"line": "board"})
    rounds.at(100.0, b"one")
    rounds.recorder.end_session()
    rounds.at(101.0, b"two")
    first, second = rounds.ends()
    for file in (first, second):
        known = [note for note in notes_of(file) if note.name == LINE]
        assert known[0] == Note(int(read_file(file).messages.t_ns[0]), LINE, {"line": "board"})


def test_what_is_said_behind_the_first_byte_stands_in_its_place_and_not_at_the_start_too(rounds: Rounds) -> None:
    recorder = rounds.recorder
    recorder.know(LINE, "board", 4, {"line": "board", "open": True})
    recorder.know(LINE, "simulator", 5, {"line": "simulator", "open": False})
    recorder.board_tap.received(b"one")
    recorder.know(LINE, "simulator", 6, {"line": "simulator", "open": True})
    recorder.end_session()
    recorder.know(LINE, "simulator", 7, {"line": "simulator", "open": False})
    rounds.at(100.0)
    (file,) = rounds.ends()
    said = [(note.content["line"], note.content["open"]) for note in notes_of(file)]
    assert said == [("board", True), ("simulator", True)]


def test_the_summary_counts_each_kind_of_note(rounds: Rounds) -> None:
    rounds.recorder.know(LINE, "board", 5, {"line": "board"})
    rounds.recorder.board_tap.lost = 3
    rounds.at(100.0, b"one")
    rounds.recorder.note(EVENT, 7, {"event": "stick"})
    rounds.at(101.0, b"two")
    (file,) = rounds.ends()
    names = [note.name for note in notes_of(file)]
    assert sorted(names) == sorted([LINE, LOST, EVENT])
    with file.open("rb") as stream:
        summary = make_reader(stream).get_summary()
    assert summary is not None
    assert summary.statistics is not None
    assert (summary.statistics.metadata_count, summary.statistics.message_count) == (3, 2)


def test_a_note_that_could_not_be_written_is_no_lost_byte_of_a_line(rounds: Rounds) -> None:
    rounds.free = 0
    rounds.recorder.board_tap.received(b"four")
    rounds.recorder.note(EVENT, 7, {"event": "stick"})
    assert rounds.at(100.0).bytes_lost == 4


def test_the_cause_of_a_loss_is_told_of_that_loss_alone(rounds: Rounds, monkeypatch: pytest.MonkeyPatch) -> None:
    rounds.free = 0
    rounds.at(100.0, b"lost")
    rounds.free = 10**11
    rounds.at(105.0, b"kept")
    monkeypatch.setattr(taps_module, "_MAX_QUEUED", 0)
    rounds.recorder.board_tap.received(b"too much")
    monkeypatch.undo()
    rounds.at(106.0, b"kept")
    rounds.at(107.0, b"kept")
    assert [note.content for note in rounds.lost()] == [
        {"bytes": 4, "reason": "less than 1000 MB free on the disk"},
        {"bytes": 8, "reason": "the disk did not keep up"},
    ]


def test_of_a_file_that_was_moved_only_what_came_since_the_last_look_counts_as_lost(rounds: Rounds) -> None:
    recorder = rounds.at(100.0, b"x" * 1000)
    seen = recorder.bytes_written
    rounds.at(100.1, b"x" * 100)
    lost = recorder.bytes_written - seen
    _move(recorder)
    assert rounds.at(101.0).bytes_lost == lost
    rounds.at(101.1, b"x")
    whole = recorder.bytes_written
    _move(recorder)
    assert rounds.at(101.2).bytes_lost == lost + whole, "nobody has looked at that one"


def test_a_file_in_whose_place_another_was_put_is_followed_by_a_new_one(rounds: Rounds) -> None:
    first = rounds.at(100.0, b"data").file
    assert first is not None
    first.rename(first.with_name("moved"))
    first.write_bytes(b"another program's")
    assert "was removed or moved" in (rounds.at(101.0).failure or "")
    second = rounds.at(101.1, b"kept").file
    assert second not in (None, first)
    assert first.read_bytes() == b"another program's"


def test_the_hours_that_are_left_follow_from_the_rate_of_the_newest_file(rounds: Rounds) -> None:
    rounds.at(100.0, b"x" * 1_000_000)
    rounds.recorder.end_session()
    recorder = rounds.at(200.0, b"x" * 1000)
    assert rounds.at(204.9).hours_left is None, "it has just begun"
    rounds.free = 1_000_000_000 + 3600 * recorder.bytes_written
    assert rounds.at(210.0).hours_left == pytest.approx(10.0)


def test_a_failure_that_comes_again_after_it_was_mended_is_said_again_and_meanwhile_once(rounds: Rounds) -> None:
    with structlog.testing.capture_logs() as logged:
        for now_s, free in ((100.0, 0), (105.0, 0), (110.0, 10**11), (115.0, 0), (120.0, 0)):
            rounds.free = free
            rounds.at(now_s, b"data")
    said = [line["event"] for line in logged if line["event"] in ("recording begun", "recording failed")]
    assert said == ["recording failed", "recording begun", "recording failed"]


def test_a_disk_that_refuses_the_end_of_a_file_is_told_and_the_next_session_is_recorded(
    rounds: Rounds, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(_: RecordingFile) -> None:
        raise OSError(5, "Input/output error")

    first = rounds.at(100.0, b"data").file
    assert first is not None
    output = rounds.recorder._output
    assert output is not None
    with monkeypatch.context() as patch:
        patch.setattr(RecordingFile, "finish", refuse)
        rounds.recorder.end_session()
        assert rounds.at(101.0).failure == "Input/output error"
    assert rounds.recorder.file is None
    assert output._output.closed
    assert [bytes(data) for data in _told(first)] == [b"data"], "what it holds stays"
    assert rounds.at(106.0, b"next").file not in (None, first)
    assert rounds.recorder.failure is None


def test_a_file_that_takes_no_record_is_closed_and_leaves_nothing_behind(
    rounds: Rounds, monkeypatch: pytest.MonkeyPatch
) -> None:
    put = RecordingFile.put
    made: list[RecordingFile] = []

    def head_alone(file: RecordingFile, data: bytes) -> None:
        if file in made:
            raise OSError(28, "No space left on device")
        made.append(file)
        put(file, data)

    monkeypatch.setattr(RecordingFile, "put", head_alone)
    assert rounds.at(100.0, b"data").failure == "No space left on device"
    assert rounds.recorder.bytes_lost == 4
    (file,) = made
    assert file._output.closed
    assert list(rounds.folder.iterdir()) == []


def test_what_the_disk_takes_in_pieces_is_whole(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    class Slow(FileIO):
        def write(self, data: Any) -> int:
            return super().write(bytes(data[:7]))

    monkeypatch.setattr(recording_file_module, "FileIO", Slow)
    file = RecordingFile(tmp_path, 1_700_000_000_000_000_000, "test", TOPICS)
    for number in range(3):
        data = b"%d" % number * 20
        file.put(message_record(1, file.tally.add(1, number), number, data))
    file.finish()
    assert file.bytes_written == file.path.stat().st_size
    assert [bytes(data) for data in _told(file.path)] == [b"0" * 20, b"1" * 20, b"2" * 20]
    assert read_file(file.path).is_whole


def test_a_file_that_ends_is_pushed_to_the_disk_with_its_summary_and_its_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pushed: list[int | Path] = []
    monkeypatch.setattr(recording_file_module, "sync_folder", pushed.append)
    monkeypatch.setattr(os, "fsync", lambda descriptor: pushed.append(os.fstat(descriptor).st_size))
    file = RecordingFile(tmp_path, 1_700_000_000_000_000_000, "test", TOPICS)
    file.put(message_record(1, file.tally.add(1, 5), 5, b"data"))
    file.finish()
    assert pushed == [file.path.stat().st_size, tmp_path]


def test_mending_older_files_ends_with_the_flight(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[Callable[[], bool]] = []
    monkeypatch.setattr(recorder_module, "repair_all", lambda _, is_over: asked.append(is_over))
    recorder = Recorder(tmp_path, LineClock(), "test")
    recorder.start()
    eventually(lambda: bool(asked), "mending begins")
    (is_over,) = asked
    assert not is_over()
    recorder.stop()
    assert is_over()


def test_bytes_that_were_read_late_have_the_time_at_which_they_came_and_what_is_sent_changes_it_for_nobody(
    rounds: Rounds, monkeypatch: pytest.MonkeyPatch
) -> None:
    now_ns = 1024 * 10**9
    monkeypatch.setattr(time, "monotonic_ns", lambda: now_ns)
    clock, tap = rounds.recorder._clock, rounds.recorder.board_tap
    read_ns = clock.decoding(lambda _: clock.now_ns())
    tap.received(b"on time")
    first_ns = read_ns(b"on time")
    now_ns += 3 * 1024 * 10**6
    tap.received(b"late", 1.024)
    tap.sent(b"answer")
    assert read_ns(b"late") - first_ns == 2 * 1024 * 10**6
    rounds.at(100.0)
    (file,) = rounds.ends()
    assert [t_ns - first_ns for t_ns in read_file(file).messages.t_ns.tolist()] == [0, 2048 * 10**6, 3072 * 10**6]


def _move(recorder: Recorder) -> None:
    assert recorder.file is not None
    recorder.file.rename(recorder.file.with_suffix(".moved"))


def _told(path: Path) -> Iterator[Any]:
    messages = read_file(path).messages
    for at, length in zip(messages.start.tolist(), messages.length.tolist(), strict=True):
        yield messages.data[at : at + length]
