"""`epf-gcs backup` and `epf-gcs restore`: the data folder as one file, proven whole before anything is replaced.

The file is a tar archive. Its last member lists all others with their sizes and SHA-256, so a file that was cut off, or
changed, is refused. What the station makes again by itself is left out. With a password the archive is encrypted as a
whole (`age_archive.py`).
"""

from __future__ import annotations

import contextlib
import errno
import hashlib
import io
import os
import shutil
import sqlite3
import tarfile
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any, BinaryIO, Final, cast

import orjson

from epf_gcs import __version__
from epf_gcs.backup.errors import BackupError
from epf_gcs.data_folder.lock import LOCK_FILES
from epf_gcs.data_folder.upgrade import is_interrupted
from epf_gcs.data_folder.version import FORMAT, read_format
from epf_gcs.data_folder.whereabouts import FILE as WHEREABOUTS
from epf_gcs.disk import sync_folder
from epf_gcs.recordings.places import PACKING

LIST: Final = "epf-gcs-backup.json"
# Made again from the recordings, or of this run alone.
_LEFT_OUT: Final = LOCK_FILES | {"columns", "exports", "logs", "library.sqlite", "run.lock", "board.pty", WHEREABOUTS}
_DATABASE_MARKS: Final = ("-journal", "-wal", "-shm")
_BLOCK_BYTES: Final = 1 << 20
_MOST_LIST_BYTES: Final = 50_000_000
# Python 3.11 has it from 3.11.4 on, and Debian 12 has 3.11.2: what it would refuse is refused here too.
FILTER: Final[dict[str, Any]] = {"filter": "data"} if hasattr(tarfile, "data_filter") else {}

Say = Callable[[str], None]


@dataclass(frozen=True, slots=True)
class ListedFile:
    """What the list of a backup says of a file."""

    bytes: int
    sha256: str


def backup(data: Path, target: Path, say: Say, password: str | None = None) -> int:
    """Write everything worth keeping of the data folder to a new file; returns the number of files in it.

    `say` hears the name of each file before it is added. With a password the file is encrypted. The station may run
    meanwhile: a recording that grows is kept as far as it was when its turn came. The file is whole or not there.
    Raises BackupError if the folder is not one, the target is there already or its disk is too small, OSError.
    """
    if not data.is_dir():
        raise BackupError(f"{data} is no folder: name the station's data folder with --data-dir.")
    if target.exists():
        raise BackupError(f"{target} is there already: choose another name.")
    if is_interrupted(data):
        raise BackupError(f"A change of the format of {data} was interrupted: start the station once, then try again.")
    needed, free = sum(needed_bytes(data).values()), shutil.disk_usage(target.parent).free
    if needed > free:
        raise BackupError(
            f"The backup needs {needed / 1e6:.0f} MB, and the disk of {target.parent} has {free / 1e6:.0f} MB free: "
            "free it, or choose another disk."
        )
    part = target.with_name(f".{target.name}.part")
    part.unlink(missing_ok=True)
    try:
        # Ours alone from its first byte: it holds private keys.
        with (
            _minding_a_full_disk(target.parent),
            open(part, "xb", opener=lambda path, flags: os.open(path, flags, 0o600)) as file,
        ):
            count = _write(data, file, part, say, password)
            file.flush()
            os.fsync(file.fileno())
        part.replace(target)
        sync_folder(target.parent)
    finally:
        part.unlink(missing_ok=True)
    return count


def needed_bytes(data: Path) -> dict[str, int]:
    """The size of each file that a backup would hold now, by its name in the archive. Raises OSError."""
    return {path.relative_to(data).as_posix(): path.stat().st_size for path in _worth_keeping(data, None)}


def is_encrypted(source: Path) -> bool:
    """Whether a backup asks for a password. Raises OSError."""
    from epf_gcs.backup import age_archive  # noqa: PLC0415 - loads cryptography

    with source.open("rb") as file:
        return age_archive.is_encrypted(file)


def restore(source: Path, data: Path, say: Say, password: str | None = None) -> Path | None:
    """Make the data folder what it was. Returns where the folder that was there before is kept, None if none was.

    Everything is unpacked beside the folder and proven first; then both change places. Raises BackupError if the
    file is not a whole backup or the password is wrong, OSError. No station may run with this folder (the caller sees
    to it).
    """
    data.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=data.parent, prefix=f".{data.name}-restored-") as made:
        fresh = Path(made) / "data"
        fresh.mkdir(mode=0o700)
        with _minding_a_full_disk(data.parent):
            _unpack(source, fresh, say, password)
        _prove(source, fresh)
        (fresh / LIST).unlink()
        _prove_readable(source, fresh)
        if hasattr(os, "sync"):
            os.sync()  # what takes the old folder's place survives a power cut
        kept = None
        if data.exists() and any(data.iterdir()):
            kept = data.with_name(f"{data.name}-before-{time.strftime('%Y%m%dT%H%M%SZ', time.gmtime())}")
            data.rename(kept)
        elif data.exists():
            data.rmdir()
        fresh.rename(data)
        sync_folder(data.parent)
    return kept


@contextlib.contextmanager
def _minding_a_full_disk(folder: Path) -> Iterator[None]:
    try:
        yield
    except OSError as error:
        if error.errno not in (errno.ENOSPC, errno.EDQUOT):
            raise
        raise BackupError(f"The disk of {folder} is full: nothing was made or changed. Free it, then again.") from error


def _write(data: Path, file: BinaryIO, part: Path, say: Say, password: str | None) -> int:
    if password is None:
        return _write_archive(data, file, part, say)
    from epf_gcs.backup.age_archive import EncryptedWriter  # noqa: PLC0415 - loads cryptography

    encrypted = EncryptedWriter(file, password)
    count = _write_archive(data, cast(BinaryIO, encrypted), part, say)
    encrypted.finish()
    return count


