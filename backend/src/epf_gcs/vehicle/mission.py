"""A flight plan on its way to the board and back."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final, Literal

from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.codec.tables import Waypoint
from epf_gcs.codec.values import Json, argument_fault, single

Plan = Literal["flight", "hil"]

_ITEM: Final = {value.name: value for value in COMMANDS["mission_item"].values}
_COUNT: Final = {value.name: value for value in COMMANDS["mission_begin"].values}["count"]
PLAN_NUMBERS: Final[Mapping[str, int]] = _ITEM["plan"].names
MAX_WAYPOINTS: Final = int(_COUNT.maximum or 0)
_FIELDS: Final = ("latitude_deg", "longitude_deg", "altitude_ft", "speed_kt")


def mission_fault(waypoints: Sequence[Waypoint]) -> str | None:
    """Why this plan cannot be sent, naming the waypoint and the field; None if it can."""
    if not 1 <= len(waypoints) <= MAX_WAYPOINTS:
        return f"A plan has 1 to {MAX_WAYPOINTS} waypoints, not {len(waypoints)}."
    for index, waypoint in enumerate(waypoints):
        for field in _FIELDS:
            fault = argument_fault(_ITEM[field], getattr(waypoint, field))
            if fault is not None:
                return f"Waypoint {index}: {fault}."
    return None


def item_arguments(plan: int, index: int, waypoint: Waypoint) -> tuple[float, ...]:
    """The arguments of the command that carries one waypoint."""
    return (plan, index, waypoint.latitude_deg, waypoint.longitude_deg, waypoint.altitude_ft, waypoint.speed_kt)


def waypoint_from(values: Mapping[str, Json]) -> Waypoint | None:
    """The waypoint in a frame from the board; None if one of its values is missing."""
    numbers = [values.get(field) for field in _FIELDS]
    known = [float(number) for number in numbers if isinstance(number, int | float)]
    return Waypoint(*known) if len(known) == len(_FIELDS) else None


def same_plan(sent: Sequence[Waypoint], found: Sequence[Waypoint]) -> bool:
    """Whether the board has what was sent: positions exactly, altitude and speed in single precision."""
    return [_on_the_wire(waypoint) for waypoint in sent] == list(found)


def _on_the_wire(waypoint: Waypoint) -> Waypoint:
    return Waypoint(
        waypoint.latitude_deg, waypoint.longitude_deg, single(waypoint.altitude_ft), single(waypoint.speed_kt)
    )
