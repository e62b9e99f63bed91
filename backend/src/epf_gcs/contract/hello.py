"""How a vehicle greets a station that connects to it."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from epf_gcs.contract.base import PageFacts
from epf_gcs.contract.playback import Playback
from epf_gcs.contract.status import Status


@dataclass(frozen=True, slots=True)
class ControlHolder:
    """The page that has control according to the flight process, or that had it until just now."""

    client: str
    name: str
    about: PageFacts = field(default_factory=PageFacts)


@dataclass(frozen=True, slots=True)
class FlightSpan:
    """The recorded flight that a replay shows: its id, its start (Unix seconds) and its length."""

    flight: str
    starts_s: float
    duration_s: float


@dataclass(frozen=True, slots=True)
class Hello:
    """`clock_offset_ns` is Unix minus steady clock. `flight` and `playback` are a replay's alone."""

    version: str
    vehicle: Literal["live", "replay"]
    status: Status
    clock_offset_ns: int = 0
    control: ControlHolder | None = None
    flight: FlightSpan | None = None
    playback: Playback | None = None
