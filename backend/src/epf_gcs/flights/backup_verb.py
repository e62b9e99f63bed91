"""`backup DATA OUT`: writes the station's data folder to one file, encrypted with the password on standard input.

`OUT` is whole or not there. It says {"bytes"}.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from epf_gcs.backup.archive import backup, needed_bytes
from epf_gcs.backup.errors import BackupError
from epf_gcs.errors import ConflictError, GatewayError
from epf_gcs.flights.export.asked import RESERVE_BYTES
from epf_gcs.flights.room import FreeBytes, free_bytes_of
from epf_gcs.flights.worker import Say, secret


def run(
    arguments: list[str],
    say: Say,
    password: Callable[[], str] = secret,
    free_bytes: FreeBytes = free_bytes_of,
) -> dict[str, int]:
    """Raises GatewayError."""
    data, target = Path(arguments[0]), Path(arguments[1])
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        progress = _Progress(needed_bytes(data), say, lambda: free_bytes(target.parent))
        backup(data, target, progress.file_begins, password())
        return {"bytes": target.stat().st_size}
    except BackupError as error:
        raise _not_written(str(error)) from error
    except OSError as error:
        raise _not_written(error.strerror or str(error)) from error


class _Progress:
    """Tells the share of the bytes that are written, and ends the backup before the disk is full."""

    def __init__(self, sizes: dict[str, int], say: Say, free_bytes: Callable[[], int]) -> None:
        """`sizes`: bytes of each file, by name. Raises ConflictError if they do not fit, OSError."""
        self._sizes = sizes
        self._say = say
        self._free_bytes = free_bytes
        self._left = self._whole = sum(sizes.values())
        self._begun = 0
        self._check_room()

    def file_begins(self, name: str) -> None:
        """The file before it is written. Raises ConflictError, OSError."""
        self._left -= self._begun
        self._begun = self._sizes.get(name, 0)
        self._check_room()
        self._say(1.0 - self._left / self._whole if self._whole else 0.0, "backup")

    def _check_room(self) -> None:
        free = self._free_bytes()
        if free < self._left + RESERVE_BYTES:
            numbers = {
                "needed_mb": self._left // 1_000_000,
                "free_mb": free // 1_000_000,
                "reserve_mb": RESERVE_BYTES // 1_000_000,
            }
            raise ConflictError(
                "backup_disk_full",
                "The backup needs {needed_mb} MB: {free_mb} MB are free, and {reserve_mb} MB of them are kept for "
                "flights. Free the disk.".format(**numbers),
                **numbers,
            )


def _not_written(why: str) -> GatewayError:
    return GatewayError("backup_not_written", f"The backup could not be written ({why}).", why=why)
