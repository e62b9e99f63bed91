"""The shapes of the generated tables in messages_gen.py."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from struct import Struct
from types import MappingProxyType
from typing import Final, Literal

Kind = Literal["number", "integer", "boolean", "text"]
Encoding = Literal["plain", "flag", "bit", "ascii_digits", "ascii_flag", "text", "scaled"]
ConfirmBy = Literal["none", "heartbeat", "frame", "plan", "read_back"]
Move = Literal["", "next", "previous", "first"]

_NO_NAMES: Final[Mapping[str, int]] = MappingProxyType({})
_NO_FLAGS: Final[Mapping[str, bool | str]] = MappingProxyType({})


@dataclass(frozen=True, slots=True)
class Value:
    """One quantity of a payload, under its JSON name (which has the unit in it).

    `slot` is its index in the unpacked tuple; `encoding` says how the wire holds it. A value outside
    `minimum`..`maximum` is implausible and means "no data". `absent` (NaN or a number) is the wire value by which
    the board itself says "no data"; it does not count as implausible. `names` gives an integer's values by name.
    A scaled value is the integer of the wire times `scale`, and so are its limits.
    """

    name: str
    kind: Kind
    slot: int
    encoding: Encoding
    doc: str
    unit: str = "1"
    minimum: float | None = None
    maximum: float | None = None
    sign: str = "none"
    bit: int | None = None
    absent: float | None = None
    default: float | None = None
    letters: tuple[str, str] | None = None
    names: Mapping[str, int] = field(default_factory=lambda: _NO_NAMES)
    scale: float = 1.0


@dataclass(frozen=True, slots=True)
class Confirm:
    """How to tell that a command was executed by a board that does not acknowledge commands.

    heartbeat: the heartbeat has all of `flags` ("argument" stands for the value sent).
    frame: a frame `message` arrives after the command. plan: the waypoint of `message` moves as
    `move` says. read_back: loading the parameters gives the value sent. none: nothing does.
    """

    by: ConfirmBy
    flags: Mapping[str, bool | str] = field(default_factory=lambda: _NO_FLAGS)
    message: str = ""
    move: Move = ""


@dataclass(frozen=True, slots=True, eq=False)
class Message:
    """The definition of one type of frame, in either direction.

    Only commands have a `confirm` other than none; `parameter` is the name of the gain that a set command sets.
    """

    id: int
    name: str
    doc: str
    source: str
    extension: bool
    topic: bool
    struct: Struct
    values: tuple[Value, ...] = ()
    confirm: Confirm = field(default_factory=lambda: Confirm("none"))
    parameter: str = ""

    @property
    def size(self) -> int:
        """Payload bytes."""
        return self.struct.size


@dataclass(frozen=True, slots=True)
class Parameter:
    """One gain of the control laws. The table lists them in the order of the message autopilot_parameters."""

    name: str
    group: str
    set_id: int
    is_integer: bool
    minimum: float
    maximum: float
    step: float
    default: float
    doc: str


@dataclass(frozen=True, slots=True)
class RowValue:
    """One used value of a simulator row."""

    index: int
    name: str
    unit: str
    minimum: float
    maximum: float
    sign: str
    doc: str


@dataclass(frozen=True, slots=True)
class Row:
    """A row of the simulator's datagram, for one profile."""

    id: int
    name: str
    doc: str
    sent: bool
    values: tuple[RowValue, ...]


@dataclass(frozen=True, slots=True)
class Waypoint:
    """WGS84 degrees (+ north, + east), feet above mean sea level, knots indicated."""

    latitude_deg: float
    longitude_deg: float
    altitude_ft: float
    speed_kt: float


@dataclass(frozen=True, slots=True)
class Route:
    """A route that the board knows by name; `loop`: after the last waypoint comes the first."""

    name: str
    title: str
    plan_name: int
    load_id: int
    loop: bool
    doc: str
    waypoints: tuple[Waypoint, ...]
