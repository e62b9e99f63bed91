"""Flight plans of QGroundControl (.plan): MAVLink mission items as JSON, metres and metres a second."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

import orjson

from epf_gcs.codec.tables import Waypoint
from epf_gcs.formats.mavlink_items import ABOVE_SEA, CHANGE_SPEED, WAYPOINT, WAYPOINTS, ItemReader
from epf_gcs.formats.mission_file import FileFault, FilePlan, Place, place_params
from epf_gcs.units import m_from_ft, mps_from_kt

# MAV_FRAME of a command without a position.
_COMMAND_FRAME: Final = 2
# Values that the file requires and our plans do not have: fixed wing, generic autopilot.
_FIXED_WING: Final = 1
_GENERIC_AUTOPILOT: Final = 0
_ABSOLUTE_MODE: Final = 2
_HOVER_SPEED_M_S: Final = 5.0
# QGroundControl's AltitudeMode with the frames that it writes for it: above home; above the sea, also as worked out
# from its own terrain; above the terrain. Other modes say nothing.
_FRAMES_OF_MODE: Final = {1: (3, 6), 2: (0, 5), 3: (0, 5), 4: (10, 11)}


def write_plan(waypoints: Sequence[Waypoint]) -> bytes:
    """A plan file: altitudes above mean sea level, a speed command before each waypoint at which the speed changes."""
    items: list[dict[str, Any]] = []
    speed_kt: float | None = None
    for waypoint in waypoints:
        if waypoint.speed_kt != speed_kt:
            speed_kt = waypoint.speed_kt
            speed = [0, mps_from_kt(speed_kt), -1, 0, 0, 0, 0]
            items.append(_item(CHANGE_SPEED, _COMMAND_FRAME, speed, len(items) + 1))
        altitude_m = m_from_ft(waypoint.altitude_ft)
        position = [0, 0, 0, None, waypoint.latitude_deg, waypoint.longitude_deg, altitude_m]
        item = _item(WAYPOINT, ABOVE_SEA[0], position, len(items) + 1)
        items.append({"AMSLAltAboveTerrain": None, "Altitude": altitude_m, "AltitudeMode": _ABSOLUTE_MODE, **item})
    first = waypoints[0]
    plan = {
        "fileType": "Plan",
        "geoFence": {"circles": [], "polygons": [], "version": 2},
        "groundStation": "EPF GCS",
        "mission": {
            "cruiseSpeed": mps_from_kt(first.speed_kt),
            "firmwareType": _GENERIC_AUTOPILOT,
            "globalPlanAltitudeMode": _ABSOLUTE_MODE,
            "hoverSpeed": _HOVER_SPEED_M_S,
            "items": items,
            "plannedHomePosition": [first.latitude_deg, first.longitude_deg, m_from_ft(first.altitude_ft)],
            "vehicleType": _FIXED_WING,
            "version": 2,
        },
        "rallyPoints": {"points": [], "version": 2},
        "version": 1,
    }
    return orjson.dumps(plan, option=orjson.OPT_INDENT_2)


def read_plan(data: bytes) -> FilePlan:
    """The waypoints of a plan file, with the speeds commanded before them. Raises FileFault.

    Heights above home count from the file's planned home, where it says one. Items that are not waypoints
    (take-off, landing, surveys, camera) are left out and noted.
    """
    mission = _mission(data)
    reader = ItemReader(mission.get("plannedHomePosition"))
    items = mission.get("items")
    for index, item in enumerate(items if isinstance(items, list) else [], 1):
        _take(reader, item, Place("item", index))
    return FilePlan("plan", reader.points, reader.notes(), reader.home_ft)


def has_fence(data: bytes) -> bool:
    """Whether a plan file has a fence, whatever else it has."""
    try:
        plan = orjson.loads(data)
    except orjson.JSONDecodeError:
        return False
    fence = plan.get("geoFence") if isinstance(plan, dict) else None
    return isinstance(fence, dict) and bool(fence.get("polygons") or fence.get("circles"))


def _take(reader: ItemReader, item: object, place: Place) -> None:
    if not isinstance(item, dict):
        raise FileFault("mission_file_unreadable", f"{place} is no item", field="item", value="", **place_params(place))
    if item.get("type") != "SimpleItem":
        reader.skip(str(item.get("complexItemType") or item.get("type")))
        return
    params = item.get("params")
    _refuse_other_mode(item, place)
    reader.take(item.get("command"), item.get("frame"), params if isinstance(params, list) else [], place)


def _refuse_other_mode(item: dict[str, Any], place: Place) -> None:
    """QGroundControl shows the height by its mode, and an aircraft flies it by its frame: they have to agree."""
    mode, frame = item.get("AltitudeMode"), item.get("frame")
    fitting = _FRAMES_OF_MODE.get(mode) if isinstance(mode, int) and item.get("command") in WAYPOINTS else None
    if fitting is not None and frame not in fitting and any(frame in frames for frames in _FRAMES_OF_MODE.values()):
        raise FileFault(
            "mission_file_frame_differs",
            f"the height of {place} is of mode {mode} and in frame {frame}, which do not go together",
            mode=mode,
            frame=str(frame),
            **place_params(place),
        )


def _mission(data: bytes) -> dict[str, Any]:
    try:
        plan = orjson.loads(data.removeprefix(b"\xef\xbb\xbf"))
    except orjson.JSONDecodeError as error:
        raise FileFault(
            "mission_file_damaged", f"it is no whole JSON at line {error.lineno}", format="plan", line=error.lineno
        ) from error
    mission = plan.get("mission") if isinstance(plan, dict) and plan.get("fileType") == "Plan" else None
    if not isinstance(mission, dict):
        raise FileFault("mission_file_unknown", "it is JSON, but no .plan of QGroundControl")
    return mission


def _item(command: int, frame: int, params: Sequence[float | None], jump_id: int) -> dict[str, Any]:
    return {
        "autoContinue": True,
        "command": command,
        "doJumpId": jump_id,
        "frame": frame,
        "params": params,
        "type": "SimpleItem",
    }
