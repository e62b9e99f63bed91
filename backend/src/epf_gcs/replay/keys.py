"""Key frames of one recording: the vehicle's state every two seconds of flight, in a file that all replays of it share.

One replay (whoever holds the lock) writes them, in the background and once; the others read what is there. The file
is made from the recording and can be deleted at any time. It is read only if it is of this recording and of this code.
"""

from __future__ import annotations

import contextlib
import json
import os
import zlib
from bisect import bisect_right
from functools import lru_cache
from hashlib import sha256
from pathlib import Path
from struct import Struct
from typing import Final

from epf_gcs import __version__
from epf_gcs.replay.playhead_state import PlayheadState
from epf_gcs.system.files import read_at, write_at
from epf_gcs.system.locks import lock

EVERY_NS: Final = 2_000_000_000
_FORMAT: Final = 4
# Time of the key frame in Unix ns, and bytes of its packed state.
_HEAD: Final = Struct("<qI")
_LONGEST: Final = 4_000_000
# What the state is made by; the first is the package itself.
_ROOMS: Final = ("", "codec", "replay", "vehicle", "xplane")


@lru_cache(maxsize=1)
def code_stamp() -> str:
    """Of the code whose state the key frames hold: two checkouts of one version may make other states."""
    digest = sha256()
    for room in _ROOMS:
        for file in sorted((Path(__file__).parents[1] / room).glob("*.py")):
            digest.update(file.read_bytes())
    return digest.hexdigest()[:16]


class Keys:
    """`file` None: they are kept in memory alone. Errors of the disk end sharing, never a replay."""

    def __init__(self, file: Path | None, recording: str, starts_ns: int) -> None:
        self._title = json.dumps([_FORMAT, __version__, code_stamp(), recording, starts_ns]).encode() + b"\n"
        self._times: list[int] = []
        self._places: list[tuple[int, int]] = []
        self._packed: list[bytes | None] = []
        self._file: int | None = None
        self._end = 0
        self.is_writer = True
        if file is not None:
            with contextlib.suppress(OSError):
                self._open(file)

    @property
    def latest_ns(self) -> int | None:
        """The time of the last key frame."""
        return self._times[-1] if self._times else None

    def look(self) -> None:
        """Take in what another replay has written, and go on with it if that one has ended."""
        if self._file is None:
            return
        with contextlib.suppress(OSError):
            if not self.is_writer:
                self.is_writer = lock(self._file)
        with contextlib.suppress(OSError):
            self._read_on(self._file)

    def before(self, t_ns: int) -> tuple[int, PlayheadState] | None:
        """Time and state of the last key frame at or before `t_ns`; one that cannot be read is passed over."""
        number = bisect_right(self._times, t_ns) - 1
        while number >= 0:
            packed = self._packed[number] or self._fetch(*self._places[number])
            with contextlib.suppress(ValueError, zlib.error):
                return self._times[number], PlayheadState.from_json(zlib.decompress(packed))
            number -= 1
        return None

    def add(self, t_ns: int, state: str) -> None:
        """Keep a state; its time is later than those before."""
        packed = zlib.compress(state.encode(), 1)
        if self._file is not None:
            try:
                record = _HEAD.pack(t_ns, len(packed)) + packed
                if write_at(self._file, record, self._end) == len(record):
                    self._take(t_ns, None, self._end + _HEAD.size, len(packed))
                    self._end += len(record)
                    return
            except OSError:
                pass
        self._take(t_ns, packed, 0, 0)

    def close(self) -> None:
        """Let the file go; another replay may write it."""
        if self._file is not None:
            os.close(self._file)
            self._file = None

    def _open(self, file: Path) -> None:
        file.parent.mkdir(parents=True, exist_ok=True)
        self._file = descriptor = os.open(file, os.O_RDWR | os.O_CREAT, 0o600)
        self.is_writer = lock(descriptor)
        if read_at(descriptor, len(self._title), 0) == self._title:
            self._end = len(self._title)
            self._read_on(descriptor)
        elif self.is_writer:
            os.ftruncate(descriptor, 0)
            write_at(descriptor, self._title, 0)
            self._end = len(self._title)
        else:
            # Another version is writing its own: keep ours in memory.
            self.close()
            self.is_writer = True

    def _read_on(self, descriptor: int) -> None:
        size = os.fstat(descriptor).st_size
        while self._end + _HEAD.size <= size:
            t_ns, length = _HEAD.unpack(read_at(descriptor, _HEAD.size, self._end))
            after = self._end + _HEAD.size + length
            if after > size or length > _LONGEST or (self._times and t_ns <= self._times[-1]):
                break
            self._take(t_ns, None, self._end + _HEAD.size, length)
            self._end = after

    def _take(self, t_ns: int, packed: bytes | None, place: int, length: int) -> None:
        self._times.append(t_ns)
        self._packed.append(packed)
        self._places.append((place, length))

    def _fetch(self, place: int, length: int) -> bytes:
        if self._file is None:
            return b""
        with contextlib.suppress(OSError):
            return read_at(self._file, length, place)
        return b""
