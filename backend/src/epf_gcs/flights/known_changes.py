"""Changes of what a note holds whole each time: who moves the simulator's surfaces, and the limits of alarms."""

from __future__ import annotations

from collections.abc import Iterator

from epf_gcs.recordings import notes
from epf_gcs.recordings.notes import Content, Note


def surface_paths(noted: list[Note]) -> list[tuple[int, str]]:
    """Who moved the simulator's surfaces, `assisted` (the board) or `manual` (the stick): at first, and each change
    with its time (Unix ns)."""
    found: list[tuple[int, str]] = []
    for t_ns, data in _known(noted, "hil"):
        path = data.get("path")
        if path in ("assisted", "manual") and (not found or found[-1][1] != path):
            found.append((t_ns, str(path)))
    return found


def limit_changes(noted: list[Note]) -> list[tuple[int, str, float, float]]:
    """Unix time (ns) and name of each limit that was changed, with its value before and after."""
    found: list[tuple[int, str, float, float]] = []
    known: Content = {}
    for t_ns, data in _known(noted, "limits"):
        limits = {name: value for name, value in data.items() if isinstance(value, int | float)}
        found += [(t_ns, name, known[name], value) for name, value in limits.items() if known.get(name, value) != value]
        known |= limits
    return found


def _known(noted: list[Note], event: str) -> Iterator[tuple[int, Content]]:
    for note in noted:
        content = note.content
        if note.name == notes.EVENT and isinstance(content, dict) and content.get("event") == event:
            data = content.get("data")
            if isinstance(data, dict):
                yield note.t_ns, data
