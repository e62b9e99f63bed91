"""What a file of this field is if it is no plan, so that its refusal can say so, and what can be done with it."""

from __future__ import annotations

import re
from typing import Final, Literal

import orjson

FileKind = Literal["areas", "log", "parameters", "rally", "recording"]

# ArduPilot's log, PX4's log, and the packets of MAVLink behind a time of eight bytes, as stations record them.
_LOGS: Final = (b"\xa3\x95", b"ULog\x01\x12\x35")
_MAVLINK: Final = frozenset(b"\xfe\xfd")
_RECORDING: Final = b"\x89MCAP0\r\n"
# QGroundControl: vehicle, component, name, value, type. Mission Planner and MAVProxy: name and value.
_PARAMETER: Final = re.compile(rb"(?:\d+\t\d+\t)?[A-Z][A-Z0-9_]{2,15}[ \t,]+[-+]?[0-9.]+(?:[eE][-+]?\d+)?(?:\t\d+)?")
_RALLY: Final = re.compile(rb"RALLY(?:\s+[-+0-9.]+){2,}")
_RALLY_ITEM: Final = "5100"
_COMMAND: Final = 3
_GEOJSON: Final = frozenset({"FeatureCollection", "Feature", "GeometryCollection", "Polygon", "LineString"})


def kind_of(data: bytes) -> FileKind | None:
    """What the first bytes or lines say; None if they say nothing that is known here."""
    if data.startswith(_RECORDING):
        return "recording"
    if data.startswith(_LOGS) or (len(data) > 8 and data[:1] == b"\0" and data[8] in _MAVLINK):
        return "log"
    lines = (line.strip() for line in data[:4096].splitlines())
    first = next((line for line in lines if line and not line.startswith(b"#")), b"")
    if _PARAMETER.fullmatch(first):
        return "parameters"
    if _RALLY.fullmatch(first) or _has_rally_items(data):
        return "rally"
    return _kind_of_json(data) if first.startswith(b"{") else None


def _has_rally_items(data: bytes) -> bool:
    rows = (line.split() for line in data.decode("utf-8", "replace").splitlines())
    return data.startswith(b"QGC WPL") and any(len(row) > _COMMAND and row[_COMMAND] == _RALLY_ITEM for row in rows)


def _kind_of_json(data: bytes) -> FileKind | None:
    try:
        said = orjson.loads(data)
    except orjson.JSONDecodeError:
        return None
    if said.get("type") in _GEOJSON:
        return "areas"
    rally = said.get("rallyPoints")
    return "rally" if isinstance(rally, dict) and rally.get("points") else None
