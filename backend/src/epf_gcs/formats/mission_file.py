"""What the readers of plan files return, and the faults of such files."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, Literal, NamedTuple

from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.codec.tables import Waypoint
from epf_gcs.errors import ErrorCode, Params

Format = Literal["kml", "gpx", "csv", "plan", "waypoints", "flight"]
"""What a plan was read from; `flight`: a flight of this station."""
FileFormat = Literal["kml", "kmz", "gpx", "csv", "plan"]
"""What a file is written as: KMZ is KML, packed."""
Frame = Literal["sea", "home", "ground"]
"""What a height counts from: mean sea level, home, or the ground below."""
NoteCode = Literal[
    "altitude_clamped",
    "altitude_from_ground",
    "altitude_from_home",
    "altitude_missing",
    "columns_skipped",
    "home_off_ground",
    "home_skipped",
    "items_skipped",
    "shapes_skipped",
    "speed_missing",
    "track_pieces",
    "track_thinned",
]

MAX_WAYPOINTS: Final = int({value.name: value for value in COMMANDS["mission_begin"].values}["count"].maximum or 0)
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
    """A waypoint as read; None: not in the file. `altitude_ft` counts from what `frame` says."""

    place: Place
    latitude_deg: float
    longitude_deg: float
    altitude_ft: float | None
    speed_kt: float | None
    frame: Frame = "sea"


@dataclass(frozen=True, slots=True)
class FilePlan:
    """What a file has, with its heights as they are in it. `home_ft`: the planned home's altitude above the sea, if the
    file says it. `is_track`: the points are a flown track, of any number."""

    format: Format
    points: Sequence[Point]
    notes: Sequence[Note] = ()
    home_ft: float | None = None
    is_track: bool = False


class AltitudeOrigin(NamedTuple):
    """What an altitude above the sea was converted from: a height above `frame`, and the altitude of that."""

    frame: Literal["home", "ground"]
    height_ft: float
    reference_ft: float


@dataclass(frozen=True, slots=True)
class MissionFile:
    """A file that could be read, as a plan that can be sent to the board. `origins`: one for each waypoint, None where
    the file itself gives the altitude above the sea, or none."""

    format: Format
    waypoints: tuple[Waypoint, ...]
    notes: tuple[Note, ...]
    origins: tuple[AltitudeOrigin | None, ...]


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


def not_a_number(field: str, found: str, place: Place) -> FileFault:
    """The error for a value that is missing or not a number."""
    why = f"{field} of {place} is missing" if not found else f"{field} of {place} is no number ({found[:30]!r})"
    return FileFault("mission_file_unreadable", why, field=field, value=found[:30], **place_params(place))


def frame_fault(frame: str, place: Place) -> FileFault:
    """The error for a position whose frame, or whose altitude's mode, is not known here."""
    return FileFault(
        "mission_file_frame",
        f"the position of {place} is given in {frame[:30]!r}, which is not latitude, longitude and a height above the "
        "sea, home or the ground",
        frame=frame[:30],
        **place_params(place),
    )


def place_params(place: Place) -> dict[str, str | float]:
    """The place as parameters of a sentence that the page translates; the kind becomes a key of its words."""
    return {"place": f"@problem.place_{place.kind}", "nth": place.nth}
