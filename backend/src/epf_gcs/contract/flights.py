"""What the library says of flights, to pages and between its programs: jobs, events, pictures.

`t_s` is Unix time in seconds; `at_s` is seconds since the flight's first message.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal, Self

from epf_gcs.contract.base import ParamValue, Shape, numbers_of
from epf_gcs.errors import ErrorCode, GatewayError

JobKind = Literal["pack", "index", "keys", "import", "export", "report", "backup"]
JobState = Literal["waiting", "running", "done", "failed", "cancelled"]
FlightState = Literal["recording", "waiting", "indexing", "indexed", "damaged", "unread"]
LogKind = Literal["ulog", "dataflash", "tlog", "csv", "mcap"]
EventKind = Literal[
    "advice",
    "alarm",
    "command",
    "console",
    "control",
    "damage",
    "fault",
    "gap",
    "jump",
    "limits",
    "link",
    "lost",
    "mark",
    "mode",
    "parameter",
    "plan",
    "restart",
    "stick",
    "waypoint",
    "wind",
]


@dataclass(frozen=True, slots=True)
class Fault(Shape):
    """Why something could not be done. `code` is stable and translated by the page."""

    code: ErrorCode
    detail: str
    params: Mapping[str, ParamValue]

    @classmethod
    def of(cls, error: GatewayError) -> Self:
        """Of an error."""
        return cls(error.code, error.detail, numbers_of(error.params))


@dataclass(frozen=True, slots=True)
class JobResult(Shape):
    """What a finished job left to be fetched from `/jobs/{id}/result`."""

    name: str
    bytes: int


@dataclass(frozen=True, slots=True)
class Job(Shape):
    """Work of a separate process. `progress` is 0 to 1; `doing` is a stable word for the step it is at.

    `flight` is null while an imported file has no id yet. `file` is the name of the file that it
    makes, null for one that makes none; `result` is null until it is made.
    """

    id: str
    kind: JobKind
    flight: str | None
    state: JobState
    progress: float
    doing: str
    file: str | None
    fault: Fault | None
    result: JobResult | None


@dataclass(frozen=True, slots=True)
class Thumbnail(Shape):
    """A small picture: `track` as [x, y] pairs with x to the east and y to the north, `altitude` evenly spaced in
    time. All values are 0 to 1; null altitudes are not known."""

    track: list[list[float]]
    altitude: list[float | None]


@dataclass(frozen=True, slots=True)
class Flight(Shape):
    """One recording. What only its content tells is null until it is indexed (`state`), and where it does not have it.

    `fault`: why a flight could not be indexed. `frames_damaged` counts what the line damaged, `damage` is a sentence
    about the file. `copies` are the ids of other files with the same content: the list leaves them out. `started_s` is
    corrected by `clock_ahead_s`, samples are not; `clock_unsure`: nobody gave the time. `log`: of what kind of another
    program's log it was made, null for a recording of a station.
    """

    id: str
    active: bool
    state: FlightState
    fault: Fault | None
    damage: str | None
    started_s: float
    clock_ahead_s: float
    clock_unsure: bool
    duration_s: float | None
    bytes: int
    frames: int | None
    frames_damaged: int | None
    board: str | None
    firmware: str | None
    station: str | None
    aircraft: str | None
    operator: str | None
    emulated: bool
    imported: bool
    log: LogKind | None
    highest_ft: float | None
    fastest_kt: float | None
    distance_nm: float | None
    waypoints: int | None
    alarms: int | None
    marks: int | None
    thumbnail: Thumbnail | None
    title: str
    tags: list[str]
    notes: str
    pinned: bool
    copies: list[str]


@dataclass(frozen=True, slots=True)
class FlightEvent(Shape):
    """Something that happened. `name` says what within its kind: a command's, alarm's, mode's or parameter's name;
    `data` is as the event of the stream has it. `until_s` is Unix time; null for a moment, or while it lasts.
    `id` is given for marks, which can be changed by it."""

    t_s: float
    at_s: float
    kind: EventKind
    name: str
    id: str | None
    data: Mapping[str, Any]
    until_s: float | None


@dataclass(frozen=True, slots=True)
class FlightEvents(Shape):
    """All events, in order of time."""

    events: list[FlightEvent]


@dataclass(frozen=True, slots=True)
class Signal(Shape):
    """One signal of the stretch that was asked for.

    `at_s[i]` is the time of step i, `min[i]` and `max[i]` the extremes in it: of every sample, so that none is lost.
    Where there are no more samples than steps, each step is a sample, and min equals max. Null is a value that the
    board did not have, or a gap in the samples. `mean` and `count` are of all samples of the stretch that have a value.
    """

    name: str
    unit: str
    at_s: list[float]
    min: list[float | None]
    max: list[float | None]
    mean: float | None
    count: int


@dataclass(frozen=True, slots=True)
class Signals(Shape):
    """The stretch, cut to the flight's, and its signals in the order they were asked for. `starts_s` is the Unix time
    of the flight's start."""

    starts_s: float
    from_s: float
    to_s: float
    signals: list[Signal]


@dataclass(frozen=True, slots=True)
class TopicField(Shape):
    """A field of a topic. Numbers and flags can be plotted, as `topic.field`."""

    name: str
    unit: str
    kind: Literal["number", "flag", "text"]


@dataclass(frozen=True, slots=True)
class FlightTopic(Shape):
    """A topic that the flight has; `first_s` and `last_s` are when its samples begin and end."""

    name: str
    count: int
    first_s: float
    last_s: float
    fields: list[TopicField]


@dataclass(frozen=True, slots=True)
class FlightTopics(Shape):
    """All topics that have samples."""

    topics: list[FlightTopic]


@dataclass(frozen=True, slots=True)
class FlightOverview(Shape):
    """The ground of the time bar: the altitude at evenly spaced moments (null: not known), `signal` being the one
    it was taken from, and the stretches [from_s, to_s] without any data."""

    duration_s: float
    signal: str | None
    altitude_ft: list[float | None]
    gaps: list[list[float]]


@dataclass(frozen=True, slots=True)
class FlownPath(Shape):
    """The longest of the unbroken `pieces` of a track, which has `points`, as few `places`: latitude and longitude in
    degrees, metres above the sea. No point is farther from the line between them than `deviation_m`."""

    points: int
    pieces: int
    deviation_m: float
    places: list[list[float]]


@dataclass(frozen=True, slots=True)
class FlightTimes(Shape):
    """Unix times of the first message and the last."""

    start_s: float
    end_s: float
