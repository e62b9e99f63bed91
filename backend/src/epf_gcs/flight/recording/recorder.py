"""Every byte of both lines, both ways, into one MCAP file a session, before anybody decodes it.

The event loop only appends to a queue; a thread packs and writes what is in it, four times a second.
Whatever the disk does, the flight goes on; what could not be written is counted and told.
"""

from __future__ import annotations

import os
import threading
from collections import deque
from datetime import UTC, datetime
from io import FileIO
from pathlib import Path
from time import monotonic_ns
from typing import Final

from epf_gcs.clock import Clock
from epf_gcs.flight.recording.mcap_file import Tally, closing, data_end, message_record, metadata_record, opening

BOARD_RECEIVED: Final = 1
BOARD_SENT: Final = 2
SIMULATOR_RECEIVED: Final = 3
SIMULATOR_SENT: Final = 4
TOPICS: Final = {
    BOARD_RECEIVED: "board/received",
    BOARD_SENT: "board/sent",
    SIMULATOR_RECEIVED: "simulator/received",
    SIMULATOR_SENT: "simulator/sent",
}

_FLUSH_S: Final = 0.25
_RETRY_S: Final = 5.0
# A minute of a full line and of a simulator: a disk that is this far behind will not catch up.
_MAX_QUEUED: Final = 100_000
_NOTE: Final = 0

# What waits for the writer: (channel or _NOTE, steady time, bytes); None ends the session.
_Entry = tuple[int, int, bytes] | None


class RecorderTap:
    """Hands the bytes of one line to the recorder; see `epf_gcs.link.base.Tap`. Never blocks.

    This runs for every chunk of a line before anything else does, so it is one look and one append.
    """

    __slots__ = ("_queue", "_received", "_sent", "lost")

    def __init__(self, queue: deque[_Entry], received: int, sent: int) -> None:
        self._queue = queue
        self._received = received
        self._sent = sent
        self.lost = 0

    def received(self, data: bytes) -> None:
        """Bytes as they came."""
        if len(self._queue) < _MAX_QUEUED:
            self._queue.append((self._received, monotonic_ns(), data))
        else:
            self.lost += len(data)

    def sent(self, data: bytes) -> None:
        """Bytes as they went."""
        if len(self._queue) < _MAX_QUEUED:
            self._queue.append((self._sent, monotonic_ns(), data))
        else:
            self.lost += len(data)


class Recorder:
    """One session at a time: it begins with its first byte and ends when `end_session` is called."""

    def __init__(self, folder: Path, clock: Clock, library: str, *, retry_s: float = _RETRY_S) -> None:
        self._folder = folder
        self._clock = clock
        self._library = library
        self._retry_s = retry_s
        self._queue: deque[_Entry] = deque()
        self._wake = threading.Event()
        self._stopping = False
        self._thread = threading.Thread(target=self._run, name="recorder", daemon=True)
        self.board_tap = RecorderTap(self._queue, BOARD_RECEIVED, BOARD_SENT)
        self.simulator_tap = RecorderTap(self._queue, SIMULATOR_RECEIVED, SIMULATOR_SENT)
        # Written by the thread alone and read by the loop: single assignments, no lock needed.
        self.file: Path | None = None
        self.bytes_written = 0
        self.failure: str | None = None
        self._bytes_unwritten = 0
        self._output: FileIO | None = None
        self._tally = Tally()
        self._retry_at_s = 0.0

    @property
    def bytes_lost(self) -> int:
        """Bytes of the lines that are in no file."""
        return self.board_tap.lost + self.simulator_tap.lost + self._bytes_unwritten

    def start(self) -> None:
        """Begin to write in the background."""
        self._thread.start()

    def stop(self) -> None:
        """End the session and wait until it is on the disk."""
        self.end_session()
        self._stopping = True
        self._wake.set()
        self._thread.join()

    def note(self, name: str, values: dict[str, str]) -> None:
        """Put a note into the recording, such as the address of a line that was opened."""
        self._queue.append((_NOTE, 0, metadata_record(name, values)))

    def end_session(self) -> None:
        """Close the file; what comes next begins another."""
        self._queue.append(None)

    def _run(self) -> None:
        while not self._stopping:
            self._wake.wait(_FLUSH_S)
            self._write_queue()
        # What came between the last look and the order to stop.
        self._write_queue()

    def _write_queue(self) -> None:
        batch: list[tuple[int, int, bytes]] = []
        while self._queue:
            entry = self._queue.popleft()
            if entry is not None:
                batch.append(entry)
                continue
            self._write(batch)
            batch = []
            self._finish()
        self._write(batch)

    def _write(self, batch: list[tuple[int, int, bytes]]) -> None:
        if not batch:
            return
        try:
            output = self._output or self._open()
            if output is not None:
                self._put(output, b"".join([self._record(*entry) for entry in batch]))
                return
        except OSError as error:
            self._fail(error)
        self._bytes_unwritten += sum(len(data) for channel, _, data in batch if channel != _NOTE)

    def _record(self, channel: int, steady_ns: int, data: bytes) -> bytes:
        if channel == _NOTE:
            self._tally.metadata_count += 1
            return data
        time_ns = self._clock.unix_ns(steady_ns)
        return message_record(channel, self._tally.add(channel, time_ns), time_ns, data)

    def _open(self) -> FileIO | None:
        now_ns = self._clock.now_ns()
        if now_ns * 1e-9 < self._retry_at_s:
            return None
        self._folder.mkdir(parents=True, exist_ok=True)
        path = _free_name(self._folder, now_ns)
        output = self._output = FileIO(path, "xb")
        self.bytes_written = 0
        self._tally = Tally()
        self._put(output, opening(self._library, TOPICS))
        self.file = path
        self.failure = None
        return output

    def _put(self, output: FileIO, data: bytes) -> None:
        view = memoryview(data)
        while view:
            written = output.write(view) or 0
            self.bytes_written += written
            view = view[written:]

    def _finish(self) -> None:
        output, self._output = self._output, None
        if output is None:
            return
        try:
            end = data_end()
            self._put(output, end + closing(TOPICS, self._tally, self.bytes_written + len(end)))
            os.fsync(output.fileno())
            output.close()
        except OSError as error:
            self._fail(error)
        self.file = None

    def _fail(self, error: OSError) -> None:
        """Give this file up, keep what is in it, and try another one after a while."""
        self.failure = f"{error.strerror or error}"
        self._retry_at_s = self._clock.now_s() + self._retry_s
        output, self._output = self._output, None
        self.file = None
        if output is not None:
            try:
                output.close()
            except OSError as close_error:
                self.failure = f"{close_error.strerror or close_error}"


def _free_name(folder: Path, now_ns: int) -> Path:
    """A file name that sorts by time and is not there yet."""
    stem = datetime.fromtimestamp(now_ns // 1_000_000_000, UTC).strftime("%Y%m%dT%H%M%SZ")
    path = folder / f"{stem}.mcap"
    number = 2
    while path.exists():
        path = folder / f"{stem}-{number}.mcap"
        number += 1
    return path
