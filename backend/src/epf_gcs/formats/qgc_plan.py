"""Flight plans of QGroundControl (.plan): MAVLink mission items as JSON, metres and metres a second."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any, Final

import orjson

from epf_gcs.codec.tables import Waypoint
from epf_gcs.formats.mission_file import FileFault, MissionFile, Note, Place, Point, not_a_number, place_params, settle
from epf_gcs.formats.units import ft_from_m, kt_from_m_s, m_from_ft, m_s_from_kt

# MAV_CMD: a waypoint, one with a curved path, and a change of speed from there on.
_WAYPOINT: Final = 16
_SPLINE_WAYPOINT: Final = 82
_CHANGE_SPEED: Final = 178
# SPEED_TYPE: airspeed and ground speed; the other types are climb and descent speeds.
_FLYING_SPEEDS: Final = (0, 1)
# MAV_FRAME, each with its variant for integer coordinates.
_ABOVE_SEA: Final = (0, 5)
_ABOVE_HOME: Final = (3, 6)
_ABOVE_GROUND: Final = (10, 11)
_COMMAND_FRAME: Final = 2
# Values that the file requires and our plans do not have: fixed wing, generic autopilot.
_FIXED_WING: Final = 1
_GENERIC_AUTOPILOT: Final = 0
_ABSOLUTE_MODE: Final = 2
_HOVER_SPEED_M_S: Final = 5.0
_MOST_KINDS: Final = 8


def write_plan(waypoints: Sequence[Waypoint]) -> bytes:
    """A plan file: altitudes above mean sea level, a speed command before each waypoint at which the speed changes."""
    items: list[dict[str, Any]] = []
    speed_kt: float | None = None
    for waypoint in waypoints:
        if waypoint.speed_kt != speed_kt:
            speed_kt = waypoint.speed_kt
            speed = [0, m_s_from_kt(speed_kt), -1, 0, 0, 0, 0]
            items.append(_item(_CHANGE_SPEED, _COMMAND_FRAME, speed, len(items) + 1))
        altitude_m = m_from_ft(waypoint.altitude_ft)
        position = [0, 0, 0, None, waypoint.latitude_deg, waypoint.longitude_deg, altitude_m]
        item = _item(_WAYPOINT, _ABOVE_SEA[0], position, len(items) + 1)
        items.append({"AMSLAltAboveTerrain": None, "Altitude": altitude_m, "AltitudeMode": _ABSOLUTE_MODE, **item})
    first = waypoints[0]
    plan = {
        "fileType": "Plan",
        "geoFence": {"circles": [], "polygons": [], "version": 2},
        "groundStation": "EPF GCS",
        "mission": {
            "cruiseSpeed": m_s_from_kt(first.speed_kt),
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


def read_plan(data: bytes) -> MissionFile:
    """The waypoints of a plan file, with the speeds commanded before them. Raises FileFault.

    Heights above home become altitudes by adding the altitude of the file's planned home. Items that are not waypoints
    (take-off, landing, surveys, camera) are left out and noted.
    """
    mission = _mission(data)
    reader = _Reader(mission.get("plannedHomePosition"))
    items = mission.get("items")
    for index, item in enumerate(items if isinstance(items, list) else [], 1):
        reader.take(item, Place("item", index))
    return settle("plan", reader.points, reader.notes())


class _Reader:
    """Reads the items in order, because a commanded speed holds until the next one."""

    def __init__(self, home: object) -> None:
        self.points: list[Point] = []
        self._home = home
        self._speed_kt: float | None = None
        self._skipped: Counter[str] = Counter()
        self._from_home = 0
        self._above_ground = 0

    def take(self, item: object, place: Place) -> None:
        """Read the next item."""
        if not isinstance(item, dict):
            raise FileFault(
                "mission_file_unreadable", f"{place} is no item", field="item", value="", **place_params(place)
            )
        if item.get("type") != "SimpleItem":
            self._skipped[str(item.get("complexItemType") or item.get("type"))[:30]] += 1
            return
        command = item.get("command")
        params = item.get("params")
        parameters = params if isinstance(params, list) else []
        if command in (_WAYPOINT, _SPLINE_WAYPOINT):
            self._take_waypoint(item.get("frame"), parameters, place)
        elif command == _CHANGE_SPEED and _get(parameters, 0) in _FLYING_SPEEDS:
            self._take_speed(parameters, place)
        else:
            self._skipped[str(command)[:30]] += 1

    def notes(self) -> list[Note]:
        """What the operator should know about the file."""
        found: list[Note] = []
        if self._skipped:
            kinds = ", ".join(list(self._skipped)[:_MOST_KINDS])
            found.append(Note("items_skipped", {"count": self._skipped.total(), "kinds": kinds}))
        if self._from_home:
            home_ft = round(ft_from_m(self._home_m(Place("item", 1))), 1)
            found.append(Note("altitude_from_home", {"count": self._from_home, "home_ft": home_ft}))
        if self._above_ground:
            found.append(Note("altitude_above_ground", {"count": self._above_ground}))
        return found

    def _take_speed(self, parameters: list[Any], place: Place) -> None:
        speed_m_s = _number(parameters, 1, "speed", place)
        # -1 leaves the speed unchanged; any other negative value means the vehicle's default, which we do not know.
        if speed_m_s >= 0:
            self._speed_kt = kt_from_m_s(speed_m_s)
        elif speed_m_s != -1:
            self._speed_kt = None

    def _take_waypoint(self, frame: object, parameters: list[Any], place: Place) -> None:
        latitude_deg = _number(parameters, 4, "latitude_deg", place)
        longitude_deg = _number(parameters, 5, "longitude_deg", place)
        altitude_m = _number(parameters, 6, "altitude", place)
        if frame in _ABOVE_HOME:
            altitude_m += self._home_m(place)
            self._from_home += 1
        elif frame in _ABOVE_GROUND:
            self._above_ground += 1
        elif frame not in _ABOVE_SEA:
            raise FileFault(
                "mission_file_frame",
                f"the position of {place} is in frame {str(frame)[:20]}, which is not one of latitude and longitude",
                frame=str(frame)[:20],
                **place_params(place),
            )
        self.points.append(Point(place, latitude_deg, longitude_deg, ft_from_m(altitude_m), self._speed_kt))

    def _home_m(self, place: Place) -> float:
        home = self._home if isinstance(self._home, list) else []
        if not _is_number(_get(home, 2)):
            raise FileFault(
                "mission_file_no_home",
                f"the height of {place} counts from home and the file has no planned home",
                **place_params(place),
            )
        return float(home[2])


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


def _get(values: list[Any], index: int) -> Any:
    return values[index] if index < len(values) else None


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _number(values: list[Any], index: int, field: str, place: Place) -> float:
    value = _get(values, index)
    if not _is_number(value):
        raise not_a_number(field, "" if value is None else str(value), place)
    return float(value)
