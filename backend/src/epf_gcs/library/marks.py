"""Marks that people set after the flight, or changed: they lie beside the recording, which stays as it is."""

from __future__ import annotations

from dataclasses import replace

import msgspec

from epf_gcs.contract.flights import FlightEvent, FlightEvents
from epf_gcs.errors import NotFoundError
from epf_gcs.library.about import About, KeptMark


def with_marks(found: bytes, about: About) -> FlightEvents:
    """The events of a flight (their JSON) with the marks as people left them."""
    said = {mark.id: mark for mark in about.marks}
    events = []
    for event in msgspec.json.decode(found, type=FlightEvents).events:
        change = said.get(event.id) if event.kind == "mark" and event.id is not None else None
        if change is None:
            events.append(event)
        elif not change.hidden:
            events.append(replace(event, data={**event.data, "text": change.text}))
    added = [_as_event(mark) for mark in about.marks if not mark.recorded]
    return FlightEvents(sorted([*events, *added], key=lambda event: event.t_s))


def add(about: About, mark: KeptMark) -> About:
    """With one mark more."""
    return replace(about, marks=[*about.marks, mark])


def change(about: About, mark_id: str, text: str | None) -> About:
    """With a mark's words changed, or without it where `text` is None."""
    others = [one for one in about.marks if one.id != mark_id]
    mine = next((one for one in about.marks if one.id == mark_id), None)
    if mine is not None and not mine.recorded:
        kept = [] if text is None else [msgspec.structs.replace(mine, text=text)]
    else:
        # It stands in the recording: what is said here takes its place, or hides it.
        kept = [KeptMark(mark_id, text or "", recorded=True, hidden=text is None)]
    return replace(about, marks=[*others, *kept])


def check(events: FlightEvents, mark_id: str) -> None:
    """Raise NotFoundError where the flight has no such mark."""
    if not any(event.kind == "mark" and event.id == mark_id for event in events.events):
        raise NotFoundError(
            "mark_unknown", f"This flight has no mark '{mark_id}': load its events again.", mark=mark_id
        )


def _as_event(mark: KeptMark) -> FlightEvent:
    data = {"text": mark.text, "by": mark.by}
    return FlightEvent(mark.t_s or 0.0, mark.at_s or 0.0, "mark", "", mark.id, data, None)
