"""What is known of a flight as a whole, as metadata of an exported file: whose it is, its gains and its plans."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path

import orjson

from epf_gcs.flights.export.plans import plans_at
from epf_gcs.recordings.notes import IDENTITY, PARAMETERS
from epf_gcs.recordings.reading import notes_of
from epf_gcs.vehicle.noted import gains_of, newest_identity


def flight_facts(recording: Path, until_ns: int) -> dict[str, dict[str, str]]:
    """Names of metadata with their texts, as known at `until_ns` (Unix ns). Raises RecordingError, OSError."""
    noted = [note for note in notes_of(recording) if note.t_ns <= until_ns]
    identity = newest_identity(note.content for note in noted if note.name == IDENTITY)
    gains: dict[str, str] = {}
    for note in noted:
        if note.name == PARAMETERS and isinstance(note.content, dict):
            gains = {one.name: f"{one.value:g}" for one in gains_of(note.content) if one.value is not None}
    plans = {
        name: orjson.dumps([asdict(waypoint) for waypoint in waypoints]).decode()
        for name, waypoints in plans_at(noted, until_ns).items()
    }
    who = {name: str(value) for name, value in asdict(identity).items() if value is not None}
    facts = {"flight": {"id": recording.stem, **who}, "gains": gains, "plans": plans}
    return {name: values for name, values in facts.items() if values}
