"""Flight plans of Mission Planner (`.waypoints`, "QGC WPL 110"): MAVLink mission items, one a line."""

from __future__ import annotations

from typing import Final, Literal

from epf_gcs.formats.mavlink_items import ABOVE_SEA, WAYPOINT, ItemReader
from epf_gcs.formats.mission_file import (
    FileFault,
    FilePlan,
    Note,
    Place,
    not_a_number,
    number,
    place_params,
)

SIGNATURE: Final = b"QGC WPL "
"""The first bytes of such a file; its version follows."""
_VERSION: Final = "110"
# Sequence number, whether it is the current one, frame, command, seven parameters, whether to go on.
_COLUMNS: Final = 12
_INDEX: Final = 0
_FRAME: Final = 2
_COMMAND: Final = 3
_PARAMETERS: Final = slice(4, 11)
_MAX_ITEMS: Final = 5000


FirstItem = Literal["home", "waypoint"]
"""What item 0 is: where the flight begins, or a waypoint as others."""


def read_wpl(data: bytes, first: FirstItem | None = None) -> FilePlan:
    """The waypoints of the file, with the speeds commanded before them. Raises FileFault naming the line.

    Item 0 is where the flight begins, not a waypoint: Mission Planner writes it so, above the sea, and heights above
    home count from it. Programs that know no home write their first waypoint as item 0, with a height as waypoints have
    it: then `first` is what a person says. A file that begins with another item has no home. What is no waypoint is
    left out and noted.
    """
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        raise FileFault("mission_file_damaged", "its text cannot be read", format="waypoints", line=1) from error
    head, *lines = text.splitlines()
    if head.split() != ["QGC", "WPL", _VERSION]:
        raise FileFault("mission_file_unknown", f"it is a list of waypoints of another version ({head[:30]!r})")
    items = [(Place("line", at), line.split()) for at, line in enumerate(lines, 2) if line.strip()]
    if len(items) > _MAX_ITEMS:
        raise FileFault("mission_file_too_long", f"it has more than {_MAX_ITEMS} items", maximum=_MAX_ITEMS)
    reader = ItemReader(None)
    notes: list[Note] = []
    for nth, (place, cells) in enumerate(items):
        index, frame, command, parameters = _item(cells, place)
        if nth == 0 and index == 0 and command == WAYPOINT and _is_home(frame, first, place):
            reader = ItemReader(parameters[4:7] if frame in ABOVE_SEA else None)
            notes.append(Note("home_skipped", {"latitude_deg": parameters[4], "longitude_deg": parameters[5]}))
        elif command == WAYPOINT and parameters[4:6] == [0, 0]:
            # MAVLink's way to say "where the aircraft is then".
            raise not_a_number("latitude_deg", "", place)
        else:
            reader.take(command, frame, parameters, place)
    return FilePlan("waypoints", reader.points, [*notes, *reader.notes()], reader.home_ft)


def _is_home(frame: int, first: FirstItem | None, place: Place) -> bool:
    """Whether item 0 is. Raises FileFault if its height is one of a waypoint, and nobody says which it is."""
    if frame not in ABOVE_SEA and first is None:
        raise FileFault(
            "mission_file_home_unclear",
            f"{place} is item 0, which is home, and has a height as a waypoint has it, in frame {frame}: "
            "say with `first` what it is",
            frame=frame,
            **place_params(place),
        )
    return frame in ABOVE_SEA or first == "home"


def _item(cells: list[str], place: Place) -> tuple[int, int, int, list[float]]:
    if len(cells) < _COLUMNS:
        raise FileFault(
            "mission_file_damaged",
            f"{place} has {len(cells)} columns instead of {_COLUMNS}",
            format="waypoints",
            line=place.nth,
        )
    index = _whole(cells[_INDEX], "index", place)
    frame = _whole(cells[_FRAME], "frame", place)
    command = _whole(cells[_COMMAND], "command", place)
    names = ("param1", "param2", "param3", "param4", "latitude_deg", "longitude_deg", "altitude")
    parameters = [number(cell, name, place) for cell, name in zip(cells[_PARAMETERS], names, strict=True)]
    return index, frame, command, parameters


def _whole(text: str, field: str, place: Place) -> int:
    value = number(text, field, place)
    if not value.is_integer():
        raise not_a_number(field, text, place)
    return int(value)
