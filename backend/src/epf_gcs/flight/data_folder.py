"""One flight to a data folder: a second one would write over what the first remembers and records."""

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

# The system locks this byte where a file cannot be locked as a whole; what stands in front stays readable there.
_LOCKED_BYTE = 4096


class DataFolder:
    """Held from making it until `release`, or until the process ends, however that ends.

    Raises ConflictError where another process holds it, and OSError where the folder cannot be written.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        path.mkdir(parents=True, exist_ok=True)
        # Not truncated: what stands in it is the other's number, if there is another.
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
        """Another process may have it. The file stays: removing it would take it from under whoever waits."""
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
    """Raises OSError where another process has it."""
    if sys.platform == "win32":
        file.seek(_LOCKED_BYTE)
        try:
            msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
        finally:
            file.seek(0)
    else:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
