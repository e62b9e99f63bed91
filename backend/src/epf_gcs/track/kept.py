"""A flown track on the disk, so that it survives a restart of the web process or of the computer."""

from __future__ import annotations

import os
import struct
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np

from epf_gcs.disk import replace_file
from epf_gcs.track.track import ATTITUDE, MAX_POINTS, POINT, Track

_MAGIC: Final = b"EPK1"
_HEADER: Final = struct.Struct("<4sId")
_RECORD: Final = POINT.itemsize + ATTITUDE.itemsize
# An older track belongs to another flight and is not restored; that flight's recording still has it.
_LASTS_S: Final = 6 * 3600.0


@dataclass(slots=True)
class _FileState:
    """State of the file: it holds the first `points` points of the track with this epoch."""

    epoch: int
    points: int


class KeptTrack:
    """One file: a header (magic, 0, f64 Unix time t0) and records of 22 bytes, a point and its attitude.

    All calls come from one thread at a time, never from the event loop.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self._written: _FileState | None = None

    def load(self, now_s: float, epoch: int) -> Track | None:
        """The saved track; None if there is none of the last hours. An incomplete last record is ignored."""
        try:
            data = self._path.read_bytes()
        except OSError:
            return None
        if len(data) < _HEADER.size or data[:4] != _MAGIC:
            return None
        t0_s = float(_HEADER.unpack_from(data)[2])
        count = min((len(data) - _HEADER.size) // _RECORD, MAX_POINTS)
        records = np.frombuffer(data, np.uint8, count * _RECORD, _HEADER.size).reshape(count, _RECORD)
        points = records[:, : POINT.itemsize].tobytes()
        if not count or now_s - (t0_s + np.frombuffer(points, POINT)["t_ms"][-1] * 1e-3) > _LASTS_S:
            return None
        track = Track(t0_s, epoch)
        track.restore(points, records[:, POINT.itemsize :].tobytes())
        self._written = _FileState(track.epoch, count)
        return track

    def save(self, epoch: int, t0_s: float, total: int, points: bytes, attitudes: bytes, first: int) -> None:
        """Write the points from index `first` on; those before are in the file already. Raises OSError."""
        count = total - first
        records = np.empty((count, _RECORD), np.uint8)
        records[:, : POINT.itemsize] = np.frombuffer(points, np.uint8).reshape(count, POINT.itemsize)
        records[:, POINT.itemsize :] = np.frombuffer(attitudes, np.uint8).reshape(count, ATTITUDE.itemsize)
        self._path.parent.mkdir(parents=True, exist_ok=True)
        if first == 0:
            replace_file(self._path, _HEADER.pack(_MAGIC, 0, t0_s) + records.tobytes())
        else:
            with self._path.open("r+b") as file:
                file.seek(_HEADER.size + first * _RECORD)
                file.write(records.tobytes())
                file.truncate()
                os.fsync(file.fileno())
        self._written = _FileState(epoch, total)

    def first_unwritten(self, track: Track) -> int:
        """Index of the first point that the file does not hold; 0 if it holds another track."""
        written = self._written
        return written.points if written is not None and written.epoch == track.epoch else 0
