"""Every byte of both lines, both ways, into one MCAP file a session, before anybody decodes it.

The event loop only appends to a queue; a thread packs and writes what is in it and pushes it
to the disk four times a second, so that a power cut takes less than a second of the flight.
Whatever the disk does, the flight goes on; bytes that could not be written are counted and reported.
"""

from __future__ import annotations

import contextlib
import errno
import shutil
import threading
from collections import deque
from collections.abc import Iterator
from itertools import dropwhile, groupby
from operator import itemgetter
from pathlib import Path
from time import monotonic, monotonic_ns
from typing import Any, Final

from epf_gcs.contract.answers import DiskPolicy
from epf_gcs.flight.clock.line_clock import LineClock
from epf_gcs.flight.memory.flight_log import say
from epf_gcs.flight.recording.recording_file import RecordingFile
from epf_gcs.flight.recording.repair import recordings_in, repair_all
from epf_gcs.flight.recording.taps import NOTE, Entry, line_taps
from epf_gcs.recordings.mcap_file import message_record, metadata_record
from epf_gcs.recordings.notes import LOST, written
from epf_gcs.recordings.topics import STREAMS, TOPICS

_FLUSH_S: Final = 0.25
_SYNC_S: Final = 0.2
_RETRY_S: Final = 5.0
# How long a failure stays reported when the next write already succeeded.
_TOLD_S: Final = 5.0
# With less free space than this nothing is recorded, even where older flights are deleted to make room.
_LEAST_BYTES: Final = 16 * 1024 * 1024
# How long a file must have been written before its rate is told.
_RATE_AFTER_S: Final = 5.0


