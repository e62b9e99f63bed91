"""MAVLink mission items, as QGroundControl and Mission Planner save them: metres and metres a second."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any, Final

from epf_gcs.formats.mission_file import FileFault, Note, Place, Point, above_ground, not_a_number, place_params
from epf_gcs.formats.units import ft_from_m, kt_from_m_s

WAYPOINT: Final = 16
"""MAV_CMD: fly to a position."""
CHANGE_SPEED: Final = 178
"""MAV_CMD: a change of speed from there on."""
_SPLINE_WAYPOINT: Final = 82
# SPEED_TYPE: airspeed and ground speed; the other types are climb and descent speeds.
_FLYING_SPEEDS: Final = (0, 1)
# MAV_FRAME, each with its variant for integer coordinates.
ABOVE_SEA: Final = (0, 5)
"""MAV_FRAME: altitude above mean sea level."""
_ABOVE_HOME: Final = (3, 6)
_ABOVE_GROUND: Final = (10, 11)
_MOST_KINDS: Final = 8


class ItemReader:
    """Reads the items in order, because a commanded speed holds until the next one.

    `home`: latitude, longitude [deg] and altitude [m] of where the flight begins, as far as the file has it.
    """

    def __init__(self, home: object) -> None:
        self.points: list[Point] = []
        self._home = home
        self._speed_kt: float | None = None
        self._skipped: Counter[str] = Counter()
        self._from_home = 0

    def skip(self, kind: str) -> None:
        """Leave out an item of a kind that a plan of ours does not have."""
        self._skipped[kind[:30]] += 1

    def take(self, command: object, frame: object, parameters: Sequence[Any], place: Place) -> None:
        """Read the next item. Raises FileFault naming the place."""
        if command in (WAYPOINT, _SPLINE_WAYPOINT):
            self._take_waypoint(frame, parameters, place)
        elif command == CHANGE_SPEED and _get(parameters, 0) in _FLYING_SPEEDS:
            self._take_speed(parameters, place)
        else:
            self.skip(str(command))

    def notes(self) -> list[Note]:
        """What the operator should know about the file."""
        found: list[Note] = []
        if self._skipped:
            kinds = ", ".join(list(self._skipped)[:_MOST_KINDS])
            found.append(Note("items_skipped", {"count": self._skipped.total(), "kinds": kinds}))
        if self._from_home:
            home_ft = round(ft_from_m(self._home_m(Place("item", 1))), 1)
            found.append(Note("altitude_from_home", {"count": self._from_home, "home_ft": home_ft}))
        return found

    def _take_speed(self, parameters: Sequence[Any], place: Place) -> None:
        speed_m_s = _number(parameters, 1, "speed", place)
        # -1 leaves the speed unchanged; any other negative value means the vehicle's default, which we do not know.
        if speed_m_s >= 0:
            self._speed_kt = kt_from_m_s(speed_m_s)
        elif speed_m_s != -1:
            self._speed_kt = None

    def _take_waypoint(self, frame: object, parameters: Sequence[Any], place: Place) -> None:
        latitude_deg = _number(parameters, 4, "latitude_deg", place)
        longitude_deg = _number(parameters, 5, "longitude_deg", place)
        altitude_m = _number(parameters, 6, "altitude", place)
        if frame in _ABOVE_HOME:
            altitude_m += self._home_m(place)
            self._from_home += 1
        elif frame in _ABOVE_GROUND:
            raise above_ground(place)
        elif frame not in ABOVE_SEA:
            raise FileFault(
                "mission_file_frame",
                f"the position of {place} is in frame {str(frame)[:20]}, which is not one of latitude and longitude",
                frame=str(frame)[:20],
                **place_params(place),
            )
        self.points.append(Point(place, latitude_deg, longitude_deg, ft_from_m(altitude_m), self._speed_kt))

    def _home_m(self, place: Place) -> float:
        home = self._home if isinstance(self._home, list) else []
        # Ground stations write zeros for a home that nobody has set.
        if not _is_number(_get(home, 2)) or not any(home[:3]):
            raise FileFault(
                "mission_file_no_home",
                f"the height of {place} counts from home and the file has no planned home",
                **place_params(place),
            )
        return float(home[2])


def _get(values: Sequence[Any], index: int) -> Any:
    return values[index] if index < len(values) else None


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _number(values: Sequence[Any], index: int, field: str, place: Place) -> float:
    value = _get(values, index)
    if not _is_number(value):
        raise not_a_number(field, "" if value is None else str(value), place)
    return float(value)
