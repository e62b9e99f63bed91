"""Room on the disk: no work on a recording may stop the recording of a flight."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

from epf_gcs.errors import ConflictError
from epf_gcs.flights.worker import Say

FreeBytes = Callable[[Path], int]


def free_bytes_of(path: Path) -> int:
    """Free space on the disk of a folder. Raises OSError."""
    return shutil.disk_usage(path).free


def check_room(folder: Path, name: str, reserve_bytes: int, free_bytes: FreeBytes = free_bytes_of) -> None:
    """Raises ConflictError where less than `reserve_bytes` are free, OSError where that cannot be told."""
    free = free_bytes(folder)
    if free < reserve_bytes:
        raise ConflictError(
            "flight_disk_full",
            f"'{name}' does not fit: {free // 1_000_000} MB are free, and {reserve_bytes // 1_000_000} MB of them are "
            "kept for flights. Free the disk.",
            name=name,
            free_mb=free // 1_000_000,
            reserve_mb=reserve_bytes // 1_000_000,
        )


def minding_room(say: Say, recording: Path, reserve_bytes: int) -> Say:
    """`say`, which ends the work on a recording with ConflictError while the disk still has this much room."""

    def say_with_room(progress: float, doing: str) -> None:
        check_room(recording.parent, recording.stem, reserve_bytes)
        say(progress, doing)

    say_with_room(0.0, "waiting")
    return say_with_room
