"""What the notes of a recording say of the gains and of whose flight it is, as the contract has them.

A recording may be a stranger's: what is not as noted by a station is not known.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict, replace
from typing import Any, Final

from epf_gcs.codec.messages_gen import PARAMETERS
from epf_gcs.codec.tables import Message
from epf_gcs.contract.answers import FlightIdentity, GainState, ParameterState
from epf_gcs.contract.events import OwnGainsEvent, noted_event
from epf_gcs.recordings.notes import EVENT, Content, Note
from epf_gcs.vehicle.own_topics import known_topics, own_messages

# What is known of a gain (`vehicle/parameters.py`); another word can only come from a stranger's file.
_STATES: Final = ("unknown", "loaded", "pending", "confirmed", "rejected")


def gains_of(content: Content) -> list[ParameterState]:
    """The gains from their note ({name: {"value", "state", "loaded"}}), as GET /parameters gives them."""
    found = []
    for gain in PARAMETERS:
        given = content.get(gain.name)
        held: Content = given if isinstance(given, dict) else {}
        found.append(
            ParameterState.of(
                gain,
                GainState(
                    _number(held.get("value")),
                    held["state"] if held.get("state") in _STATES else "unknown",
                    _number(held.get("loaded")),
                ),
            )
        )
    return found


def noted_messages(note: Note) -> tuple[Message, ...] | None:
    """How the frames of the board's own topics are read from this note on; None where it says nothing of them."""
    event = own_gains_event(note)
    return None if event is None or event.table is None else own_messages(known_topics(event.table))


def own_gains_event(note: Note) -> OwnGainsEvent | None:
    """What a note says of the board's own gains; None where it says nothing of them."""
    content = note.content
    if note.name != EVENT or not isinstance(content, dict) or content.get("event") != OwnGainsEvent.NAME:
        return None
    event = noted_event(OwnGainsEvent.NAME, content["data"]) if isinstance(content.get("data"), dict) else None
    return event if isinstance(event, OwnGainsEvent) else None


def _number(value: Any) -> float | None:
    return value if isinstance(value, int | float) and not isinstance(value, bool) else None


def identity_of(content: Any) -> FlightIdentity:
    """The identity from its note; nothing is known without one."""
    given: Content = content if isinstance(content, dict) else {}
    board = given.get("board")
    name = board.get("firmware_name") if isinstance(board, dict) else board
    texts = {key: given.get(key) for key in ("station", "firmware", "aircraft", "operator")}
    clean = {key: value if isinstance(value, str) else None for key, value in texts.items()}
    return FlightIdentity(
        **clean, board=name if isinstance(name, str) else None, emulated=given.get("emulated") is True
    )


def newest_identity(contents: Iterable[Any]) -> FlightIdentity:
    """Whose flight it is by all its notes: a later one that does not say something leaves the earlier one's word."""
    known = FlightIdentity()
    for content in contents:
        newer = asdict(identity_of(content))
        known = replace(known, **{name: value for name, value in newer.items() if value})
    return known
