"""What happens, as every page is told it, and as a recording keeps what the bytes of the lines do not say.

The data of `job`, `map_field`, `map_import` and `track` are answers of the interface as well: `web/interface/events.py`
lists all.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar, Final, Literal, Protocol, Self

import msgspec

from epf_gcs.contract.answers import (
    CommandProof,
    CommandReason,
    CommandState,
    GainState,
    JournalEntry,
    Mark,
    ParameterMove,
)
from epf_gcs.contract.base import LinkState, PageKind, ParamValue, PlanName, RoleName, Shape, StickSource
from epf_gcs.contract.inspector import AdviceState
from epf_gcs.contract.own_gains import OwnGainState, OwnGainTable
from epf_gcs.contract.simulator_faults import FaultKind, FaultPlace, WindState
from epf_gcs.contract.status import AlarmState, ControlRequest
from epf_gcs.errors import ErrorCode, GatewayError

MissionState = Literal["pending", "confirmed", "rejected"]
StickReason = Literal["chosen", "control_lost", "lost", "back"]
ControlReason = Literal[
    "first",  # it came while nobody had control
    "back",  # who had lost it returned
    "asked",  # it asked while nobody had it, or asked longest when it became free
    "taken",  # an owner took it
    "granted",
    "handed_over",
    "unanswered",  # the holder neither answered nor did anything
    "waited",  # nobody came back for it: another page of the same session
    "released",
    "lost",  # the holder's stream is closed
    "silent",  # nothing is heard of the holder
    "ended",  # the holder's session, key or role is no longer good
]
RequestResult = Literal["given", "refused", "withdrawn", "gone"]
SubjectEvent = Literal["job", "map_field", "map_import", "track"]
"""Events whose data is an answer of the interface as well."""


class Event(Shape):
    """The base of all events. NAME is its word on the stream and in recordings.

    A field that recordings of older stations do not have has a default that means "not known".
    """

    __slots__ = ()
    NAME: ClassVar[str]


class Say(Protocol):
    """Send an event of a subject to every page: its name and its data."""

    def __call__(self, name: SubjectEvent, data: Shape, /) -> None:
        """Say it now."""


@dataclass(frozen=True, slots=True)
class AccessEvent(Event):
    """This page has another role or name now; sent to it alone."""

    NAME = "access"
    role: RoleName
    name: str


@dataclass(frozen=True, slots=True)
class AdviceEvent(AdviceState, Event):
    """Something new can be advised."""

    NAME = "advice"


@dataclass(frozen=True, slots=True)
class AlarmEvent(AlarmState, Event):
    """An alarm came, went or was acknowledged. `active`: its cause is still there."""

    NAME = "alarm"
    active: bool = False


@dataclass(frozen=True, slots=True)
class BoardRestartEvent(Event):
    """The board began anew in flight and lost what was not stored on its card: these gains and plans.

    `silent_s`: how long it was silent; null if not measured. `uptime_ms`: how long it had run when it was heard again.
    """

    NAME = "board_restarted"
    silent_s: float | None = None
    uptime_ms: int | None = None
    parameters: list[str] = field(default_factory=list)
    plans: list[PlanName] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class ChecklistEvent(Event):
    """The checklist was changed: ask for it again."""

    NAME = "checklist"


@dataclass(frozen=True, slots=True)
class CommandEvent(Event):
    """A command was sent, or what became of it. `reason` is the board's where it refused; `not_sent`: it never left."""

    NAME = "command"
    id: int
    name: str
    value: list[float]
    client: str | None
    state: Literal["pending", CommandState]
    by: CommandProof = "none"
    ms: float | None = None
    reason: Literal["not_sent", CommandReason] | None = None


@dataclass(frozen=True, slots=True)
class ConsoleEvent(Event):
    """A line of text to or from the board; `client`: who sent it."""

    NAME = "console"
    direction: Literal["sent", "received"]
    text: str
    client: str | None = None


@dataclass(frozen=True, slots=True)
class PageName(Shape):
    """How events name a page; nulls for nobody."""

    client: str | None = None
    name: str | None = None
    kind: PageKind | None = None
    number: int | None = None


@dataclass(frozen=True, slots=True)
class ControlEvent(PageName, Event):
    """Another page, or none, has control. A recording does not say the `reason`, nor who had it `before`."""

    NAME = "control"
    reason: ControlReason | None = None
    before: PageName | None = None


@dataclass(frozen=True, slots=True)
class ControlRequestEvent(ControlRequest, Event):
    """A page asks for control."""

    NAME = "control_request"