def _write_archive(data: Path, file: BinaryIO, part: Path, say: Say) -> int:
    try:
        found = read_format(data)
    except ValueError:
        found = None  # the station keeps such a file aside
    listed: dict[str, ListedFile] = {}
    with tarfile.open(fileobj=file, mode="w|", format=tarfile.PAX_FORMAT) as archive:
        for path in _worth_keeping(data, part):
            name = path.relative_to(data).as_posix()
            say(name)
            listed[name] = _add(archive, path, name)
        _add_list(archive, listed, None if found is None else found.number)
    return len(listed)


def _unpack(source: Path, fresh: Path, say: Say, password: str | None) -> None:
    with source.open("rb") as file:
        plain: BinaryIO = file
        if is_encrypted(source):
            if password is None:
                raise BackupError(f"{source} is encrypted: give its password.")
            from epf_gcs.backup.age_archive import EncryptedReader  # noqa: PLC0415 - loads cryptography

            plain = cast(BinaryIO, EncryptedReader(file, password, str(source)))
        try:
            with tarfile.open(fileobj=plain, mode="r|") as archive:
                archive.extractall(fresh, members=_named(archive, say), **FILTER)  # noqa: S202 (see FILTER)
        except (tarfile.TarError, EOFError) as error:
            raise _not_whole(source, str(error)) from error
        while plain.read(_BLOCK_BYTES):  # an encrypted file is whole only if its end is
            pass


def _worth_keeping(data: Path, part: Path | None) -> Iterator[Path]:
    for path in sorted(data.rglob("*")):
        names = path.relative_to(data).parts
        if names[0] in _LEFT_OUT or path == part or path.is_symlink() or not path.is_file():
            continue
        if not path.name.endswith(_DATABASE_MARKS) and not path.name.endswith((".new", ".part", PACKING)):
            yield path


def _add(archive: tarfile.TarFile, path: Path, name: str) -> ListedFile:
    """Add a file as it is now; returns its line in the list."""
    if path.suffix == ".sqlite":
        with tempfile.TemporaryDirectory() as folder:
            return _add_file(archive, _still(path, Path(folder) / "still.sqlite"), name)
    return _add_file(archive, path, name)


def _still(path: Path, copy: Path) -> Path:
    """A copy of a database that is whole even while somebody writes to it."""
    with contextlib.closing(sqlite3.connect(path)) as source, contextlib.closing(sqlite3.connect(copy)) as target:
        source.backup(target)
    copy.chmod(path.stat().st_mode & 0o777)
    return copy


def _add_file(archive: tarfile.TarFile, path: Path, name: str) -> ListedFile:
    with path.open("rb") as file:
        entry = archive.gettarinfo(arcname=name, fileobj=file)
        reader = _HashingReader(file, entry.size)
        archive.addfile(entry, reader)
    return ListedFile(entry.size, reader.digest.hexdigest())


class _HashingReader:
    """Reads as many bytes as were announced, and hashes them."""

    def __init__(self, file: BinaryIO, size: int) -> None:
        self._file = file
        self._left = size
        self.digest = hashlib.sha256()

    def read(self, size: int = -1) -> bytes:
        data = self._file.read(self._left if size < 0 else min(size, self._left))
        self._left -= len(data)
        self.digest.update(data)
        return data


def _add_list(archive: tarfile.TarFile, listed: dict[str, ListedFile], number: int | None) -> None:
    text = orjson.dumps({"version": __version__, "format": number, "made_t_s": int(time.time()), "files": listed})
    entry = tarfile.TarInfo(LIST)
    entry.size, entry.mtime = len(text), int(time.time())
    archive.addfile(entry, io.BytesIO(text))


def _named(archive: tarfile.TarFile, say: Say) -> Iterator[tarfile.TarInfo]:
    for member in archive:
        if not member.isreg():
            raise tarfile.TarError(f"{member.name} is no file")
        path = PurePosixPath(member.name)
        if path.is_absolute() or ".." in path.parts:
            raise tarfile.TarError(f"{member.name} lies outside")
        say(member.name)
        yield member


def _prove(source: Path, fresh: Path) -> None:
    """Raises BackupError unless the folder holds exactly what its list says."""
    try:
        if (fresh / LIST).stat().st_size > _MOST_LIST_BYTES:
            raise _not_whole(source, "its list is too long")
        files = orjson.loads((fresh / LIST).read_bytes())["files"]
        listed = {str(PurePosixPath(name)): (int(one["bytes"]), str(one["sha256"])) for name, one in files.items()}
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise _not_whole(source, "its list of files is missing") from error
    there = {path.relative_to(fresh).as_posix() for path in fresh.rglob("*") if path.is_file()} - {LIST}
    if there != set(listed):
        raise _not_whole(source, "files are missing or too many")
    for name, (size, digest) in listed.items():
        if (fresh / name).stat().st_size != size or _digest(fresh / name) != digest:
            raise _not_whole(source, f"{name} is damaged")


def _prove_readable(source: Path, fresh: Path) -> None:
    """Raises BackupError if a newer version made it; an older one's folder is brought up to date at the next start."""
    try:
        found = read_format(fresh)
    except ValueError:
        return  # the station keeps such a file aside
    if found is not None and found.number > FORMAT:
        raise BackupError(
            f"{source} is of epf-gcs {found.written_by} (format {found.number}); this is {__version__}, which knows "
            f"format {FORMAT}. Nothing was changed: install that version or a newer one first."
        )


def _digest(path: Path) -> str:
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def _not_whole(source: Path, why: str) -> BackupError:
    return BackupError(f"{source} is not a whole backup of a station ({why}): nothing was changed.")
