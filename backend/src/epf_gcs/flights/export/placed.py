"""Marks, alarms and waypoints passed of a flight, at the places of its tracks."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np

from epf_gcs.flights.events import Event
from epf_gcs.flights.export.flown import FlownLine
from epf_gcs.flights.report.words import words
from epf_gcs.formats.kml_words import WORDS, Language
from epf_gcs.formats.placed_event import PlacedEvent, PlacedKind

_KINDS: Final[dict[str, PlacedKind]] = {"mark": "mark", "alarm": "alarm", "waypoint": "waypoint"}


def placed_events(events: list[Event], lines: Sequence[FlownLine], language: Language) -> list[PlacedEvent]:
    """In order of time; each on the first of the lines that was flown at its time, left out if none was."""
    chosen = sorted((event for event in events if event.kind in _KINDS), key=lambda event: event.t_ns)
    t_s = np.array([event.t_ns * 1e-9 for event in chosen])
    places = np.full((3, len(chosen)), np.nan)
    for line in lines:
        before: np.ndarray[tuple[int, int], np.dtype[np.float64]] | None = None
        for samples in line:
            rows = np.stack(samples[:4])
            # With the last row before, so that nothing falls between two parts.
            rows = rows if before is None else np.concatenate((before, rows), axis=1)
            inside = np.isnan(places[0]) & (t_s >= rows[0, 0]) & (t_s <= rows[0, -1])
            places[:, inside] = [np.interp(t_s[inside], rows[0], column) for column in rows[1:]]
            before = rows[:, -1:]
    return [
        PlacedEvent(at_s, latitude, longitude, altitude, _KINDS[event.kind], _name(event, language))
        for event, at_s, (latitude, longitude, altitude) in zip(chosen, t_s.tolist(), places.T.tolist(), strict=True)
        if not np.isnan(latitude)
    ]


def _name(event: Event, language: Language) -> str:
    said = WORDS[language]
    match event.kind:
        case "mark":
            return str(event.data.get("text") or said.mark)
        case "alarm":
            return str(words(language)["alarmNames"].get(event.name) or event.data.get("text") or event.name)
    return f"{said.waypoint} {event.data.get('from')} \u2192 {event.data.get('to')}"