class Recorder:
    """One session at a time: it begins with its first byte and ends when `end_session` is called.

    With less room on the disk than the policy keeps free (`least_bytes`, where it deletes older flights instead)
    nothing is recorded, and `failure` says so.
    """

    def __init__(
        self,
        folder: Path,
        clock: LineClock,
        library: str,
        *,
        retry_s: float = _RETRY_S,
        told_s: float = _TOLD_S,
        least_bytes: int = _LEAST_BYTES,
    ) -> None:
        self._folder = folder
        self._clock = clock
        self._library = library
        self._retry_s = retry_s
        self._told_s = told_s
        self._least_bytes = least_bytes
        # Replaced as a whole by the loop.
        self.policy = DiskPolicy()
        self._queue: deque[Entry] = deque()
        # Replaced by the loop entry by entry, copied by the writing thread in one step.
        self._known: dict[tuple[str, str], dict[str, str]] = {}
        self._wake = threading.Event()
        self._stopping = False
        self._thread = threading.Thread(target=self._run, name="recorder", daemon=True)
        self._mending: threading.Thread | None = None
        self.taps = self.board_tap, self.simulator_tap = line_taps(clock, self._queue)
        # Written by the thread alone and read by the loop: single assignments, no lock needed.
        self.file: Path | None = None
        self.bytes_written = 0
        self.failure: str | None = None
        self.free_bytes: int | None = None
        self._bytes_unwritten = 0
        self._lost_noted = 0
        self._begun_s = 0.0
        self._lost_reason: str | None = None
        self._bytes_seen = 0
        self._output: RecordingFile | None = None
        self._retry_at_s = 0.0
        self._told_until_s = 0.0
        self._look_at_s = 0.0
        self._said: str | None = None
        self._is_low = False

    @property
    def bytes_lost(self) -> int:
        """Number of bytes of both lines that reached no file."""
        return self.board_tap.lost + self.simulator_tap.lost + self._bytes_unwritten

    def start(self) -> None:
        """Start writing in the background, and repairing files that an earlier run left incomplete."""
        # Listed before the writer starts, so that the file it writes is never repaired.
        torn = recordings_in(self._folder)
        self._mending = threading.Thread(
            target=repair_all, args=(torn, lambda: self._stopping), name="recordings' repair", daemon=True
        )
        self._mending.start()
        self._thread.start()

    def stop(self) -> None:
        """End the session and wait until it is on the disk."""
        self.end_session()
        self._stopping = True
        self._wake.set()
        self._thread.join()
        if self._mending is not None:
            self._mending.join()

    def note(self, name: str, t_ns: int, content: Any) -> None:
        """Put a note of Unix time `t_ns` into the recording; without a recording it is dropped."""
        self._queue.append((NOTE, t_ns, metadata_record(name, written(t_ns, content))))

    def know(self, name: str, about: str, t_ns: int, content: Any) -> None:
        """The same for what each later file begins with too, in place of an earlier note of this `name` and `about`.

        Nothing is noted if this was known before.
        """
        values = written(t_ns, content)
        before = self._known.get((name, about))
        if before is not None and before["json"] == values["json"]:
            return
        self._known[name, about] = values
        self._queue.append((NOTE, t_ns, metadata_record(name, values)))

    def end_session(self) -> None:
        """Close the file; the next bytes begin a new one."""
        self._queue.append(None)

    def _run(self) -> None:
        while not self._stopping:
            self._wake.wait(_FLUSH_S)
            self._write_queue()
            self._look_after()
        # Write what was queued since the last round.
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
        if self._output is None:
            # A file begins with its first byte, and with all that is known by then.
            batch = list(dropwhile(lambda entry: entry[0] == NOTE, batch))
            if not batch:
                return
        try:
            output = self._output or self._open(batch)
            if output is not None:
                self._note_lost(output, batch[0][1])
                output.put(b"".join([self._record(output, *entry) for entry in _together(batch)]))
                self._wrote(output)
                return
        except OSError as error:
            self._fail(error)
        self._bytes_unwritten += sum(len(data) for channel, _, data in batch if channel != NOTE)

    def _record(self, output: RecordingFile, channel: int, time_ns: int, data: bytes) -> bytes:
        if channel == NOTE:
            output.tally.metadata_count += 1
            return data
        return message_record(channel, output.tally.add(channel, time_ns), time_ns, data)

    def _note_lost(self, output: RecordingFile, t_ns: int) -> None:
        """Tell in the file how many bytes are missing before what follows."""
        lost = self.bytes_lost
        if lost > self._lost_noted:
            content = {"bytes": lost - self._lost_noted, "reason": self._lost_reason or "the disk did not keep up"}
            output.put(metadata_record(LOST, written(t_ns, content)))
            output.tally.metadata_count += 1
            self._lost_noted, self._lost_reason = lost, None

    def _open(self, batch: list[tuple[int, int, bytes]]) -> RecordingFile | None:
        if monotonic() < self._retry_at_s:
            return None
        self._folder.mkdir(parents=True, exist_ok=True)
        self._check_room()
        self._output = RecordingFile(self._folder, self._clock.unix_ns(monotonic_ns()), self._library, TOPICS)
        self._bytes_seen = 0
        self._begun_s = monotonic()
        # What was said behind the first byte comes in its own place.
        waiting = {entry[2] for entry in (*batch, *self._queue.copy()) if entry is not None and entry[0] == NOTE}
        for (name, _), values in list(self._known.items()):
            if metadata_record(name, values) not in waiting:
                self._output.put(metadata_record(name, {**values, "t_ns": str(batch[0][1])}))
                self._output.tally.metadata_count += 1
        return self._output

    def _wrote(self, output: RecordingFile) -> None:
        self.bytes_written = output.bytes_written
        if self.file is None:
            self.file = output.path
            self._said = None
            say("info", "recording begun", file=output.path.name)
        if monotonic() >= self._told_until_s:
            self.failure = None

    def _look_after(self) -> None:
        """Sync the file to the disk, and check that nobody removed or moved it."""
        now_s = monotonic()
        output = self._output
        if output is None or now_s < self._look_at_s:
            return
        self._look_at_s = now_s + _SYNC_S
        try:
            if self._is_kept(output):
                self._bytes_seen = output.bytes_written
                return
            self._bytes_unwritten += output.bytes_written - self._bytes_seen
            self._fail(OSError(errno.ENOENT, f"{output.path.name} was removed or moved while it was written"))
            # The disk itself works: continue at once in a new file, and in a new folder if that was removed too.
            self._retry_at_s = 0.0
            self._told_until_s = now_s + self._told_s
        except OSError as error:
            self._fail(error)

    def _is_kept(self, output: RecordingFile) -> bool:
        """Sync the file; whether it is still where it belongs. Raises OSError, also for want of room."""
        try:
            output.sync()
            self._check_room()
        except OSError:
            # In a folder that was removed both fail: that is no fault of the disk.
            if not output.is_gone:
                raise
        return not output.is_gone

    @property
    def hours_left(self) -> float | None:
        """How long the disk's room lasts at the rate of this file; None while that is not known."""
        output, free = self._output, self.free_bytes
        if output is None or free is None:
            return None
        lasted_s = monotonic() - self._begun_s
        if lasted_s < _RATE_AFTER_S or not output.bytes_written:
            return None
        return max(0, free - self._needed_bytes) * lasted_s / output.bytes_written / 3600.0

    @property
    def _needed_bytes(self) -> int:
        return self._least_bytes if self.policy.delete_oldest else max(self._least_bytes, self.policy.keep_free_bytes)

    def _check_room(self) -> None:
        if self._measure() < self._needed_bytes:
            raise OSError(errno.ENOSPC, f"less than {self._needed_bytes // 1_000_000} MB free on the disk")

    def _measure(self) -> int:
        free = self.free_bytes = shutil.disk_usage(self._folder).free
        is_low = free < self._needed_bytes
        if is_low and not self._is_low:
            say("warning", "disk low", folder=str(self._folder), free_megabytes=free // 1_000_000)
        self._is_low = is_low
        return free

    def _finish(self) -> None:
        output, self._output = self._output, None
        if output is None:
            return
        try:
            output.finish()
            say("info", "recording ended", file=output.path.name, bytes=output.bytes_written)
        except OSError as error:
            self._output = output
            self._fail(error)
        self.file = None

    def _fail(self, error: OSError) -> None:
        """Close this file with what it holds, and try a new one after `retry_s`."""
        failure = self.failure = self._lost_reason = f"{error.strerror or error}"
        self._retry_at_s = monotonic() + self._retry_s
        output, self._output = self._output, None
        self.file = None
        if output is not None:
            with contextlib.suppress(OSError):
                output.give_up()
        if failure != self._said:
            # Log the same failure once, not at every retry.
            self._said = failure
            say("error", "recording failed", folder=str(self._folder), reason=failure)


def _together(batch: list[tuple[int, int, bytes]]) -> Iterator[tuple[int, int, bytes]]:
    """Neighbours of one stream that were given the same time become one record."""
    for (topic, t_ns), entries in groupby(batch, key=itemgetter(0, 1)):
        if topic in STREAMS:
            yield topic, t_ns, b"".join([data for _, _, data in entries])
        else:
            yield from entries
