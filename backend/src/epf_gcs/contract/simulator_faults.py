"""What can go wrong in a simulated flight, and what the flight process and the embedded simulator say of it.

The lab flies all of this table; the embedded simulator flies what its rows, its controls and its air can show
(`not_carried`). An order and a report are each one datagram. Their times are simulated seconds.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final, Literal, TypeVar

import msgspec

from epf_gcs.contract.base import Shape

FaultPlace = Literal[
    "gyro",
    "attitude",
    "pitot",
    "barometer",
    "gps",
    "receiver",
    "elevator",
    "aileron",
    "rudder",
    "engine",
    "line",
    "simulator",
    "board",
    "wind",
]
FaultKind = Literal[
    "stuck",
    "bias",
    "drift",
    "noise",
    "dropout",
    "jump",
    "jammed",
    "slow",
    "weak",
    "reversed",
    "out",
    "loss",
    "delay",
    "jitter",
    "cut",
    "flipped",
    "pause",
    "silent",
    "reset",
    "gust",
]
TurbulenceName = Literal["none", "light", "moderate", "severe"]
HIGHEST_WIND_KT: Final = 100.0
MOST_FAULTS: Final = 32
"""So many faults wait or are there at the same time, at most."""


class FaultError(Exception):
    """There is no such fault, or it cannot be as it is asked; the sentence says why."""


@dataclass(frozen=True, slots=True)
class Kind:
    """A way to fail. `unit`: of the strength, "" where it has none. `usual_s`: its length; infinite: until ended."""

    says: str
    unit: str = ""
    usual: float = 0.0
    lowest: float = 0.0
    highest: float = 0.0
    usual_s: float = math.inf


def _sensor(unit: str, bias: float, drift: float, noise: float, most: float) -> dict[str, Kind]:
    return {
        "stuck": Kind("says what it said when this began"),
        "bias": Kind("is off by so much", unit, bias, -most, most),
        "drift": Kind("goes off by so much each second", f"{unit}/s", drift, -most, most),
        "noise": Kind("is off by a normal deviation, other in each frame", unit, noise, 0.0, most),
        "dropout": Kind("measures nothing"),
    }


_SERVO: Final = {
    "jammed": Kind("stays where it is, moved by so much", "of half its travel", 0.0, -2.0, 2.0),
    "slow": Kind("moves by at most so much in a second", "of half its travel", 0.5, 0.01, 20.0),
    "weak": Kind("reaches this share of its way", "1", 0.5, 0.0, 1.0),
    "reversed": Kind("moves the other way"),
}

KINDS: Final[Mapping[str, Mapping[str, Kind]]] = MappingProxyType(
    {
        "gyro": _sensor("rad/s", 0.03, 0.001, 0.05, 10.0),
        "attitude": _sensor("deg", 3.0, 0.1, 2.0, 90.0),
        "pitot": _sensor("kt", 5.0, 0.1, 3.0, 200.0),
        "barometer": _sensor("ft", 50.0, 1.0, 10.0, 5000.0),
        "gps": {
            **_sensor("m", 30.0, 0.5, 5.0, 5000.0),
            "jump": Kind("is elsewhere, at another place each second", "m", 100.0, 0.0, 5000.0),
        },
        "receiver": {"dropout": Kind("hears nothing")},
        "elevator": _SERVO,
        "aileron": _SERVO,
        "rudder": _SERVO,
        "engine": {
            "out": Kind("gives no thrust"),
            "weak": Kind("gets this share of the throttle", "1", 0.6, 0.0, 1.0),
        },
        "line": {
            "loss": Kind("loses this share of the frames, each way", "1", 0.2, 0.0, 1.0),
            "delay": Kind("delays by so much, each way", "ms", 100.0, 1.0, 5000.0),
            "jitter": Kind("delays by up to so much, each way", "ms", 150.0, 1.0, 5000.0),
            "cut": Kind("carries nothing", usual_s=2.0),
            "flipped": Kind("flips a bit in this share of the frames, each way", "1", 0.2, 0.0, 1.0),
        },
        "simulator": {
            "pause": Kind("stands still and repeats its last frame", usual_s=30.0),
            "silent": Kind("stands still and sends nothing", usual_s=5.0),
        },
        "board": {"reset": Kind("starts anew, and is away meanwhile", usual_s=2.0)},
        "wind": {"gust": Kind("blows by up to so much more, as 1-cosine", "kt", 15.0, -60.0, 60.0, usual_s=6.0)},
    }
)
"""Every place and how it fails."""

_NOT_FLOWN: Final = {
    "accelerometer": "the line of HIL carries no accelerations; what they spoil is `attitude`",
    "magnetometer": "the line of HIL carries no magnetic field: its direction is the ground track, which is `gps`",
    "battery": "the line of HIL carries no voltage, and no law reads one; what a low battery spoils is `engine.weak`",
}
_NOT_CARRIED: Final = {
    ("line", "flipped"): "a damaged datagram does not arrive: ask for line.loss",
    ("board", "reset"): "the board is a device or a program of its own: start that anew",
}


@dataclass(frozen=True, slots=True)
class Fault:
    """One fault of a flight. Times are simulated, from the flight's start. None: as usual for its kind."""

    place: str
    kind: str
    start_s: float
    length_s: float | None = None
    strength: float | None = None

    def __post_init__(self) -> None:
        """Raises FaultError for an unknown fault, or one that cannot be as it is asked."""
        if self.place in _NOT_FLOWN:
            raise FaultError(f"{self.place}.{self.kind} cannot be flown: {_NOT_FLOWN[self.place]}")
        if self.place not in KINDS:
            raise FaultError(f"there is no fault of {self.place}: choose of {', '.join(KINDS)}")
        if self.kind not in KINDS[self.place]:
            raise FaultError(f"there is no fault {self.place}.{self.kind}: choose of {', '.join(KINDS[self.place])}")
        about = self.about
        if not (0.0 <= self.start_s < math.inf and self.length > 0.0):
            raise FaultError(f"{self} must begin in the flight and last for a time")
        if self.strength is not None and not about.unit:
            raise FaultError(f"{self}: {self.place}.{self.kind} has no strength")
        if not about.lowest <= self.amount <= about.highest:
            raise FaultError(f"{self}: its strength must be {about.lowest:g} to {about.highest:g} {about.unit}")

    @property
    def about(self) -> Kind:
        """What its kind is."""
        return KINDS[self.place][self.kind]

    @property
    def length(self) -> float:
        """Seconds; infinite until the flight ends."""
        return self.about.usual_s if self.length_s is None else self.length_s

    @property
    def amount(self) -> float:
        """Its strength."""
        return self.about.usual if self.strength is None else self.strength

    def is_on(self, time_s: float) -> bool:
        """Whether it is there then. A frame's time is rounded, so that none is counted twice or left out."""
        since_s = round(time_s - self.start_s, 9)
        return 0.0 <= since_s < self.length

    def __str__(self) -> str:
        """As the lab's `read` takes it."""
        length = "" if self.length_s is None else f"+{self.length_s:g}"
        strength = "" if self.strength is None else f"={self.strength:g}"
        return f"{self.place}.{self.kind}@{self.start_s:g}{length}{strength}"


