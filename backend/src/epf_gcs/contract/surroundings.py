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
class HeightSet(Shape):
    """A set of terrain by whose heights something was judged. `datum`: what they count from; null: nobody has said, and
    they are taken as heights above the sea. `geoid_m`: how high the sea (EGM96) is above the ellipsoid where it was
    judged, farthest from zero: ellipsoidal heights were converted by it, and those of an unknown datum may be wrong by
    it."""

    name: str
    datum: Literal["orthometric", "ellipsoidal"] | None
    geoid_m: float


@dataclass(frozen=True, slots=True)
class AircraftAround(Shape):
    """Ground and fence of one aircraft. `blind`: why nothing is known of the ground; `path`: the present track, while
    there is a warning. `outside`: beyond the fence's border or over its ceiling. `heights`: the sets of terrain that
    the ground's height below the aircraft is of."""

    blind: Literal["no_position", "no_heights", "no_heights_here"] | None = None
    ground_ft: float | None = None
    height_ft: float | None = None
    terrain: ThreatAhead | None = None
    fence: ThreatAhead | None = None
    outside: bool = False
    heights: list[HeightSet] = field(default_factory=list)
    path: list[TrackPlace] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class SurroundingsState(Shape):
    """The board's aircraft by its GPS, and the simulator's."""

    flight: AircraftAround = AircraftAround()
    hil: AircraftAround = AircraftAround()
