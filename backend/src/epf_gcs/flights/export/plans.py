"""The plans that a recording notes, as they were at a moment. What a stranger's note holds is not believed."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, Final

from epf_gcs.codec.tables import Waypoint
from epf_gcs.formats.mission_file import MAX_WAYPOINTS
from epf_gcs.recordings.notes import PLAN, Note

_NAMES: Final = ("flight", "hil")
_FIELDS: Final = ("latitude_deg", "longitude_deg", "altitude_ft", "speed_kt")


def plans_at(noted: Iterable[Note], until_ns: int) -> dict[str, list[Waypoint]]:
    """The waypoints of each plan that was known last at `until_ns` (Unix ns) and has any."""
    newest: dict[str, Any] = {}
    for note in noted:
        if note.name == PLAN and note.t_ns <= until_ns and isinstance(note.content, dict):
            newest[str(note.content.get("plan"))] = note.content.get("waypoints")
    found = {name: _waypoints(newest.get(name)) for name in _NAMES}
    return {name: waypoints for name, waypoints in found.items() if waypoints}


def _waypoints(rows: Any) -> list[Waypoint]:
    if not isinstance(rows, Sequence) or isinstance(rows, str):
        return []
    found = []
    for row in rows[:MAX_WAYPOINTS]:
        values = [row.get(name) if isinstance(row, dict) else None for name in _FIELDS]
        numbers = [float(value) for value in values if isinstance(value, int | float) and abs(value) < 1e9]
        if len(numbers) != len(_FIELDS) or abs(numbers[0]) > 90.0 or abs(numbers[1]) > 180.0:
            return []
        found.append(Waypoint(*numbers))
    return found
