"""Marks that people set after the flight, or changed: they lie beside the recording, which stays as it is."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from epf_gcs.errors import NotFoundError
from epf_gcs.library.about import About


def with_marks(found: dict[str, Any], about: About) -> dict[str, Any]:
    """The events of a flight with the marks as people left them."""
    said = {mark["id"]: mark for mark in about.marks}
    events = []
    for event in found["events"]:
        change = said.get(event["id"]) if event["kind"] == "mark" else None
        if change is None:
            events.append(event)
        elif not change.get("hidden", False):
            events.append({**event, "data": {**event["data"], "text": change["text"]}})
    added = [_as_event(mark) for mark in about.marks if not mark.get("recorded", False)]
    return {"events": sorted([*events, *added], key=lambda event: event["t_s"])}


def add(about: About, mark_id: str, at_s: float, t_s: float, text: str, by: str | None) -> About:
    """With one mark more."""
    mark = {"id": mark_id, "t_s": t_s, "at_s": at_s, "text": text, "by": by}
    return replace(about, marks=[*about.marks, mark])


def change(about: About, mark: dict[str, Any], text: str | None) -> About:
    """With a mark's words changed, or without it where `text` is None. `mark` is its event."""
    others = [one for one in about.marks if one["id"] != mark["id"]]
    mine = next((one for one in about.marks if one["id"] == mark["id"]), None)
    if mine is not None and not mine.get("recorded", False):
        kept = [] if text is None else [{**mine, "text": text}]
    else:
        # It stands in the recording: what is said here takes its place, or hides it.
        kept = [{"id": mark["id"], "recorded": True, "hidden": text is None, "text": text or ""}]
    return replace(about, marks=[*others, *kept])


def find(events: dict[str, Any], mark_id: str) -> dict[str, Any]:
    """The event of a mark. Raises NotFoundError."""
    for event in events["events"]:
        if event["kind"] == "mark" and event["id"] == mark_id:
            return dict(event)
    raise NotFoundError("mark_unknown", f"This flight has no mark '{mark_id}': load its events again.", mark=mark_id)


def _as_event(mark: dict[str, Any]) -> dict[str, Any]:
    return {
        "t_s": mark["t_s"],
        "at_s": mark["at_s"],
        "kind": "mark",
        "name": "",
        "id": mark["id"],
        "data": {"text": mark["text"], "by": mark.get("by")},
        "until_s": None,
    }
