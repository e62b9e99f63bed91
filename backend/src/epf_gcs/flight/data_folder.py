"""A lock on the data folder: a second flight process would overwrite the first one's memory and recordings."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from types import TracebackType
from typing import BinaryIO, Self

from epf_gcs.errors import ConflictError

if sys.platform == "win32":
    import msvcrt
else:
    import fcntl

# Windows locks byte ranges and makes them unreadable: this byte lies behind the process id, which stays readable.
_LOCKED_BYTE = 4096


class DataFolder:
    """Locked from construction until `release` or the end of the process, even if it is killed.

    Raises ConflictError where another process holds it, and OSError where the folder cannot be written.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        path.mkdir(parents=True, exist_ok=True)
        # Not truncated: it may hold the id of the process that has the lock.
        self._file: BinaryIO | None = os.fdopen(os.open(path / ".lock", os.O_RDWR | os.O_CREAT, 0o644), "r+b")
        try:
            _lock(self._file)
        except OSError:
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


def _lock(file: BinaryIO) -> None:
    """Raises OSError if another process has the lock."""
    if sys.platform == "win32":
        file.seek(_LOCKED_BYTE)
        try:
            msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
        finally:
            file.seek(0)
    else:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
