"""What can go wrong in a flight: where, how, from when, for how long, and how much.

As text: `gyro.drift@60+30=0.002` is the gyro drifting by 0.002 rad/s each second, from the 60th second, for 30 s. It
lasts until the flight ends without a length, and is of the usual strength without one.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

import msgspec

from epf_gcs.lab.errors import LabError


@dataclass(frozen=True, slots=True)
class Kind:
    """A way to fail. `unit`: of the strength, "" where it has none. `usual_s`: its length; infinite: until the end."""

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
    }
)
"""Every place and how it fails."""

_NOT_CARRIED: Final = {
    "accelerometer": "the line of HIL carries no accelerations; what they spoil is `attitude`",
    "magnetometer": "the line of HIL carries no magnetic field: its direction is the ground track, which is `gps`",
    "battery": "the line of HIL carries no voltage, and no law reads one; what a low battery spoils is `engine.weak`",
}
_NOT_IN_HIL: Final = (
    'command 50 has no word for a value that was not measured. Fly the loop of the real aircraft: loop = "aircraft"'
)
_NO_LINE: Final = 'the loop of the real aircraft flies by its sensors, without line or simulator. Fly loop = "hil"'
_TEXT: Final = re.compile(r"(?P<place>\w+)\.(?P<kind>\w+)@(?P<start>[^+=]+)(\+(?P<length>[^=]+))?(=(?P<strength>.+))?")


@dataclass(frozen=True, slots=True)
class Fault:
    """One fault of a flight. Times are simulated, from the flight's start. None: as usual for its kind."""

    place: str
    kind: str
    start_s: float
    length_s: float | None = None
    strength: float | None = None

    def __post_init__(self) -> None:
        """Raises LabError for an unknown fault, or one that cannot be as it is asked."""
        if self.place in _NOT_CARRIED:
            raise LabError(f"{self.place}.{self.kind} cannot be flown: {_NOT_CARRIED[self.place]}")
        if self.place not in KINDS:
            raise LabError(f"there is no fault of {self.place}: choose of {', '.join(KINDS)}")
        if self.kind not in KINDS[self.place]:
            raise LabError(f"there is no fault {self.place}.{self.kind}: choose of {', '.join(KINDS[self.place])}")
        about = self.about
        if not (0.0 <= self.start_s < math.inf and self.length > 0.0):
            raise LabError(f"{self} must begin in the flight and last for a time")
        if self.strength is not None and not about.unit:
            raise LabError(f"{self}: {self.place}.{self.kind} has no strength")
        if not about.lowest <= self.amount <= about.highest:
            raise LabError(f"{self}: its strength must be {about.lowest:g} to {about.highest:g} {about.unit}")

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
        """As `read` takes it."""
        length = "" if self.length_s is None else f"+{self.length_s:g}"
        strength = "" if self.strength is None else f"={self.strength:g}"
        return f"{self.place}.{self.kind}@{self.start_s:g}{length}{strength}"


Asked = Fault | str | Mapping[str, object]
"""How a fault may be given: as it is, as text, or as a table's names and values."""


def read(asked: Iterable[Asked]) -> tuple[Fault, ...]:
    """The faults of a flight. Raises LabError as `Fault`, or for what cannot be read as a fault."""
    return tuple(_one(fault) for fault in asked)


def told(asked: Iterable[Asked]) -> str:
    """As text, also of what cannot be read as a fault."""
    return " ".join(_told(fault) for fault in asked)


def check_hil(faults: Iterable[Fault]) -> None:
    """Raises LabError for a fault that the line of HIL cannot carry."""
    for fault in faults:
        if fault.kind == "dropout":
            raise LabError(f"{fault} cannot be flown: {_NOT_IN_HIL}")


def check_aircraft(faults: Iterable[Fault]) -> None:
    """Raises LabError for a fault that the loop of the real aircraft does not have."""
    for fault in faults:
        if fault.place in ("line", "simulator"):
            raise LabError(f"{fault} cannot be flown: {_NO_LINE}")


def _told(asked: Asked) -> str:
    try:
        return str(_one(asked))
    except LabError:
        return str(asked)


def _one(asked: Asked) -> Fault:
    if isinstance(asked, Fault):
        return asked
    try:
        if isinstance(asked, str):
            return _of_text(asked)
        return msgspec.convert(asked, Fault)
    except msgspec.ValidationError as error:
        raise LabError(f"{asked} is no fault: {error}") from error


def _of_text(text: str) -> Fault:
    found = _TEXT.fullmatch(text)
    if found is None:
        raise LabError(f"{text!r} is no fault: PLACE.KIND@START+LENGTH=STRENGTH, as gyro.drift@60+30=0.002")
    try:
        times = [None if found[name] is None else float(found[name]) for name in ("length", "strength")]
        return Fault(found["place"], found["kind"], float(found["start"]), *times)
    except ValueError as error:
        raise LabError(f"{text!r} is no fault: {error}") from error