@dataclass(frozen=True, slots=True)
class ControlRequestEndEvent(Event):
    """What became of a page's request for control."""

    NAME = "control_request_closed"
    client: str
    name: str
    kind: PageKind
    number: int
    result: RequestResult


@dataclass(frozen=True, slots=True)
class ErrorEvent(Event):
    """Something went wrong that no answer tells of. `count`: how often since the start."""

    NAME = "error"
    code: ErrorCode
    detail: str
    params: Mapping[str, ParamValue]
    count: int = 1

    @classmethod
    def of(cls, error: GatewayError, count: int) -> Self:
        """Of an error that came so often."""
        return cls(error.code, error.detail, error.params, count)


@dataclass(frozen=True, slots=True)
class FaultEvent(Event):
    """A fault that was ordered in the embedded simulator began or ended; `frames`: in how many of its frames it showed
    so far, null if not known. `strength` is null where its kind has none."""

    NAME = "fault"
    state: Literal["begun", "ended"]
    id: str
    place: FaultPlace
    kind: FaultKind
    strength: float | None = None
    unit: str = ""
    frames: int | None = None


@dataclass(frozen=True, slots=True)
class FlightProcessEvent(Event):
    """The flight process was lost, or is back."""

    NAME = "flight"
    state: Literal["lost", "back"]


@dataclass(frozen=True, slots=True)
class JournalEvent(Event):
    """A new entry of the journal of gains, null where only what can be undone or redone has changed."""

    NAME = "journal"
    entry: JournalEntry | None
    undo: tuple[ParameterMove, ...] | None
    redo: tuple[ParameterMove, ...] | None


@dataclass(frozen=True, slots=True)
class LinkEvent(Event):
    """The states of both links; one of them has changed."""

    NAME = "link"
    board: LinkState
    simulator: LinkState


@dataclass(frozen=True, slots=True)
class MarkEvent(Mark, Event):
    """A person put words into the recording."""

    NAME = "mark"


@dataclass(frozen=True, slots=True)
class MissionEvent(Event):
    """What becomes of a plan on its way to the board, whoever sends it; `count`: its waypoints."""

    NAME = "mission"
    plan: PlanName
    state: MissionState
    count: int = 0
    client: str | None = None


@dataclass(frozen=True, slots=True)
class OwnGainsEvent(Event):
    """The board's own gains: a new table, null where it is as before, and the values that changed, by name.

    With a table come all of its values.
    """

    NAME = "own_gains"
    table: OwnGainTable | None
    values: Mapping[str, OwnGainState]


@dataclass(frozen=True, slots=True)
class ParameterEvent(Event):
    """Gains that changed, by name."""

    NAME = "parameter"
    parameters: Mapping[str, GainState]


@dataclass(frozen=True, slots=True)
class RecordingEvent(Event):
    """A file was begun, or none is written any more."""

    NAME = "recording"
    active: bool
    file: str | None


@dataclass(frozen=True, slots=True)
class SimulatorJumpEvent(Event):
    """The simulator put its aircraft elsewhere: a reset or a new start. Feet are indicated altitude."""

    NAME = "simulator_jumped"
    distance_m: float
    latitude_deg: float
    longitude_deg: float
    altitude_ft: float


@dataclass(frozen=True, slots=True)
class StickEvent(Event):
    """Where the stick comes from now. `client`, `name`: the page whose gamepad it is.

    `gamepad` also names the one whose use has just ended.
    """

    NAME = "stick"
    source: StickSource
    state: Literal["live", "lost"] | None
    reason: StickReason
    client: str | None
    name: str | None
    gamepad: str | None


@dataclass(frozen=True, slots=True)
class SurroundingsEvent(Event):
    """The fence, or what is warned of, was changed: ask for it again."""

    NAME = "surroundings"


@dataclass(frozen=True, slots=True)
class WindEvent(WindState, Event):
    """The wind of the embedded simulator was set."""

    NAME = "wind"


EVENTS: Final[Mapping[str, type[Event]]] = {
    kind.NAME: kind
    for kind in tuple(globals().values())
    if isinstance(kind, type) and issubclass(kind, Event) and kind is not Event
}
"""All of this file, by their names."""


def noted_event(name: str, data: Mapping[str, Any]) -> Event | None:
    """An event out of a recording; None if it is not one of these, or has not what it must have."""
    kind = EVENTS.get(name)
    try:
        return None if kind is None else msgspec.convert(data, kind)
    except msgspec.ValidationError:
        return None
