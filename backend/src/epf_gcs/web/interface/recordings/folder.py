"""The folder of the recordings, one of which may be growing while it is read."""

from __future__ import annotations

import stat
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Final, NamedTuple

from epf_gcs.disk import regular_files

_PIECE: Final = 256 * 1024


class GrowingFile(NamedTuple):
    """The recording being written: its file name, and the number of bytes that are complete records."""

    file: str
    whole: int


@dataclass(frozen=True, slots=True)
class Recording:
    """One file at the time of listing. `started_s` is Unix time."""

    path: Path
    started_s: float
    size: int
    active: bool

    def pieces(self) -> Iterator[bytes]:
        """The first `size` bytes, without what is appended meanwhile. Blocks: call it in a thread."""
        left = self.size
        with self.path.open("rb") as file:
            while left > 0 and (piece := file.read(min(left, _PIECE))):
                left -= len(piece)
                yield piece


class RecordingFolder:
    """`growing` gives the recording being written. Every call reads the disk: call it in a thread."""

    def __init__(self, path: Path, growing: Callable[[], GrowingFile | None]) -> None:
        self._path = path
        self._growing = growing

    def all(self) -> list[Recording]:
        """Newest first."""
        files = sorted(regular_files(self._path, "*.mcap"), reverse=True)
        return [found for file in files if (found := self._look(file)) is not None]

    def find(self, name: str) -> Recording | None:
        """The recording of this name; None if it does not exist, or if its name is not one we give."""
        return self._look(self._path / f"{name}.mcap")

    def _look(self, file: Path) -> Recording | None:
        growing = self._growing()
        active = growing is not None and growing.file == file.name
        try:
            started = datetime.strptime(file.stem.split("-")[0], "%Y%m%dT%H%M%SZ").replace(tzinfo=UTC)
            found = file.lstat()
            size = found.st_size
        except (ValueError, OSError):
            return None
        if not stat.S_ISREG(found.st_mode):
            return None
        if growing is not None and active and growing.whole > 0:
            size = min(size, growing.whole)
        return Recording(file, started.timestamp(), size, active)
