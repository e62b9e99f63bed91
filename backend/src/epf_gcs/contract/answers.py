"""What comes back for requests, where it is no part of the status. Times are Unix seconds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal, Self

from epf_gcs.codec.tables import Parameter, Waypoint
from epf_gcs.contract.alarm_ids import AlarmId
from epf_gcs.contract.base import LinkState, ParamValue, PlanName, Shape
from epf_gcs.contract.status import AlarmState

GainStateName = Literal["unknown", "loaded", "pending", "confirmed", "rejected"]
WriteOutcome = Literal["confirmed", "rejected", "timed_out"]


CommandState = Literal["confirmed", "rejected", "timed_out", "sent"]
CommandProof = Literal["acknowledgement", "heartbeat", "read_back", "none"]
CommandReason = Literal["bad_value", "bad_state", "unknown", "storage_failed", "not_taken"]


SampleValue = float | int | bool | str | Mapping[str, list[float | None]] | None
"""Of a topic; a mapping: the eight values of each of the simulator's rows."""


@dataclass(frozen=True, slots=True)
class Sample(Shape):
    """The newest sample of a topic; null is no data."""

    t_s: float
    age_s: float
    stale: bool
    values: Mapping[str, SampleValue]


@dataclass(frozen=True, slots=True)
class BatteryPack(Shape):
    """What the battery's alarm goes by: the highest voltage seen, how many cells it has (guessed from that voltage
    until the operator says it), and the voltage below which it is low."""

    highest_v: float
    cells: int
    is_guessed: bool
    low_v: float


@dataclass(frozen=True, slots=True)
class AlarmLimits(Shape):
    """The limits of the alarms by name, each in the unit of its name; `battery` is null while none was measured."""

    values: Mapping[str, float]
    battery: BatteryPack | None


@dataclass(frozen=True, slots=True)
class TrackState(Shape):
    """What is drawn now; `can_restore`: an earlier one is kept: cleared last, or flown before a restart."""

    flight_points: int
    hil_points: int
    can_restore: bool


@dataclass(frozen=True, slots=True)
class PortState(Shape):
    """A serial port. `identity` is the same wherever the device is plugged in."""

    path: str
    url: str
    description: str
    identity: str | None


@dataclass(frozen=True, slots=True)
class LinkResult(Shape):
    """A link after it was opened."""

    state: LinkState
    url: str


@dataclass(frozen=True, slots=True)
class CommandOutcome(Shape):
    """What became of a command; `reason` is the board's where it refused."""

    state: CommandState
    by: CommandProof
    ms: float
    reason: CommandReason | None = None

    @property
    def done(self) -> bool:
        """Confirmed by the board, or not contradicted by it."""
        return self.state in ("confirmed", "sent")


@dataclass(frozen=True, slots=True)
class GainState(Shape):
    """A gain as far as it is known: the board's value, and what it was when all were last loaded."""

    value: float | None = None
    state: GainStateName = "unknown"
    loaded: float | None = None


@dataclass(frozen=True, slots=True)
class ParameterChange(Shape):
    """`before` is what the board had, null where that was not known; `after` is what it was asked to take."""

    name: str
    before: float | None
    after: float
    state: WriteOutcome


@dataclass(frozen=True, slots=True)
class JournalEntry(Shape):
    """One step: who wrote what when. It is `confirmed` only where every change was."""

    id: int
    t_s: float
    client: str | None
    name: str | None
    kind: Literal["write", "undo", "redo"]
    state: WriteOutcome
    changes: tuple[ParameterChange, ...]


@dataclass(frozen=True, slots=True)
class ParameterMove(Shape):
    """What an undo or redo would do: from the value that was written to the one that it writes."""

    name: str
    before: float
    after: float


@dataclass(frozen=True, slots=True)
class ParameterJournal(Shape):
    """Newest first. `undo` and `redo` are what would be written now, null where there is nothing."""

    entries: list[JournalEntry]
    undo: tuple[ParameterMove, ...] | None
    redo: tuple[ParameterMove, ...] | None


@dataclass(frozen=True, slots=True)
class PastAlarm(Shape):
    """Something that was wrong; Unix times."""

    id: AlarmId
    level: Literal["warning", "critical"]
    text: str
    params: Mapping[str, ParamValue]
    since_s: float
    until_s: float
    acknowledged: bool


@dataclass(frozen=True, slots=True)
class AlarmBook(Shape):
    """What is wrong now, oldest first, and the 200 that went last, newest first."""

    active: list[AlarmState]
    past: list[PastAlarm]


@dataclass(frozen=True, slots=True)
class Mark(Shape):
    """A person's words in the recording, for a moment of it."""

    id: str
    text: str
    by: str | None
    t_s: float


@dataclass(frozen=True, slots=True)
class DiskPolicy(Shape):
    """What happens when the disk fills: recording stops at `keep_free_bytes`, or the library makes room.

    `delete_oldest`: the bin and then the oldest flights that are not pinned are deleted for good until
    `keep_free_bytes` are free; recording then goes on.
    """

    delete_oldest: bool = False
    keep_free_bytes: int = 1_000_000_000


@dataclass(frozen=True, slots=True)
class AircraftName(Shape):
    """What the aircraft is called; empty where nobody gave it a name."""

    name: str


@dataclass(frozen=True, slots=True)
class FlightIdentity(Shape):
    """What flew, and with which station."""

    station: str | None = None
    board: str | None = None
    firmware: str | None = None
    aircraft: str | None = None
    operator: str | None = None
    emulated: bool = False


@dataclass(frozen=True, slots=True)
class ParameterState(Shape):
    """One gain; `value` is the board's, null until it was read.

    `loaded` is what it was when the operator last loaded all, or when it was read first.
    """

    name: str
    group: str
    value: float | None
    loaded: float | None
    state: GainStateName
    unit: str
    minimum: float
    maximum: float
    step: float
    default: float
    is_integer: bool
    doc: str

    @classmethod
    def of(cls, gain: Parameter, known: GainState) -> Self:
        """A gain with what is allowed."""
        return cls(
            name=gain.name,
            group=gain.group,
            value=known.value,
            loaded=known.loaded,
            state=known.state,
            unit="1",
            minimum=gain.minimum,
            maximum=gain.maximum,
            step=gain.step,
            default=gain.default,
            is_integer=gain.is_integer,
            doc=gain.doc,
        )


@dataclass(frozen=True, slots=True)
class KnownMission(Shape):
    """A plan as it was known; `waypoints` is null while it was not read."""

    plan: PlanName
    waypoints: list[Waypoint] | None


@dataclass(frozen=True, slots=True)
class KnownMissions(Shape):
    """Both plans; null where the recording does not say."""

    flight: KnownMission | None
    hil: KnownMission | None
