"""A kill and a power cut take at most a second of the flight, and what is left opens and is mended."""

from __future__ import annotations

import os
import pty
import shutil
import signal
import struct
import sys
import threading
import time
import tty
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import SimpleNamespace

import pytest

from epf_gcs.flight.clock.line_clock import LineClock
from epf_gcs.flight.recording import recorder as recorder_module
from epf_gcs.flight.recording import recording_file
from epf_gcs.flight.recording.recorder import Recorder
from epf_gcs.flight.recording.repair import repair
from epf_gcs.recordings.notes import LOST
from epf_gcs.recordings.reading import notes_of, read_file
from epf_gcs.recordings.topics import BOARD_RECEIVED
from tests.support.programs import Program
from tests.support.waiting import eventually

NUMBER = struct.Struct("<Q")
EVERY_S = 0.01


def board_bytes(path: Path) -> bytes:
    """All that a file has of the board's line, in order."""
    messages = read_file(path).messages
    rows = zip(messages.channel.tolist(), messages.start.tolist(), messages.length.tolist(), strict=True)
    return b"".join(messages.data[at : at + size].tobytes() for channel, at, size in rows if channel == BOARD_RECEIVED)


class Talker:
    """A line that says one number after another; `said`: how many."""

    def __init__(self) -> None:
        self._master, slave = pty.openpty()
        tty.setraw(slave)
        self.url = f"pty://{os.ttyname(slave)}"
        self._slave = slave
        self.said = 0
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._talk, daemon=True)

    @contextmanager
    def talking(self) -> Iterator[None]:
        self._thread.start()
        try:
            yield
        finally:
            self._over.set()
            self._thread.join()
            os.close(self._master)
            os.close(self._slave)

    def _talk(self) -> None:
        while not self._over.wait(EVERY_S):
            os.write(self._master, NUMBER.pack(self.said))
            self.said += 1


