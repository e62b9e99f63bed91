"""MAVLink mission items, as QGroundControl and Mission Planner save them: metres and metres a second."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any, Final, TypeGuard

from epf_gcs.formats.mission_file import FileFault, Frame, Note, Place, Point, frame_fault, not_a_number, place_params
from epf_gcs.units import ft_from_m, kt_from_mps

WAYPOINT: Final = 16
"""MAV_CMD: fly to a position."""
CHANGE_SPEED: Final = 178
"""MAV_CMD: a change of speed from there on."""
WAYPOINTS: Final = (WAYPOINT, 82)
"""The same, and along a spline."""
_SET_HOME: Final = 179
# SPEED_TYPE: airspeed and ground speed; the other types are climb and descent speeds.
_FLYING_SPEEDS: Final = (0, 1)
# MAV_FRAME, each with its variant for integer coordinates.
ABOVE_SEA: Final = (0, 5)
"""MAV_FRAME: altitude above mean sea level."""
_FRAME: Final[dict[int, Frame]] = {0: "sea", 5: "sea", 3: "home", 6: "home", 10: "ground", 11: "ground"}
_MOST_KINDS: Final = 8


class ItemReader:
    """Reads the items in order, because a commanded speed holds until the next one.

    `home`: latitude, longitude [deg] and altitude [m] of where the flight begins, as far as the file has it.
    """

    def __init__(self, home: object) -> None:
        self.points: list[Point] = []
        home_m = _altitude_m(home)
        self.home_ft = None if home_m is None else ft_from_m(home_m)
        self._home_moved = False
        self._speed_kt: float | None = None
        self._skipped: Counter[str] = Counter()

    def skip(self, kind: str) -> None:
        """Leave out an item of a kind that a plan of ours does not have."""
        self._skipped[kind[:30]] += 1

    def take(self, command: object, frame: object, parameters: Sequence[Any], place: Place) -> None:
        """Read the next item. Raises FileFault naming the place."""
        if command in WAYPOINTS:
            self._take_waypoint(frame, parameters, place)
        elif command == CHANGE_SPEED and _get(parameters, 0) in _FLYING_SPEEDS:
            self._take_speed(parameters, place)
        else:
            if command == _SET_HOME:
                # Heights count from the new home from here on, and it may be wherever the aircraft is then.
                self._home_moved = True
            self.skip(str(command))

    def notes(self) -> list[Note]:
        """What the operator should know about the file."""
        found: list[Note] = []
        if self._skipped:
            kinds = ", ".join(list(self._skipped)[:_MOST_KINDS])
            found.append(Note("items_skipped", {"count": self._skipped.total(), "kinds": kinds}))
        return found

    def _take_speed(self, parameters: Sequence[Any], place: Place) -> None:
        speed_m_s = _number(parameters, 1, "speed", place)
        # -1 leaves the speed unchanged; any other negative value means the vehicle's default, which we do not know.
        if speed_m_s >= 0:
            self._speed_kt = kt_from_mps(speed_m_s)
        elif speed_m_s != -1:
            self._speed_kt = None

    def _take_waypoint(self, frame: object, parameters: Sequence[Any], place: Place) -> None:
        latitude_deg = _number(parameters, 4, "latitude_deg", place)
        longitude_deg = _number(parameters, 5, "longitude_deg", place)
        altitude_m = _number(parameters, 6, "altitude", place)
        counts_from = _FRAME.get(int(frame)) if _is_number(frame) and frame == frame // 1 else None
        if counts_from is None:
            raise frame_fault(str(frame), place)
        if counts_from == "home" and self._home_moved:
            raise FileFault(
                "mission_file_home_moves",
                f"the height of {place} counts from a home that an item before it moves",
                **place_params(place),
            )
        altitude_ft = ft_from_m(altitude_m)
        self.points.append(Point(place, latitude_deg, longitude_deg, altitude_ft, self._speed_kt, counts_from))


def _altitude_m(home: object) -> float | None:
    """Of a home as latitude, longitude and altitude; None if any is missing, or it was never set: 0, 0."""
    values = home[:3] if isinstance(home, list) else []
    is_set = len(values) == 3 and all(map(_is_number, values)) and any(values[:2])
    return float(values[2]) if is_set else None


def _get(values: Sequence[Any], index: int) -> Any:
    return values[index] if index < len(values) else None


def _is_number(value: object) -> TypeGuard[int | float]:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _number(values: Sequence[Any], index: int, field: str, place: Place) -> float:
    value = _get(values, index)
    if not _is_number(value):
        raise not_a_number(field, "" if value is None else str(value), place)
    return float(value)
