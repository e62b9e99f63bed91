"""A lock on the data folder: a second flight process would overwrite the first one's memory and recordings."""

from __future__ import annotations

import os
import stat
import time
from contextlib import suppress
from pathlib import Path
from types import TracebackType
from typing import BinaryIO, Final, Self

from epf_gcs.errors import ConflictError
from epf_gcs.system.locks import lock

FLIGHT: Final = ".lock"
"""The flight process's."""
WEB: Final = ".web.lock"
"""The web process's own: it writes other files of the folder than the flight process."""
STATION: Final = ".station.lock"
"""The launcher's, for as long as it runs: of two that start at once, one waits for no part of the other."""
LOCK_FILES: Final = frozenset({FLIGHT, WEB, STATION})
"""All of them: of a run alone, in no backup, and no sign of a station's work."""
FORMAT_FILE: Final = "format.json"
"""A folder with it is a station's. Any other that somebody names is left to its rights."""
PATIENCE_S: Final = 3.0
"""A process that is ending may hold the lock for this long."""
_LOOK_AGAIN_S: Final = 0.05


class DataFolder:
    """Locked from construction until `release` or the end of the process, even if it is killed.

    Raises ConflictError where another process holds it, and OSError where the folder cannot be written.
    """

    def __init__(self, path: Path, name: str = FLIGHT) -> None:
        self.path = path
        path.mkdir(mode=0o700, parents=True, exist_ok=True)
        if (path / FORMAT_FILE).exists():
            keep_private(path)
        # Not truncated: it may hold the id of the process that has the lock.
        self._file: BinaryIO | None = os.fdopen(os.open(path / name, os.O_RDWR | os.O_CREAT, 0o600), "r+b")
        if not lock(self._file):
            other = self._file.read(32).decode("ascii", "replace").strip()
            self._file.close()
            raise ConflictError(
                "data_folder_taken",
                f"The data folder {path} is in use by another epf-gcs (process {other or 'unknown'}): "
                "stop that one, or start this one with another data folder.",
                path=str(path),
                pid=other,
            ) from None
        self._file.seek(0)
        self._file.truncate()
        self._file.write(b"%d\n" % os.getpid())
        self._file.flush()

    def release(self) -> None:
        """Unlock. The file stays: a process that already opened it would otherwise lock a deleted file."""
        file, self._file = self._file, None
        if file is not None:
            file.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.release()


def held(path: Path, patience_s: float = PATIENCE_S, name: str = FLIGHT) -> DataFolder:
    """The folder, locked, after a short wait if a process that is ending has it still. Raises as `DataFolder` does."""
    give_up_s = time.monotonic() + patience_s
    while True:
        try:
            return DataFolder(path, name)
        except ConflictError:
            if time.monotonic() >= give_up_s:
                raise
        time.sleep(_LOOK_AGAIN_S)


def keep_private(path: Path) -> None:
    """Shut others out of our own folder, which holds private keys: who cannot enter it reads none of its files."""
    with suppress(OSError):
        found, own_user = path.lstat(), getattr(os, "getuid", lambda: -1)()
        if stat.S_ISDIR(found.st_mode) and found.st_mode & 0o077 and found.st_uid == own_user:
            path.chmod(0o700)


def tighten(path: Path) -> None:
    """Files and folders of our own folder lose the rights that an earlier version gave to others. No link is followed.
    Takes 5 us for each file, so only the launcher does it."""
    if os.name == "nt" or not (path / FORMAT_FILE).exists():
        return
    for _, folders, files, descriptor in os.fwalk(path, follow_symlinks=False):
        for name in (*folders, *files):
            with suppress(OSError):
                found = os.stat(name, dir_fd=descriptor, follow_symlinks=False)
                if not stat.S_ISLNK(found.st_mode) and found.st_mode & 0o077 and found.st_uid == os.getuid():
                    os.chmod(name, stat.S_IMODE(found.st_mode) & 0o700, dir_fd=descriptor)


def is_in_use(path: Path) -> bool:
    """Whether a station has the folder. Makes nothing. Raises OSError."""
    return any(_is_locked(path / name) for name in (FLIGHT, WEB))


def _is_locked(path: Path) -> bool:
    try:
        with path.open("r+b" if os.name == "nt" else "rb") as file:
            return not lock(file)
    except FileNotFoundError:
        return False
