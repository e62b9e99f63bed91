"""The published schemas of Foxglove that viewers know, with the fields that are given here."""

from __future__ import annotations

from typing import Any, Final

Schema = dict[str, Any]

DRAFT: Final = "https://json-schema.org/draft/2020-12/schema"
LEVELS: Final = {"UNKNOWN": 0, "DEBUG": 1, "INFO": 2, "WARNING": 3, "ERROR": 4, "FATAL": 5}


def _choice(title: str, doc: str, numbers: dict[str, int]) -> Schema:
    return {
        "title": title,
        "description": doc,
        "oneOf": [{"title": name, "const": number} for name, number in numbers.items()],
    }


def _object(title: str, doc: str, properties: dict[str, Schema]) -> Schema:
    return {
        "title": title,
        "description": doc,
        "type": "object",
        "properties": properties,
        "required": list(properties),
    }


def _numbers(docs: dict[str, str]) -> dict[str, Schema]:
    return {name: {"type": "number", "description": doc} for name, doc in docs.items()}


def _text(doc: str) -> Schema:
    return {"type": "string", "description": doc}


_TIME: Final[Schema] = {
    "type": "object",
    "title": "time",
    "description": "Unix time of the sample.",
    "properties": {
        "sec": {"type": "integer", "minimum": 0},
        "nsec": {"type": "integer", "minimum": 0, "maximum": 999_999_999},
    },
}
LOCATION_FIX: Final = "foxglove.LocationFix"
LOCATION_FIX_SCHEMA: Final[Schema] = {
    "$schema": DRAFT,
    **_object(
        LOCATION_FIX,
        "Where the aircraft is, as map panels read it.",
        {
            "timestamp": _TIME,
            "frame_id": _text("Whose position it is: the flight's or the simulator's."),
            **_numbers(
                {
                    "latitude": "deg, north positive, WGS84",
                    "longitude": "deg, east positive, WGS84",
                    "altitude": "m above mean sea level",
                }
            ),
            "position_covariance": {
                "type": "array",
                "items": {"type": "number"},
                "minItems": 9,
                "maxItems": 9,
                "description": "m^2, east, north and up, row by row; zeros, for it is not known.",
            },
            "position_covariance_type": _choice(
                "foxglove.PositionCovarianceType",
                "0: the covariance is not known.",
                {"UNKNOWN": 0, "APPROXIMATED": 1, "DIAGONAL_KNOWN": 2, "KNOWN": 3},
            ),
        },
    ),
}
POSE_SCHEMA: Final[Schema] = {
    "$schema": DRAFT,
    **_object(
        "foxglove.PoseInFrame",
        "Where the aircraft is and how it lies, as 3D panels read it. Its own axes point forward, left and up.",
        {
            "timestamp": _TIME,
            "frame_id": _text("The place where this flight has its first position; x is east, y north and z up."),
            "pose": _object(
                "foxglove.Pose",
                "Place and attitude of the aircraft.",
                {
                    "position": _object(
                        "foxglove.Vector3",
                        "From where the flight has its first position; zeros where it has none.",
                        _numbers({"x": "m east", "y": "m north", "z": "m up"}),
                    ),
                    "orientation": _object(
                        "foxglove.Quaternion",
                        "Turns forward, left and up of the aircraft into east, north and up.",
                        _numbers({axis: f"{axis} of the quaternion" for axis in "xyzw"}),
                    ),
                },
            ),
        },
    ),
}
LOG_SCHEMA: Final[Schema] = {
    "$schema": DRAFT,
    **_object(
        "foxglove.Log",
        "What happened, as log panels read it; the topic events has the same with all its fields.",
        {
            "timestamp": _TIME,
            "level": _choice(
                "foxglove.LogLevel", "Critical alarms are errors; other alarms, gaps and damage warnings.", LEVELS
            ),
            "message": _text("What happened, in words."),
            "name": _text("Its kind."),
            "file": _text("Empty."),
            "line": {"type": "integer", "minimum": 0, "description": "0"},
        },
    ),
}