def numbers_in(file: Path) -> list[int]:
    kept = board_bytes(file)
    return [number for (number,) in NUMBER.iter_unpack(kept[: len(kept) // 8 * 8])]


def test_a_kill_takes_nothing_that_was_written_and_the_next_start_mends_the_file(tmp_path: Path) -> None:
    talker = Talker()
    program = [sys.executable, "-m", "epf_gcs.flight", "--data-dir", str(tmp_path)]
    folder = tmp_path / "recordings"
    with talker.talking():
        flight = Program([*program, "--board", talker.url])
        eventually(lambda: any(file.stat().st_size > 4000 for file in folder.glob("*.mcap")), "it records")
        (file,) = folder.glob("*.mcap")
        said = talker.said + int(1.5 / EVERY_S)
        eventually(lambda: max(numbers_in(file), default=0) >= said, "it writes what is said, again and again")
        flight.end(signal.SIGKILL)
    torn = read_file(file)
    assert not torn.is_whole
    assert torn.damage is None, "all that is there is whole records"
    kept = board_bytes(file)
    numbers = numbers_in(file)
    assert numbers == list(range(numbers[0], numbers[0] + len(numbers))), "nothing in between is lost"
    assert numbers[-1] >= said
    again = Program(program)
    try:
        eventually(lambda: read_file(file).is_whole, "it is mended")
    finally:
        again.end()
    assert board_bytes(file) == kept


class SlowDisk:
    """A disk whose cache a power cut empties, and the time, which passes only where somebody waits.

    Whatever waits, bytes come meanwhile. A file that was not entered into its folder is not there after the cut.
    """

    def __init__(self, sync_s: float) -> None:
        self.now_s = 100.0
        self.came_s: list[float] = []
        self.kept = b""
        self.worst_s = 0.0
        self.recorder: Recorder | None = None
        self._sync_s = sync_s
        self._entered = False
        self._kept_count = 0

    def wait(self, seconds: float | None = None) -> bool:
        for _ in range(round((seconds or 0.0) / EVERY_S)):
            self.now_s += EVERY_S
            assert self.recorder is not None
            self.recorder.board_tap.received(NUMBER.pack(len(self.came_s)))
            self.came_s.append(self.now_s)
            if self._kept_count < len(self.came_s):
                self.worst_s = max(self.worst_s, self.now_s - self.came_s[self._kept_count])
        return False

    def sync(self, descriptor: int) -> None:
        at_call = Path(f"/proc/self/fd/{descriptor}").read_bytes()
        self.wait(self._sync_s)
        if self._entered:
            self.kept = at_call
            self._kept_count = at_call.count(b"\x05\x1e" + bytes(7))  # messages of eight bytes

    def sync_folder(self, _: Path) -> None:
        self._entered = True


def test_a_power_cut_at_any_moment_takes_at_most_a_second(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    disk = SlowDisk(sync_s=0.15)
    monkeypatch.setattr(recorder_module, "monotonic", lambda: disk.now_s)
    monkeypatch.setattr(recorder_module, "monotonic_ns", lambda: int(disk.now_s * 1e9))
    monkeypatch.setattr(time, "monotonic_ns", lambda: int(disk.now_s * 1e9))
    monkeypatch.setattr(recording_file, "sync_folder", disk.sync_folder)
    monkeypatch.setattr(os, "fdatasync", disk.sync)
    recorder = disk.recorder = Recorder(tmp_path, LineClock(), "test")
    rounds = iter(range(100))

    def wait(seconds: float) -> bool:
        if next(rounds, None) is None:
            recorder._stopping = True
        return disk.wait(seconds)

    monkeypatch.setattr(recorder._wake, "wait", wait)
    recorder._run()  # the writer's own loop, in this thread
    recorder.end_session()
    recorder._write_queue()
    assert disk.now_s > 125.0
    assert disk.worst_s <= 1.0, f"{disk.worst_s} s could be lost"
    (file,) = tmp_path.glob("*.mcap")
    after = tmp_path / "20260101T000000Z.mcap"
    after.write_bytes(disk.kept + bytes(4096))
    assert repair(after) is not None
    assert read_file(after).is_whole
    kept = board_bytes(after)
    assert len(kept) > 8 * 2000
    assert board_bytes(file).startswith(kept)


def test_the_room_that_is_left_is_told_in_hours(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    now_s, free = 100.0, 37_000_000_000
    monkeypatch.setattr(recorder_module, "monotonic", lambda: now_s)
    monkeypatch.setattr(shutil, "disk_usage", lambda _: SimpleNamespace(free=free))
    recorder = Recorder(tmp_path, LineClock(), "test")
    assert recorder.hours_left is None, "nothing is recorded"
    recorder.board_tap.received(b"x" * 100_000)
    recorder._write_queue()
    assert recorder.hours_left is None, "too early to know the rate"
    now_s = 110.0
    rate = recorder.bytes_written / 10.0
    assert recorder.hours_left == pytest.approx((free - 1_000_000_000) / rate / 3600.0), "down to what is kept free"
    free = 500_000_000
    recorder._look_after()
    assert recorder.failure is not None, "there is no room at all"
    assert recorder.hours_left is None
    recorder.end_session()
    recorder._write_queue()


def test_what_the_queue_could_not_hold_is_told_in_the_file(tmp_path: Path) -> None:
    recorder = Recorder(tmp_path, LineClock(), "test")  # its thread is not started yet: it does not keep up
    for _ in range(100_003):
        recorder.board_tap.received(b"12")
    recorder._write_queue()
    recorder.board_tap.received(b"after")
    recorder._write_queue()
    recorder.end_session()
    recorder._write_queue()
    (file,) = tmp_path.glob("*.mcap")
    (lost,) = [note for note in notes_of(file) if note.name == LOST]
    assert lost.content == {"bytes": 6, "reason": "the disk did not keep up"}
    assert len(board_bytes(file)) == 200_005
