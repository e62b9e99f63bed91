"""Files that survive a power cut: written to a second file, synced to the disk, then renamed in one step."""

from __future__ import annotations

import errno
import os
import stat
import time
from collections.abc import Callable
from fnmatch import fnmatchcase
from pathlib import Path
from typing import BinaryIO, cast


def replace_file(path: Path, data: bytes, mode: int | None = None) -> None:
    """Replace a file atomically: it has the old or the new content, never a part. Blocks; raises OSError.

    With `mode`, nobody whom these rights shut out can read it at any moment; without, the user's usual rights hold.
    """
    temporary = path.with_name(path.name + ".new")
    if mode is not None:
        temporary.unlink(missing_ok=True)  # one that a kill left may have other rights
    with open(temporary, "wb", opener=None if mode is None else _with_rights(mode)) as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())
    temporary.replace(path)
    sync_folder(path.parent)


def set_aside(path: Path, unix_s: Callable[[], float] = time.time) -> Path:
    """Rename a file that cannot be read, for a person to look at; no earlier one is lost. Raises OSError."""
    stamp = time.strftime("%Y%m%dT%H%M%SZ", time.gmtime(unix_s()))
    kept, number = path.with_name(f"{path.name}.damaged-{stamp}"), 1
    while kept.exists():
        number += 1
        kept = path.with_name(f"{path.name}.damaged-{stamp}-{number}")
    path.rename(kept)
    sync_folder(kept.parent)
    return kept


def regular_files(folder: Path, pattern: str = "*") -> list[Path]:
    """The files of a folder whose names match. A link leads out of it, a pipe or a device blocks whoever opens it: none
    of them counts. Empty if the folder is not there or cannot be read."""
    try:
        with os.scandir(folder) as entries:
            return [
                folder / entry.name
                for entry in entries
                if fnmatchcase(entry.name, pattern) and entry.is_file(follow_symlinks=False)
            ]
    except OSError:
        return []


def open_regular(path: Path) -> BinaryIO:
    """Open a file for reading and writing; raises OSError for a link, a pipe or a device, without waiting for one."""
    return _regular(path, os.O_RDWR, "r+b")


def open_log(path: Path) -> BinaryIO:
    """Open our own log for appending and reading, made if it is not there; raises OSError as `open_regular` does."""
    return _regular(path, os.O_RDWR | os.O_CREAT | os.O_APPEND, "a+b")


def _regular(path: Path, flags: int, mode: str) -> BinaryIO:
    descriptor = os.open(path, flags | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0), 0o600)
    file = cast(BinaryIO, os.fdopen(descriptor, mode))
    if not stat.S_ISREG(os.fstat(descriptor).st_mode):
        file.close()
        raise OSError(errno.EINVAL, "not a regular file", str(path))
    return file


def _with_rights(mode: int) -> Callable[[str, int], int]:
    return lambda path, flags: os.open(path, flags | os.O_EXCL, mode)


def sync_folder(folder: Path) -> None:
    """Sync the folder's entries, so that creations, renames and removals survive a power cut. Raises OSError."""
    if os.name == "nt":  # a folder cannot be opened there, and renaming is written through
        return
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
