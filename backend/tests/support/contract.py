"""Values of the contract that many tests need."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Final, TypeVar

import orjson
from pydantic import TypeAdapter

from epf_gcs.contract.events import Event
from epf_gcs.contract.playback import Playback

T = TypeVar("T")

_STANDS: Final = Playback("20260101T000000Z", 0.0, 1000.0, "paused", 1.0, None, 60.0, 60.0, 0)


def a_playback(**changes: Any) -> Playback:
    """A replay of a minute that stands at its start, but for the changes."""
    return replace(_STANDS, **changes)


def as_told(event: Event) -> tuple[str, dict[str, Any]]:
    """The name of an event, and its data as a page gets them."""
    return event.NAME, orjson.loads(orjson.dumps(event))


def read_as(kind: type[T], value: Any) -> T:
    """What the interface sent, as this type of the contract; fails for a field too many or too few."""
    return TypeAdapter(kind).validate_python(value)
