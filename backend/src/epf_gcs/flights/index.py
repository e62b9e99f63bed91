"""`index FILE`: makes the columns of a recording of this data folder, its events and the figures of its row."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Final

from epf_gcs.errors import InvalidInputError
from epf_gcs.flights.columns import write_columns
from epf_gcs.flights.events import FILE, find_events, write_events
from epf_gcs.flights.fingerprint import Fingerprint
from epf_gcs.flights.indexed import Columns, IndexedFlight
from epf_gcs.flights.room import minding_room
from epf_gcs.flights.summary import summarise
from epf_gcs.flights.worker import Say
from epf_gcs.recordings.flight_summary import write_summary
from epf_gcs.recordings.notes import REPAIRED, Note
from epf_gcs.recordings.places import stamp_of
from epf_gcs.recordings.table_names import DAMAGE

_COLUMNS: Final = "columns"
# The share of the columns in the time that the whole takes.
_SHARE: Final = 0.9
# More than what recording asks for by default, so that columns never stop it.
_RESERVE_BYTES: Final = 1_200_000_000


def run(arguments: list[str], say: Say) -> dict[str, str | int]:
    """The columns go beside the folder that holds the recording. Raises GatewayError and OSError."""
    (path,) = (Path(argument).resolve() for argument in arguments)
    say = minding_room(say, path, _RESERVE_BYTES)
    # Before the file is read: if it changes meanwhile, what is made of it is stale at once.
    stamp = stamp_of(path)
    fingerprint = Fingerprint()
    written = write_columns(
        path,
        path.parent.parent / _COLUMNS,
        lambda progress, doing: say(progress * _SHARE, doing),
        watch=fingerprint.add,
    )
    counts = written.counts
    if counts.first_ns is None or counts.last_ns is None:
        raise InvalidInputError("recording_empty", "This recording holds no message.")
    say(_SHARE, "events")
    flight = IndexedFlight(written.folder, written.notes, counts.first_ns, counts.last_ns, columns=Columns())
    events = find_events(flight, counts.gaps, flight.damage(DAMAGE))
    write_events(written.folder / FILE, events)
    say(0.97, "figures")
    summary = replace(
        summarise(flight, events),
        stamp=stamp,
        frames=counts.frames_heard,
        frames_damaged=counts.frames_damaged,
        gaps=counts.gaps,
        is_whole=counts.is_whole,
        damage=" ".join(sentence for sentence in (counts.damage, _repaired(written.notes)) if sentence) or None,
        fingerprint=fingerprint.text(),
    )
    write_summary(written.folder, summary)
    return {"folder": str(written.folder), "frames": counts.frames_heard}


def _repaired(noted: list[Note]) -> str:
    """What was cut off this recording since its writer was ended, as a sentence; "" if nothing was."""
    contents = [note.content for note in noted if note.name == REPAIRED and isinstance(note.content, dict)]
    cut = sum(count for content in contents if isinstance(count := content.get("bytes_cut"), int))
    return (
        f"The station was ended without warning: the last {cut} bytes were incomplete and were cut off." if cut else ""
    )
