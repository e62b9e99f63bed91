"""What the readers of plan files return, and the checks that all files pass to become a plan for the board."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, Literal, NamedTuple

from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.codec.tables import Waypoint
from epf_gcs.codec.values import argument_fault
from epf_gcs.errors import ErrorCode, Params

Format = Literal["kml", "gpx", "csv", "plan", "waypoints"]
FileFormat = Literal["kml", "kmz", "gpx", "csv", "plan"]
"""What a file is written as: KMZ is KML, packed."""
NoteCode = Literal[
    "altitude_clamped",
    "altitude_from_home",
    "altitude_missing",
    "columns_skipped",
    "home_skipped",
    "items_skipped",
    "shapes_skipped",
    "speed_missing",
]

# For waypoints whose file gives no speed or altitude, as in most files of other programs: the cruise speed of the
# board's own routes, and a round altitude at which a person notices that it was not in the file.
DEFAULT_SPEED_KT: Final = 55.0
DEFAULT_ALTITUDE_FT: Final = 1000.0

_ITEM: Final = {value.name: value for value in COMMANDS["mission_item"].values}
_FIELDS: Final = ("latitude_deg", "longitude_deg", "altitude_ft", "speed_kt")
MAX_WAYPOINTS: Final = int({value.name: value for value in COMMANDS["mission_begin"].values}["count"].maximum or 0)
# Rounds to 0.03 mm and 0.05 mm/s, just enough to remove the error of converting units twice (1000.0000000000001 ft).
_DECIMALS: Final = 4
# float() alone would also accept "1_000", "infinity", "nan" and digits of other scripts.
_NUMBER: Final = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")


class Place(NamedTuple):
    """A place in the file, counted from 1: a line, an item of a list, or the n-th element of a name."""

    kind: str
    nth: int

    def __str__(self) -> str:
        return f"{self.kind} {self.nth}"


class Note(NamedTuple):
    """Something about the file that the operator should know before flying it."""

    code: NoteCode
    params: Params


class Point(NamedTuple):
    """A waypoint as read; None: not in the file."""

    place: Place
    latitude_deg: float
    longitude_deg: float
    altitude_ft: float | None
    speed_kt: float | None


@dataclass(frozen=True, slots=True)
class MissionFile:
    """A file that could be read, as a plan that can be sent to the board."""

    format: Format
    waypoints: tuple[Waypoint, ...]
    notes: tuple[Note, ...]


class FileFault(Exception):  # noqa: N818 - a fault of the file, told to its owner as a GatewayError with the name
    """Why a file is not a plan: "'name' cannot be read because `why`." `params` are the values in the sentence."""

    def __init__(self, code: ErrorCode, why: str, **params: str | float | bool | None) -> None:
        super().__init__(why)
        self.code: ErrorCode = code
        self.why = why
        self.params: Params = params


def number(text: str | None, field: str, place: Place) -> float:
    """A finite number. Raises FileFault naming field and place."""
    stripped = (text or "").strip()
    value = float(stripped) if _NUMBER.fullmatch(stripped) else math.nan
    if not math.isfinite(value):
        raise not_a_number(field, stripped, place)
    return value


_THOUSANDS: Final = re.compile(r"[+-]?[1-9][0-9]{0,2}[.,][0-9]{3}")


def is_ambiguous(text: str, largest: float) -> bool:
    """Whether "1.000" or "1,000" may be a thousand for the one who wrote it and one for who reads it.

    Not where a thousand times as much is larger than any value of this kind, as in coordinates.
    """
    return _THOUSANDS.fullmatch(text) is not None and abs(float(re.sub("[.,]", "", text))) <= largest


def not_a_number(field: str, found: str, place: Place) -> FileFault:
    """The error for a value that is missing or not a number."""
    why = f"{field} of {place} is missing" if not found else f"{field} of {place} is no number ({found[:30]!r})"
    return FileFault("mission_file_unreadable", why, field=field, value=found[:30], **place_params(place))


def above_ground(place: Place) -> FileFault:
    """The error for a height above the ground: the board flies altitudes above mean sea level."""
    return FileFault(
        "mission_file_above_ground",
        f"the height of {place} is above the ground, and the board flies altitudes above mean sea level: "
        "save it with absolute altitudes",
        **place_params(place),
    )


def place_params(place: Place) -> dict[str, str | float]:
    """The place as parameters of a sentence that the page translates; the kind becomes a key of its words."""
    return {"place": f"@problem.place_{place.kind}", "nth": place.nth}


def settle(format_name: Format, points: Sequence[Point], notes: Sequence[Note] = ()) -> MissionFile:
    """The points as a plan. Raises FileFault, naming the place, if a value is outside what the board accepts.

    Missing altitudes and speeds are filled in with defaults, and noted.
    """
    if not points:
        raise FileFault("mission_file_no_waypoints", "there are no waypoints in it", format=format_name)
    if len(points) > MAX_WAYPOINTS:
        raise FileFault(
            "mission_file_too_long",
            f"it has more than {MAX_WAYPOINTS} waypoints, which is what a plan takes",
            maximum=MAX_WAYPOINTS,
        )
    found = list(notes)
    without_altitude = sum(point.altitude_ft is None for point in points)
    if without_altitude:
        found.append(Note("altitude_missing", {"count": without_altitude, "altitude_ft": DEFAULT_ALTITUDE_FT}))
    without_speed = sum(point.speed_kt is None for point in points)
    if without_speed:
        found.append(Note("speed_missing", {"count": without_speed, "speed_kt": DEFAULT_SPEED_KT}))
    return MissionFile(format_name, tuple(_waypoint(point) for point in points), tuple(found))


def _waypoint(point: Point) -> Waypoint:
    waypoint = Waypoint(
        point.latitude_deg,
        point.longitude_deg,
        DEFAULT_ALTITUDE_FT if point.altitude_ft is None else round(point.altitude_ft, _DECIMALS),
        DEFAULT_SPEED_KT if point.speed_kt is None else round(point.speed_kt, _DECIMALS),
    )
    for field in _FIELDS:
        value, given = _ITEM[field], getattr(waypoint, field)
        fault = argument_fault(value, given)
        if fault is not None:
            raise FileFault(
                "mission_file_out_of_range",
                f"in {point.place} {fault}",
                field=field,
                value=given,
                minimum=value.minimum,
                maximum=value.maximum,
                **place_params(point.place),
            )
    return waypoint
