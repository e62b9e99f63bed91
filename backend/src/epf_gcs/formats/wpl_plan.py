"""Flight plans of Mission Planner (`.waypoints`, "QGC WPL 110"): MAVLink mission items, one a line."""

from __future__ import annotations

from typing import Final

from epf_gcs.formats.mavlink_items import WAYPOINT, ItemReader
from epf_gcs.formats.mission_file import FileFault, MissionFile, Note, Place, number, settle

SIGNATURE: Final = b"QGC WPL "
"""The first bytes of such a file; its version follows."""
_VERSION: Final = "110"
# Sequence number, whether it is the current one, frame, command, seven parameters, whether to go on.
_COLUMNS: Final = 12
_SEQUENCE: Final = 0
_FRAME: Final = 2
_COMMAND: Final = 3
_PARAMETERS: Final = slice(4, 11)
_MAX_ITEMS: Final = 5000


def read_wpl(data: bytes) -> MissionFile:
    """The waypoints of the file, with the speeds commanded before them. Raises FileFault naming the line.

    Item 0 is where the flight begins, not a waypoint: Mission Planner writes it so, and heights above home count from
    it. A file that begins with item 1 has no home: all its waypoints are taken, and heights above home are refused.
    What is no waypoint is left out and noted.
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
        sequence, frame, command, parameters = _item(cells, place)
        if nth == 0 and sequence == 0 and command == WAYPOINT:
            reader = ItemReader(parameters[4:7])
            notes.append(Note("home_skipped", {"latitude_deg": parameters[4], "longitude_deg": parameters[5]}))
        else:
            reader.take(command, frame, parameters, place)
    return settle("waypoints", reader.points, [*notes, *reader.notes()])


def _item(cells: list[str], place: Place) -> tuple[int, int, int, list[float]]:
    if len(cells) < _COLUMNS:
        raise FileFault(
            "mission_file_damaged",
            f"{place} has {len(cells)} columns instead of {_COLUMNS}",
            format="waypoints",
            line=place.nth,
        )
    sequence = number(cells[_SEQUENCE], "sequence number", place)
    frame = number(cells[_FRAME], "frame", place)
    command = number(cells[_COMMAND], "command", place)
    names = ("param1", "param2", "param3", "param4", "latitude_deg", "longitude_deg", "altitude")
    parameters = [number(cell, name, place) for cell, name in zip(cells[_PARAMETERS], names, strict=True)]
    return int(sequence), int(frame), int(command), parameters