def not_carried(place: str, kind: str) -> str | None:
    """Why the embedded simulator cannot fly this fault; None if it can."""
    if kind == "dropout":
        return "a row has no word for a value that was not measured: ask for its kind `stuck`"
    return _NOT_CARRIED.get((place, kind))


@dataclass(frozen=True, slots=True)
class WindState(Shape):
    """Steady wind: the true direction it blows from, its speed, and turbulence by MIL-F-8785C's name."""

    from_deg: float = 0.0
    speed_kt: float = 0.0
    turbulence: TurbulenceName = "none"


@dataclass(frozen=True, slots=True)
class FaultState(Shape):
    """A fault that waits or is there. Unix times; `ends_s` is null until somebody ends it. `strength` is null where its
    kind has none."""

    id: str
    place: FaultPlace
    kind: FaultKind
    strength: float | None
    unit: str
    begins_s: float
    ends_s: float | None
    is_on: bool


@dataclass(frozen=True, slots=True)
class SimulatedFaults(Shape):
    """What goes wrong in the embedded simulator by order, the first to begin first, and its wind."""

    faults: list[FaultState]
    wind: WindState


def noted_faults(content: Mapping[str, object]) -> SimulatedFaults | None:
    """What was flown, from its note in a recording; None if the simulator took no orders, or it is a stranger's."""
    try:
        return msgspec.convert(content.get("flown"), SimulatedFaults | None)
    except msgspec.ValidationError:
        return None


@dataclass(frozen=True, slots=True)
class OrderedFault:
    """A fault to begin; its `start_s` counts from the order. A known id is not begun twice."""

    id: str
    fault: Fault


@dataclass(frozen=True, slots=True)
class FaultOrder:
    """What the simulator shall do. It may be repeated."""

    serial: int
    begin: OrderedFault | None = None
    end: str | None = None
    ends_all: bool = False
    wind: WindState | None = None


@dataclass(frozen=True, slots=True)
class FlownFault:
    """A fault in the simulator. `begins_in_s` is negative once it has begun; `frames`: in how many it showed."""

    id: str
    fault: Fault
    begins_in_s: float
    ends_in_s: float | None
    frames: int

    @property
    def is_over(self) -> bool:
        """Whether it has ended; it is reported for some seconds more, for its frames."""
        return self.ends_in_s is not None and self.ends_in_s <= 0.0


@dataclass(frozen=True, slots=True)
class FaultReport:
    """What is flown now. `serial`: of the newest order that was obeyed."""

    serial: int
    wind: WindState
    faults: tuple[FlownFault, ...]


MAGIC: Final = b"EPFS"
"""What such a datagram begins with; X-Plane ignores it."""
_SayingT = TypeVar("_SayingT", FaultOrder, FaultReport)


def datagram(saying: FaultOrder | FaultReport) -> bytes:
    """As it goes over the loopback."""
    return MAGIC + msgspec.json.encode(saying)


def read_datagram(data: bytes, kind: type[_SayingT]) -> _SayingT | None:
    """An order or a report; None for anything else."""
    if not data.startswith(MAGIC):
        return None
    try:
        return msgspec.json.decode(data[len(MAGIC) :], type=kind)
    except (msgspec.DecodeError, FaultError):
        return None
