"""`pack FILE`: packs a finished recording in its own place. One that is cut, damaged or packed already is left."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from epf_gcs.flights.room import minding_room
from epf_gcs.flights.worker import Say
from epf_gcs.recordings.limits import RecordingError
from epf_gcs.recordings.packing import pack

# Packing takes room for a moment and gives more back, so it may go on where recording has stopped for want of room.
_RESERVE_BYTES: Final = 300_000_000
_LEFT: Final = ("recording_changed", "recording_not_whole")


def run(arguments: list[str], say: Say) -> dict[str, int]:
    """Raises RecordingError, ConflictError and OSError; the recording is then as it was."""
    (path,) = (Path(argument).resolve() for argument in arguments)
    say = minding_room(say, path, _RESERVE_BYTES)
    try:
        packed = pack(path, progress=lambda share: say(share, "packing"))
    except RecordingError as error:
        if error.code not in _LEFT:
            raise
        size = path.stat().st_size
        return {"bytes_before": size, "bytes_after": size}
    return {"bytes_before": packed.bytes_before, "bytes_after": packed.bytes_after}
