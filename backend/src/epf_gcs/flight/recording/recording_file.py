"""One recording on the disk, from its first record to its summary."""

from __future__ import annotations

import os
from datetime import UTC, datetime
from io import FileIO
from pathlib import Path

from epf_gcs.disk import sync_folder
from epf_gcs.recordings.mcap_file import Tally, closing, data_end, opening


class RecordingFile:
    """Constructed and used only by the writing thread. A disk that fails raises OSError."""

    def __init__(self, folder: Path, now_ns: int, library: str, topics: dict[int, str]) -> None:
        self.path = _free_name(folder, now_ns)
        self.tally = Tally()
        self.bytes_written = 0
        self._topics = topics
        self._output = FileIO(self.path, "xb")
        self._bytes_synced = 0
        head = opening(library, topics)
        self._head_bytes = len(head)
        try:
            self.put(head)
        except OSError:
            self.give_up()
            raise

    @property
    def is_gone(self) -> bool:
        """Whether somebody removed or moved the file or its folder, so that further writes would be lost."""
        ours = os.fstat(self._output.fileno())
        try:
            there = self.path.stat()
        except FileNotFoundError:
            return True
        return (ours.st_ino, ours.st_dev) != (there.st_ino, there.st_dev)

    def put(self, data: bytes) -> None:
        """Write all of it."""
        view = memoryview(data)
        while view:
            written = self._output.write(view) or 0
            self.bytes_written += written
            view = view[written:]

    def sync(self) -> None:
        """Sync to the disk, so that the data so far survives a power cut. Blocks."""
        if self.bytes_written == self._bytes_synced:
            return
        if self._bytes_synced == 0:
            sync_folder(self.path.parent)
        getattr(os, "fdatasync", os.fsync)(self._output.fileno())
        self._bytes_synced = self.bytes_written

    def finish(self) -> None:
        """Write the summary and close the file."""
        end = data_end()
        self.put(end + closing(self._topics, self.tally, self.bytes_written + len(end)))
        os.fsync(self._output.fileno())
        sync_folder(self.path.parent)
        self._output.close()

    def give_up(self) -> None:
        """Close the file without a summary; delete it if it holds no record."""
        try:
            self._output.close()
        finally:
            if self.bytes_written <= self._head_bytes:
                self.path.unlink(missing_ok=True)


def _free_name(folder: Path, now_ns: int) -> Path:
    """An unused file name that sorts by time."""
    stem = datetime.fromtimestamp(now_ns // 1_000_000_000, UTC).strftime("%Y%m%dT%H%M%SZ")
    path = folder / f"{stem}.mcap"
    number = 2
    while path.exists():
        path = folder / f"{stem}-{number}.mcap"
        number += 1
    return path
