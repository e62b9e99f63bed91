"""Round after round of the recorder's thread, at times and on a disk that the test gives."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace

import pytest
import structlog

from epf_gcs.flight.line_clock import LineClock
from epf_gcs.flight.recording import recorder as recorder_module
from epf_gcs.flight.recording import recording_file as recording_file_module
from epf_gcs.flight.recording import taps as taps_module
from epf_gcs.flight.recording.recorder import DiskPolicy, Recorder
from epf_gcs.flight.recording.recording_file import RecordingFile
from epf_gcs.recordings.notes import LOST
from epf_gcs.recordings.reading import notes_of
from epf_gcs.recordings.topics import TOPICS


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
