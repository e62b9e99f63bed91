"""A plan of the board as MAVLink's mission items and back. Every height is above mean sea level; nothing is guessed."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from epf_gcs.codec.tables import Waypoint
from epf_gcs.mavlink.choice import Home
from epf_gcs.mavlink.dialect import MAKE, WIRE, Message
from epf_gcs.units import ft_from_m, kt_from_mps, m_from_ft, mps_from_kt

MOST_WAYPOINTS: Final = 100
# A speed before each waypoint at most.
MOST_ITEMS: Final = 2 * MOST_WAYPOINTS
_AIRSPEED: Final = 0
_UNCHANGED_THROTTLE: Final = -1.0
_SEA_FRAMES: Final = frozenset({WIRE.MAV_FRAME_GLOBAL, WIRE.MAV_FRAME_GLOBAL_INT})
_HOME_FRAMES: Final = frozenset({WIRE.MAV_FRAME_GLOBAL_RELATIVE_ALT, WIRE.MAV_FRAME_GLOBAL_RELATIVE_ALT_INT})


class PlanError(Exception):
    """A plan that the board cannot fly as it is: MAVLink's result for it, and a sentence for people."""

    def __init__(self, result: int, text: str) -> None:
        super().__init__(text)
        self.result = result


@dataclass(frozen=True, slots=True)
class PlanItems:
    """The items of a plan, and at which of them each waypoint is."""

    items: tuple[Message, ...]
    at: tuple[int, ...]

    def waypoint_at(self, item: int) -> int:
        """The waypoint that flying to this item means: the next one for a change of speed. Raises ValueError."""
        for waypoint, at in enumerate(self.at):
            if at >= item >= 0:
                return waypoint
        raise ValueError(f"the plan has no item {item}")


def items_of(plan: Sequence[Waypoint], usual_speed_kt: float | None) -> PlanItems:
    """The items: a change of speed stands before a waypoint where it is not the one before, or not the usual one."""
    items: list[Message] = []
    at: list[int] = []
    speed_kt = usual_speed_kt
    for waypoint in plan:
        if speed_kt is None or abs(waypoint.speed_kt - speed_kt) > 1e-3:
            items.append(_speed(len(items), waypoint.speed_kt))
            speed_kt = waypoint.speed_kt
        at.append(len(items))
        items.append(_place(len(items), waypoint))
    return PlanItems(tuple(items), tuple(at))


def plan_of(items: Sequence[Message], usual_speed_kt: float | None, home: Home | None) -> list[Waypoint]:
    """The waypoints that these items mean. Raises PlanError for what the board cannot fly."""
    plan: list[Waypoint] = []
    speed_kt = usual_speed_kt
    for item in items:
        if item.command == WIRE.MAV_CMD_DO_CHANGE_SPEED:
            speed_kt = _read_speed(item)
        elif item.command == WIRE.MAV_CMD_NAV_WAYPOINT:
            plan.append(_read_place(item, speed_kt, home))
        else:
            name = WIRE.enums["MAV_CMD"].get(item.command)
            what = str(item.command) if name is None else name.name.removeprefix("MAV_CMD_")
            text = f"Item {item.seq} is {what}: this board flies waypoints and changes of speed alone."
            raise PlanError(WIRE.MAV_MISSION_UNSUPPORTED, text)
    if not plan:
        raise PlanError(WIRE.MAV_MISSION_DENIED, "A plan of this board has at least one waypoint.")
    if len(plan) > MOST_WAYPOINTS:
        raise PlanError(WIRE.MAV_MISSION_NO_SPACE, f"The board takes {MOST_WAYPOINTS} waypoints, not {len(plan)}.")
    return plan


def _speed(number: int, speed_kt: float) -> Message:
    return MAKE.mission_item_int_encode(
        0, 0, number, WIRE.MAV_FRAME_MISSION, WIRE.MAV_CMD_DO_CHANGE_SPEED, 0, 1,
        _AIRSPEED, mps_from_kt(speed_kt), _UNCHANGED_THROTTLE, 0.0, 0, 0, 0.0,
    )  # fmt: skip


def _place(number: int, waypoint: Waypoint) -> Message:
    return MAKE.mission_item_int_encode(
        0, 0, number, WIRE.MAV_FRAME_GLOBAL_INT, WIRE.MAV_CMD_NAV_WAYPOINT, 0, 1, 0.0, 0.0, 0.0, math.nan,
        round(waypoint.latitude_deg * 1e7), round(waypoint.longitude_deg * 1e7), m_from_ft(waypoint.altitude_ft),
    )  # fmt: skip


def _read_speed(item: Message) -> float:
    if item.param1 != _AIRSPEED:
        text = f"Item {item.seq} asks for a speed over ground: this board flies airspeeds."
        raise PlanError(WIRE.MAV_MISSION_INVALID_PARAM1, text)
    if not (math.isfinite(item.param2) and item.param2 > 0):
        raise PlanError(WIRE.MAV_MISSION_INVALID_PARAM2, f"Item {item.seq} has no speed.")
    return kt_from_mps(item.param2)


def _read_place(item: Message, speed_kt: float | None, home: Home | None) -> Waypoint:
    if speed_kt is None:
        text = f"Item {item.seq} has no speed: put a change of airspeed before it, or give --speed-kt here."
        raise PlanError(WIRE.MAV_MISSION_INVALID, text)
    if item.frame in _HOME_FRAMES and home is not None:
        altitude_m = item.z + home.altitude_m
    elif item.frame in _SEA_FRAMES:
        altitude_m = item.z
    elif item.frame in _HOME_FRAMES:
        text = f"Item {item.seq} is above home, which nobody told: plan above mean sea level, or give --home here."
        raise PlanError(WIRE.MAV_MISSION_UNSUPPORTED_FRAME, text)
    else:
        text = f"Item {item.seq} has frame {item.frame}: plan above mean sea level."
        raise PlanError(WIRE.MAV_MISSION_UNSUPPORTED_FRAME, text)
    if not math.isfinite(altitude_m):
        raise PlanError(WIRE.MAV_MISSION_INVALID_PARAM7, f"Item {item.seq} has no altitude.")
    return Waypoint(item.x * 1e-7, item.y * 1e-7, ft_from_m(altitude_m), speed_kt)
