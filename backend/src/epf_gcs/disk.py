"""Files that survive a power cut: written to a second file, synced to the disk, then renamed in one step."""

from __future__ import annotations

import errno
import os
import stat
import time
from collections.abc import Callable
from fnmatch import fnmatchcase
from pathlib import Path
from typing import BinaryIO, Final, Generic, TypeVar, cast

T = TypeVar("T")
_LONGEST: Final = 16 << 20


class DamagedFileError(ValueError):
    """The content of a small file of ours makes no sense."""


class KeptFile(Generic[T]):
    """One small file that holds one value. Blocks.

    `decode` may raise ValueError, TypeError, KeyError or AttributeError for bytes that are no such value.
    """

    def __init__(
        self,
        path: Path,
        decode: Callable[[bytes], T],
        encode: Callable[[T], bytes],
        unix_s: Callable[[], float] = time.time,
    ) -> None:
        self.path = path
        self._decode = decode
        self._encode = encode
        self._unix_s = unix_s

    def read(self) -> T | None:
        """The value; None if there is no file. Raises DamagedFileError, OSError."""
        try:
            with self.path.open("rb") as file:
                return self._decode(file.read(_LONGEST))
        except FileNotFoundError:
            return None
        except (ValueError, TypeError, KeyError, AttributeError) as error:
            raise DamagedFileError(f"{self.path.name}: {error}") from error

    def read_or_set_aside(self, on_damage: Callable[[Path | None], None]) -> T | None:
        """The value; None if there is no file, or if it makes no sense: `on_damage` is told what `set_aside` gives.

        Raises OSError.
        """
        try:
            return self.read()
        except DamagedFileError:
            on_damage(self.set_aside())
            return None

    def set_aside(self) -> Path | None:
        """Keep it under another name, for a person to look at; None if the disk refuses."""
        try:
            return set_aside(self.path, self._unix_s)
        except OSError:
            return None

    def write(self, value: T | None) -> None:
        """Replace the file as a whole; None removes it. Raises OSError, also if its folder is not there."""
        if value is None:
            self.path.unlink(missing_ok=True)
        else:
            replace_file(self.path, self._encode(value))


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
