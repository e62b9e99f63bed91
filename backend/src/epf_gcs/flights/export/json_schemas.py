"""JSON schemas of the topics, from the definition of the wire and of the simulator's rows.

A value that the board did not have is left out of the message rather than null: readers plot a number or nothing, and
some refuse a type that may be two.
"""

from __future__ import annotations

from typing import Final

import pyarrow as pa

from epf_gcs.codec.messages_gen import XPLANE_ROWS
from epf_gcs.codec.tables import Value
from epf_gcs.flights.convert import DESCRIPTION
from epf_gcs.flights.export.foxglove_schemas import DRAFT, Schema
from epf_gcs.flights.export.number_names import MESSAGES, SUFFIX, names_of
from epf_gcs.xplane.mapping import in_our_unit

_TYPES: Final = {"number": "number", "integer": "integer", "boolean": "boolean", "text": "string"}
# Tables that are of no message.
_TABLES: Final = {
    "damage": "What came on the line and was no whole frame.",
    "events": "What happened in the flight.",
    "link": "How busy the lines were, second by second.",
    "simulator": "The simulator's aircraft, of every datagram.",
    "xplane_info": "What the station told the board of the simulator's aircraft (command 50).",
}
_FIELDS: Final = {
    ("damage", "direction"): "Whether it was received or sent.",
    ("damage", "kind"): "What is wrong with it.",
    ("damage", "data"): "The bytes, hexadecimal.",
    ("events", "until_ns"): "When it ended, Unix ns; none for a moment, or while it lasts.",
    ("events", "kind"): "What kind of event it is.",
    ("events", "name"): "Which command, alarm, mode, plan or line it is of.",
    ("events", "id"): "A mark's own number.",
    ("events", "data"): "What else is known of it, as JSON.",
    ("xplane_info", "elevator"): "The stick's, nose up positive, from -1 to 1.",
    ("xplane_info", "aileron"): "The stick's, right wing down positive, from -1 to 1.",
    ("xplane_info", "rudder"): "The stick's, nose right positive, from -1 to 1.",
    ("xplane_info", "throttle"): "The lever's, from 0 to 1.",
    ("xplane_rows", "row"): "X-Plane's number of the row.",
    **{("xplane_rows", f"value_{place}"): f"Value {place} of the row; its meaning is the row's." for place in range(8)},
}


def schema_of(topic: str, columns: pa.Schema) -> Schema:
    """The schema of a topic's messages; `columns` are those of its table."""
    message = MESSAGES.get(topic)
    if message is not None:
        properties = {value.name: _value(value) for value in message.values} | {
            name + SUFFIX: {"type": "string", "description": f"What {name} stands for."} for name in names_of(topic)
        }
        described = {"description": message.doc}
    else:
        rows = _row_docs()
        properties = {
            one.name: _column(one, rows.get(one.name) or _FIELDS.get((topic, one.name), ""))
            for one in columns
            if one.name != "t_ns"
        }
        about = (columns.metadata or {}).get(DESCRIPTION)
        described = {"description": _TABLES.get(topic, "") if about is None else about.decode()}
    return {"$schema": DRAFT, "title": f"epf.{topic}", **described, "type": "object", "properties": properties}


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
