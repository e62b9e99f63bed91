"""Marks that people set: they stand among all kinds of events that a flight can have."""

from __future__ import annotations

from typing import Any, get_args

import orjson

from epf_gcs.contract.flights import EventKind
from epf_gcs.flights.events import as_answer, find_events
from epf_gcs.library.about import About, KeptMark
from epf_gcs.library.marks import add, change, with_marks
from epf_gcs.recordings import notes
from epf_gcs.recordings.notes import Note
from tests.flights.test_events import START_NS, MadeFlight


def events_with(event: str, **data: Any) -> bytes:
    flight = MadeFlight({}, [Note(START_NS, notes.EVENT, {"event": event, "data": data})])
    return orjson.dumps(as_answer(find_events(flight, [], []), START_NS))


def test_a_mark_can_be_set_in_a_flight_whose_simulator_jumped() -> None:
    jumped = events_with("simulator_jumped", distance_m=900.0)
    about = add(About(), KeptMark("m1", "here", START_NS * 1e-9 + 2.0, 2.0, "Ana"))
    found = with_marks(jumped, about).events
    assert [(event.kind, event.at_s) for event in found] == [("jump", 0.0), ("mark", 2.0)]
    assert {event.kind for event in found} <= set(get_args(EventKind))
    assert found[1].data == {"text": "here", "by": "Ana"}


def test_a_mark_of_the_recording_gets_other_words_or_is_hidden_and_one_set_later_goes() -> None:
    flight = MadeFlight({}, [Note(START_NS, notes.MARK, {"text": "recorded", "by": None, "id": "m1"})])
    recorded = orjson.dumps(as_answer(find_events(flight, [], []), START_NS))
    said = change(About(), "m1", "other words")
    assert [event.data["text"] for event in with_marks(recorded, said).events] == ["other words"]
    assert with_marks(recorded, change(said, "m1", None)).events == []
    later = add(About(), KeptMark("m2", "later", 1.0, 1.0))
    assert change(later, "m2", "other").marks == [KeptMark("m2", "other", 1.0, 1.0)]
    assert change(later, "m2", None).marks == []


def test_what_is_said_of_a_flight_is_kept_as_earlier_versions_wrote_it() -> None:
    kept = b"""{"title": "Gando", "tags": ["a"], "notes": "", "pinned": true, "imported": false, "marks": [
        {"id": "m1", "t_s": 5.0, "at_s": 1.0, "text": "here", "by": null},
        {"id": "m2", "recorded": true, "hidden": true, "text": ""}], "deleted_s": null, "came_damaged": ""}"""
    about = About.from_json(kept)
    assert about.marks == [KeptMark("m1", "here", 5.0, 1.0), KeptMark("m2", recorded=True, hidden=True)]
    assert About.from_json(about.as_json()) == about
