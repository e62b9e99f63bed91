"""JSON schemas of the topics, from the definition of the wire and of the simulator's rows.

A value that the board did not have is left out of the message rather than null: readers plot a number or nothing, and
some refuse a type that may be two.
"""

from __future__ import annotations

from typing import Any, Final

import pyarrow as pa

from epf_gcs.codec.messages_gen import COMMANDS_BY_ID, TELEMETRY, XPLANE_ROWS
from epf_gcs.codec.tables import Message, Value
from epf_gcs.flights.columns import SENT
from epf_gcs.flights.convert import DESCRIPTION
from epf_gcs.xplane.mapping import in_our_unit

Schema = dict[str, Any]

_DRAFT: Final = "https://json-schema.org/draft/2020-12/schema"
_TYPES: Final = {"number": "number", "integer": "integer", "boolean": "boolean", "text": "string"}
_MESSAGES: Final[dict[str, Message]] = {message.name: message for message in TELEMETRY.values()} | {
    SENT + message.name: message for message in COMMANDS_BY_ID.values()
}
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
    "$schema": _DRAFT,
    "title": LOCATION_FIX,
    "description": "Where the aircraft is, as map panels read it.",
    "type": "object",
    "properties": {
        "timestamp": _TIME,
        "frame_id": {"type": "string", "description": "Whose position it is: the flight's or the simulator's."},
        "latitude": {"type": "number", "description": "deg, north positive, WGS84"},
        "longitude": {"type": "number", "description": "deg, east positive, WGS84"},
        "altitude": {"type": "number", "description": "m above mean sea level"},
        "position_covariance": {
            "type": "array",
            "items": {"type": "number"},
            "minItems": 9,
            "maxItems": 9,
            "description": "m^2, east, north and up, row by row; zeros, for it is not known.",
        },
        "position_covariance_type": {
            "title": "foxglove.PositionCovarianceType",
            "description": "0: the covariance is not known.",
            "oneOf": [
                {"title": title, "const": number}
                for number, title in enumerate(("UNKNOWN", "APPROXIMATED", "DIAGONAL_KNOWN", "KNOWN"))
            ],
        },
    },
    "required": [
        "timestamp",
        "frame_id",
        "latitude",
        "longitude",
        "altitude",
        "position_covariance",
        "position_covariance_type",
    ],
}


def schema_of(topic: str, columns: pa.Schema) -> Schema:
    """The schema of a topic's messages; `columns` are those of its table."""
    message = _MESSAGES.get(topic)
    if message is not None:
        properties = {value.name: _value(value) for value in message.values}
        described = {"description": message.doc}
    else:
        rows = _row_docs()
        properties = {one.name: _column(one, rows.get(one.name, "")) for one in columns if one.name != "t_ns"}
        about = (columns.metadata or {}).get(DESCRIPTION)
        described = {} if about is None else {"description": about.decode()}
    return {"$schema": _DRAFT, "title": f"epf.{topic}", **described, "type": "object", "properties": properties}


def _value(value: Value) -> Schema:
    found: Schema = {"type": _TYPES[value.kind], "description": _description(value.doc, value.unit, value.sign)}
    if value.names:
        meanings = ", ".join(f"{number} {name}" for name, number in value.names.items())
        found["description"] += f" Values: {meanings}."
    if value.kind in ("number", "integer"):
        limits = {"minimum": value.minimum, "maximum": value.maximum}
        found |= {name: limit for name, limit in limits.items() if limit is not None}
    return found


def _column(column: pa.Field, doc: str) -> Schema:
    unit = (column.metadata or {}).get(b"unit", b"1").decode()
    return {"type": _type(column.type), "description": _description(doc, unit)}


def _type(kind: pa.DataType) -> str:
    if pa.types.is_boolean(kind):
        return "boolean"
    if pa.types.is_integer(kind):
        return "integer"
    return "number" if pa.types.is_floating(kind) else "string"


def _description(doc: str, unit: str, sign: str = "none") -> str:
    parts = [doc, "" if unit == "1" else f"Unit: {unit}.", "" if sign == "none" else f"Positive: {sign}."]
    return " ".join(part for part in parts if part)


def _row_docs() -> dict[str, str]:
    """The doc of each of the simulator's values, by the name that it has here."""
    return {in_our_unit(value)[0]: value.doc for row in XPLANE_ROWS["xp10"].values() for value in row.values}
