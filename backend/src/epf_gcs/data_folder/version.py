"""The format of a data folder: a number in a small file, and who wrote the folder last.

Version 0.1.0 and 1.0.0 wrote no such file: their folders are of format 1.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from epf_gcs import __version__
from epf_gcs.data_folder.lock import FORMAT_FILE, LOCK_FILES
from epf_gcs.disk import KeptFile, set_aside

FORMAT: Final = 2
"""What this version reads and writes."""
FILE: Final = FORMAT_FILE
_UNNUMBERED: Final = 1
_OF_THE_LAUNCHER: Final = LOCK_FILES | {"run.lock", "logs", "card", "board.pty"}

Say = Callable[[str], None]
"""Told one sentence for the person who starts the station."""


class FormatError(Exception):
    """The folder cannot be used by this version: one sentence that says why, and what to do."""


@dataclass(frozen=True, slots=True)
class Format:
    """`written_by` is the version of epf-gcs that used the folder last, "" if nobody said."""

    number: int
    written_by: str = ""


def read_format(folder: Path) -> Format | None:
    """The folder's format; None for a folder that holds nothing yet, or is not there.

    Raises ValueError if its file makes no sense, OSError.
    """
    return _file(folder).read() or (Format(_UNNUMBERED) if _holds_anything(folder) else None)


def write_format(folder: Path, number: int, written_by: str = __version__) -> None:
    """Write it: after a power cut the old or the new file is there. Raises OSError."""
    _file(folder).write(Format(number, written_by))


def usable_format(folder: Path, say: Say) -> Format | None:
    """The folder's format, at most ours. Raises FormatError for a newer one, OSError.

    A file that makes no sense is kept aside: whoever wrote it had brought the folder up to date, so it counts as ours.
    """
    try:
        found = read_format(folder)
    except ValueError as error:
        kept = set_aside(folder / FILE)
        say(
            f"The data folder {folder} does not say what format it has ({error}): it is taken for format {FORMAT}, and "
            f"the file is kept as {kept.name}."
        )
        write_format(folder, FORMAT)
        return Format(FORMAT, __version__)
    if found is not None and found.number > FORMAT:
        raise FormatError(newer(folder, found))
    return found


def newer(folder: Path, found: Format) -> str:
    """The sentence about a folder that a newer version has written."""
    who = f"epf-gcs {found.written_by}" if found.written_by else "a newer epf-gcs"
    return (
        f"The data folder {folder} was written by {who} (format {found.number}); this is epf-gcs {__version__}, which "
        f"knows format {FORMAT}. Nothing was changed. Install that version or a newer one; or, to go back, run its "
        "`epf-gcs downgrade`, or restore a backup from before; or start with another folder by --data-dir."
    )


def _file(folder: Path) -> KeptFile[Format]:
    return KeptFile(folder / FILE, _decode, _encode)


def _decode(text: bytes) -> Format:
    found = json.loads(text)
    if type(found["format"]) is not int or found["format"] < 1:
        raise ValueError("it names no format")
    return Format(found["format"], str(found.get("epf_gcs", "")))


def _encode(found: Format) -> bytes:
    return f"{json.dumps({'format': found.number, 'epf_gcs': found.written_by}, indent=2)}\n".encode()


def _holds_anything(folder: Path) -> bool:
    # What the launcher makes before the folder is looked at.
    try:
        return any(path.name not in _OF_THE_LAUNCHER for path in folder.iterdir())
    except FileNotFoundError:
        return False
