"""Events as types: one class for each name, what every page is told, and what a recording gives back."""

from __future__ import annotations

import re
from typing import Any

import pytest

from epf_gcs.contract.answers import GainState, JournalEntry, ParameterMove
from epf_gcs.contract.events import (
    EVENTS,
    CommandEvent,
    ControlEvent,
    Event,
    JournalEvent,
    ParameterEvent,
    noted_event,
)
from epf_gcs.web import docs
from epf_gcs.web.interface import events
from tests.support.contract import as_told

COMMAND = CommandEvent(7, "reset", [1.0], "c1", "rejected", "acknowledgement", 9.5, "bad_state")


def test_every_event_of_the_contract_has_a_name_of_its_own() -> None:
    kinds = {kind.__name__ for kind in Event.__subclasses__() if kind.__module__ == Event.__module__}
    assert {kind.__name__ for kind in EVENTS.values()} == kinds
    assert {name: kind.NAME for name, kind in EVENTS.items()} == {name: name for name in EVENTS}


def test_the_documentation_names_the_events_of_the_stream() -> None:
    told = docs._DESCRIPTION.partition("**Events**")[2]
    quiet = {"access", "advice", "board_restarted", "checklist", "mark", "simulator_jumped", "surroundings"}
    assert set(events.EVENTS) - quiet <= set(re.findall(r"`(\w+)`", told))


@pytest.mark.parametrize(
    "event",
    [
        COMMAND,
        ParameterEvent({"k_roll": GainState(1.5, "confirmed", None)}),
        JournalEvent(
            JournalEntry(1, 2.5, None, None, "write", "confirmed", ()), (ParameterMove("k_roll", 1.0, 2.0),), None
        ),
    ],
)
def test_an_event_comes_out_of_a_recording_as_it_was_told(event: Event) -> None:
    assert noted_event(*as_told(event)) == event


def test_an_event_of_an_older_recording_says_not_known_where_it_has_nothing() -> None:
    data = {"id": 7, "name": "reset", "value": [1.0], "client": "c1", "state": "sent"}
    assert noted_event("command", data) == CommandEvent(7, "reset", [1.0], "c1", "sent")
    assert noted_event("control", {"client": "c1", "name": "Ana"}) == ControlEvent("c1", "Ana")


@pytest.mark.parametrize(
    ("name", "changes"),
    [("added_later", {}), ("command", {"state": "odd"}), ("command", {"value": "all"}), ("command", {"id": None})],
)
def test_an_event_that_is_not_as_agreed_is_none(name: str, changes: dict[str, Any]) -> None:
    assert noted_event(name, as_told(COMMAND)[1] | changes) is None
