"""Ground and fence around both aircraft, as the web process sees them. Feet above mean sea level, WGS 84."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from epf_gcs.contract.base import Shape


@dataclass(frozen=True, slots=True)
class TrackPlace(Shape):
    """A place on the present track."""

    latitude_deg: float
    longitude_deg: float


@dataclass(frozen=True, slots=True)
class ThreatAhead(Shape):
    """What the present track leads to: in `in_s` (0: now), at this place, at this altitude above the sea."""

    what: Literal["terrain", "fence", "ceiling"]
    in_s: float
    latitude_deg: float
    longitude_deg: float
    altitude_ft: float


@dataclass(frozen=True, slots=True)
class AircraftAround(Shape):
    """Ground and fence of one aircraft. `blind`: why nothing is known of the ground; `path`: the present track, while
    there is a warning. `outside`: beyond the fence's border or over its ceiling. `datum_unknown`: nobody has said what
    the heights of the ground here count from, so that they may be off by the geoid's height."""

    blind: Literal["no_position", "no_heights", "no_heights_here"] | None = None
    ground_ft: float | None = None
    height_ft: float | None = None
    terrain: ThreatAhead | None = None
    fence: ThreatAhead | None = None
    outside: bool = False
    datum_unknown: bool = False
    path: list[TrackPlace] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class SurroundingsState(Shape):
    """The board's aircraft by its GPS, and the simulator's."""

    flight: AircraftAround = AircraftAround()
    hil: AircraftAround = AircraftAround()
