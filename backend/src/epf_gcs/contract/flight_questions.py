"""What the library asks the query program of one flight (`python -m epf_gcs.flights serve`), each a value."""

from __future__ import annotations

from typing import Literal

import msgspec


class FlightQuestion(msgspec.Struct, frozen=True, tag_field="do"):
    """The base of all questions. `growing`: the flight is being recorded."""

    flight: str
    growing: bool


class EventsQuestion(FlightQuestion, frozen=True, tag="events"):
    """All events: `FlightEvents`."""


class TopicsQuestion(FlightQuestion, frozen=True, tag="topics"):
    """The topics with their fields: `FlightTopics`."""


class SpanQuestion(FlightQuestion, frozen=True, tag="span"):
    """When it began and ended: `FlightTimes`."""


class SignalsQuestion(FlightQuestion, frozen=True, tag="signals"):
    """Signals (names with commas between them) of a stretch in about `points` steps: `Signals`, or an Arrow stream."""

    names: str
    from_s: float | None
    to_s: float | None
    points: int
    arrow: bool


class OverviewQuestion(FlightQuestion, frozen=True, tag="overview"):
    """The altitude at so many even steps: `FlightOverview`."""

    points: int


class TrackQuestion(FlightQuestion, frozen=True, tag="track"):
    """The flown track, of at most about so many points: bytes of `formats.track_points`."""

    source: Literal["flight", "hil"]
    points: int | None


class PathQuestion(FlightQuestion, frozen=True, tag="path"):
    """The flown track as at most so many places: `FlownPath`."""

    source: Literal["flight", "hil"]
    most: int


class KnownQuestion(FlightQuestion, frozen=True, tag="known"):
    """Identity, gains and plans as they were known at a moment: `FlightKnowledge`."""

    at_s: float


AnyFlightQuestion = (
    EventsQuestion
    | TopicsQuestion
    | SpanQuestion
    | SignalsQuestion
    | OverviewQuestion
    | TrackQuestion
    | PathQuestion
    | KnownQuestion
)
