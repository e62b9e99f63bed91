"""What happened at a place of a flown track, for the files that draw it."""

from __future__ import annotations

from typing import Literal, NamedTuple

PlacedKind = Literal["mark", "alarm", "waypoint"]


class PlacedEvent(NamedTuple):
    """Unix time, place (degrees, metres above mean sea level), and its name in words."""

    t_s: float
    latitude_deg: float
    longitude_deg: float
    altitude_m: float
    kind: PlacedKind
    name: str
