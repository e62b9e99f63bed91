"""Recordings of hours at the full line, made from the demonstration: a minute of it is flown and recorded, and laid end
to end. So rates, values, events and HIL are those of a flight, and only the place jumps back once a minute."""

from __future__ import annotations

import os
import signal
import sys
import tempfile
import time
from functools import cache
from pathlib import Path
from typing import Final

from epf_gcs.launcher.ports import free_tcp_port
from epf_gcs.recordings import notes
from epf_gcs.recordings.mcap_file import Tally, closing, data_end, message_record, metadata_record, opening
from epf_gcs.recordings.notes import Note, written
from epf_gcs.recordings.reading import Message, walk
from epf_gcs.recordings.topics import TOPICS
from tests.support.programs import Program
from tests.support.waiting import eventually

STARTS_NS: Final = 1_767_268_800_000_000_000
_FLOWN_S: Final = 60.0
# The demonstration loads its route and closes the loop in this time.
_BEGIN_S: Final = 8.0
_PIECE: Final = 10_000


def make_demonstration(path: Path, seconds: float) -> Path:
    """Write an unpacked recording of so many seconds, which begins at STARTS_NS; returns `path`."""
    items = _minute()
    times = [item.t_ns for item in items if isinstance(item, Message)]
    first_ns, period_ns = min(times), max(times) - min(times) + 1_000_000
    path.parent.mkdir(parents=True, exist_ok=True)
    tally = Tally()
    with path.open("wb") as file:
        file.write(opening("bench", TOPICS))
        parts: list[bytes] = []
        for lap in range(max(1, round(seconds * 1e9 / period_ns))):
            shift_ns = STARTS_NS + lap * period_ns - first_ns
            for item in items:
                if isinstance(item, Message):
                    channel, t_ns = item.channel, item.t_ns + shift_ns
                    parts.append(message_record(channel, tally.add(channel, t_ns), t_ns, item.data))
                elif lap == 0 or item.name == notes.EVENT:
                    tally.metadata_count += 1
                    parts.append(metadata_record(item.name, written(item.t_ns + shift_ns, item.content)))
                if len(parts) > _PIECE:
                    file.write(b"".join(parts))
                    parts.clear()
        file.write(b"".join(parts) + data_end())
        file.write(closing(TOPICS, tally, file.tell()))
    return path


@cache
def _minute() -> list[Message | Note]:
    """Messages and notes of a minute of the demonstration, once its loop is closed."""
    with tempfile.TemporaryDirectory(prefix="epf-gcs-demonstration-") as data:
        program = Program(
            [sys.executable, "-m", "epf_gcs.launcher", "--port", str(free_tcp_port()), "--data-dir", data],
        )
        try:
            eventually(lambda: any(Path(data).glob("recordings/*.mcap")), "the demonstration is recorded")
            time.sleep(_BEGIN_S + _FLOWN_S)
        finally:
            program.end(signal.SIGINT)
        file = max(Path(data, "recordings").glob("*.mcap"), key=os.path.getsize)
        found = list(walk(file))
    last_ns = max(item.t_ns for item in found if isinstance(item, Message))
    from_ns = last_ns - round(_FLOWN_S * 1e9)
    # What is known of the flight was noted before; what happened, only in the minute itself.
    return [item for item in found if item.t_ns >= from_ns or (isinstance(item, Note) and item.name != notes.EVENT)]
