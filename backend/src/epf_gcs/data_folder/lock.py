"""A lock on the data folder: a second flight process would overwrite the first one's memory and recordings."""

from __future__ import annotations

import os
import time
from pathlib import Path
from types import TracebackType
from typing import BinaryIO, Final, Self

from epf_gcs.errors import ConflictError
from epf_gcs.system.locks import lock

_FILE: Final = ".lock"
# A process that is ending may hold the lock for this long.
_PATIENCE_S: Final = 3.0
_LOOK_AGAIN_S: Final = 0.05


class DataFolder:
    """Locked from construction until `release` or the end of the process, even if it is killed.

    Raises ConflictError where another process holds it, and OSError where the folder cannot be written.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        path.mkdir(parents=True, exist_ok=True)
        # Not truncated: it may hold the id of the process that has the lock.
        self._file: BinaryIO | None = os.fdopen(os.open(path / _FILE, os.O_RDWR | os.O_CREAT, 0o644), "r+b")
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


def held(path: Path, patience_s: float = _PATIENCE_S) -> DataFolder:
    """The folder, locked, after a short wait if a process that is ending has it still. Raises as `DataFolder` does."""
    give_up_s = time.monotonic() + patience_s
    while True:
        try:
            return DataFolder(path)
        except ConflictError:
            if time.monotonic() > give_up_s:
                raise
        time.sleep(_LOOK_AGAIN_S)


def is_in_use(path: Path) -> bool:
    """Whether a flight process has the folder. Makes nothing. Raises OSError."""
    try:
        with (path / _FILE).open("r+b" if os.name == "nt" else "rb") as file:
            return not lock(file)
    except FileNotFoundError:
        return False
