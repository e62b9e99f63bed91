"""The password of a backup: how long it must be, and how a file gives it."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from epf_gcs.backup.errors import BackupError

SHORTEST: Final = 10
"""Characters. Whoever has the file can try passwords for as long as they like."""
LONGEST: Final = 200


def check_password(password: str) -> str:
    """The password itself. Raises BackupError if it is too short or too long."""
    if not SHORTEST <= len(password) <= LONGEST:
        raise BackupError(f"A password of a backup has {SHORTEST} to {LONGEST} characters: choose another one.")
    return password


def password_in(file: Path) -> str:
    """The first line of a file, without its end. Raises BackupError, OSError."""
    try:
        with file.open(encoding="utf-8") as text:
            return check_password(text.readline(4 * LONGEST).rstrip("\r\n"))
    except UnicodeDecodeError as error:
        raise BackupError(f"{file} is no text in UTF-8: write the password into its first line.") from error
