"""The definition as values: what load.py makes and every emitter reads."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

UNIT_SUFFIXES: Mapping[str, str] = {
    "1": "",
    "deg": "deg",
    "deg/s": "deg_s",
    "rad/s": "rad_s",
    "m": "m",
    "m/s2": "m_s2",
    "ft": "ft",
    "ft/min": "ft_min",
    "kt": "kt",
    "hPa": "hpa",
    "inHg": "inhg",
    "Pa": "pa",
    "degC": "degc",
    "V": "v",
    "%": "percent",
    "ms": "ms",
    "s": "s",
}
"""Closed list of units, each with the suffix that it adds to the name of a quantity."""

TYPE_SIZES: Mapping[str, int] = {
    "i8": 1,
    "i16": 2,
    "i32": 4,
    "u32": 4,
    "f32": 4,
    "f64": 8,
    "char16": 16,
    "char32": 32,
    "char64": 64,
}
"""Closed list of wire types with their size in bytes. All are little-endian."""

TEXT_TYPES: frozenset[str] = frozenset(name for name in TYPE_SIZES if name.startswith("char"))
"""Zero-padded ASCII of a fixed size."""

STRUCT_CODES: Mapping[str, str] = {
    "i8": "b",
    "i16": "h",
    "i32": "i",
    "u32": "I",
    "f32": "f",
    "f64": "d",
    "char16": "16s",
    "char32": "32s",
    "char64": "64s",
}


class DefinitionError(Exception):
    """The definition files contradict themselves or the schema."""


@dataclass(frozen=True)
class Value:
    """One named quantity as people and JSON see it; several may share a slot (flag bits).

    `absent`: the wire value that means "no data"; NaN in a float.
    """

    name: str
    kind: str
    slot: int
    encoding: str
    doc: str
    unit: str = "1"
    minimum: float | None = None
    maximum: float | None = None
    sign: str = "none"
    bit: int | None = None
    absent: float | None = None
    default: float | None = None
    letters: tuple[str, str] | None = None
    names: Mapping[str, int] = field(default_factory=dict)


@dataclass(frozen=True)
class Slot:
    """One field of the wire, or `count` equal ones in a row."""

    name: str
    type: str
    count: int
    doc: str
    encoding: str
    names: Mapping[str, int] = field(default_factory=dict)

    @property
    def size(self) -> int:
        """Bytes of all its values."""
        return TYPE_SIZES[self.type] * self.count


@dataclass(frozen=True)
class Confirm:
    """How a command is proved on a board that sends no acknowledgements."""

    by: str
    flags: Mapping[str, bool | str] = field(default_factory=dict)
    message: str = ""
    move: str = ""


@dataclass(frozen=True)
class Message:
    """A frame of either direction; only commands have `confirm`."""

    name: str
    id: int
    size: int
    doc: str
    source: str
    extension: bool
    topic: bool
    slots: tuple[Slot, ...]
    values: tuple[Value, ...]
    confirm: Confirm | None = None
    parameter: str = ""

    @property
    def struct_format(self) -> str:
        """Format of Python's struct module for the payload."""
        return "<" + "".join(STRUCT_CODES[slot.type] * slot.count for slot in self.slots)


@dataclass(frozen=True)
class Parameter:
    """One gain, in the order of autopilot_parameters; its docs say what the number multiplies."""

    name: str
    group: str
    set_id: int
    type: str
    default: float
    minimum: float
    maximum: float
    step: float
    doc: str


@dataclass(frozen=True)
class RowValue:
    """One used value of a simulator row."""

    index: int
    name: str
    unit: str
    minimum: float
    maximum: float
    sign: str
    doc: str


@dataclass(frozen=True)
class Row:
    """A simulator row, with its used values for each profile."""

    id: int
    name: str
    doc: str
    sent: bool
    profiles: Mapping[str, tuple[RowValue, ...]]


@dataclass(frozen=True)
class Datagram:
    """The format that all datagrams of the simulator share."""

    magic: str
    tag_from_simulator: int
    tag_to_simulator: int
    values_per_row: int
    no_value: float
    receive_port: int
    send_port: int
    profiles: tuple[str, ...]


@dataclass(frozen=True)
class Waypoint:
    """WGS84, + north and + east; altitude above mean sea level, speed indicated."""

    latitude_deg: float
    longitude_deg: float
    altitude_ft: float
    speed_kt: float


@dataclass(frozen=True)
class Route:
    """A HIL route that the board knows by name; `plan_name` is its number in board_status."""

    name: str
    title: str
    plan_name: int
    load_id: int
    loop: bool
    doc: str
    waypoints: tuple[Waypoint, ...]


@dataclass(frozen=True)
class Frame:
    """The bytes around every payload, and the text line that opens binary mode."""

    to_pc_header: bytes
    to_board_header: bytes
    end: bytes
    to_pc_type_bit: int
    forbidden_type_bits: tuple[int, ...]
    open_binary_mode: str


@dataclass(frozen=True)
class Definition:
    """The whole protocol definition, checked."""

    frame: Frame
    messages: tuple[Message, ...]
    commands: tuple[Message, ...]
    parameters: tuple[Parameter, ...]
    datagram: Datagram
    rows: tuple[Row, ...]
    routes: tuple[Route, ...]
    unused_command_ids: tuple[int, ...]


def topics(definition: Definition) -> tuple[Message, ...]:
    """What the gateway publishes: the board's topics, and the command that describes the simulator."""
    return tuple(message for message in (*definition.messages, *definition.commands) if message.topic)
