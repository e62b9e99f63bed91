"""Records until the disk is full, then makes room: run where FOLDER is a small disk of its own.

`python -m tests.flight.recording.on_a_small_disk FOLDER` prints what it said and what its files hold as JSON, at last.
"""

from __future__ import annotations

import json
import sys
from functools import partial
from pathlib import Path

from epf_gcs.contract.answers import DiskPolicy
from epf_gcs.flight.clock.line_clock import LineClock
from epf_gcs.flight.recording.recorder import Recorder
from epf_gcs.recordings.notes import LOST
from epf_gcs.recordings.reading import notes_of, read_file
from epf_gcs.recordings.topics import BOARD_RECEIVED
from tests.support.waiting import eventually

_PIECE = b"x" * 120_000
_BALLAST_BYTES = 400_000


def main(folder: Path) -> None:
    """Fill, free, go on."""
    ballast = folder / "ballast"
    ballast.write_bytes(bytes(_BALLAST_BYTES))
    recordings = folder / "recordings"
    recorder = Recorder(recordings, LineClock(), "test", retry_s=0.0, told_s=0.0, least_bytes=0)
    recorder.policy = DiskPolicy(keep_free_bytes=0)
    recorder.start()
    given = 0
    while recorder.failure is None:
        recorder.board_tap.received(_PIECE)
        given += len(_PIECE)
        eventually(partial(_is_accounted, recorder, recordings, given), "it is written or counted")
    failure = recorder.failure
    ballast.unlink()
    recorder.board_tap.received(b"after")
    eventually(lambda: recorder.failure is None and recorder.file is not None, "it records again")
    recorder.stop()
    lost = [note.content for file in _files(recordings) for note in notes_of(file) if note.name == LOST]
    found = {"failure": failure, "given": given + 5, "held": _held(recordings), "lost": recorder.bytes_lost}
    print(json.dumps({**found, "noted": lost}))


def _is_accounted(recorder: Recorder, recordings: Path, given: int) -> bool:
    return _held(recordings) + recorder.bytes_lost >= given


def _files(recordings: Path) -> list[Path]:
    return sorted(recordings.glob("*.mcap"))


def _held(recordings: Path) -> int:
    """Bytes of the board in all files, read as anybody would read them."""
    held = 0
    for file in _files(recordings):
        messages = read_file(file).messages
        held += int(messages.length[messages.channel == BOARD_RECEIVED].sum())
    return held


if __name__ == "__main__":
    main(Path(sys.argv[1]))
