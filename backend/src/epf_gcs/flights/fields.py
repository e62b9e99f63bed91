"""The unit and kind of every field of a topic, from the definition of the wire and of the simulator's rows."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Final, Literal, NamedTuple

import pyarrow.parquet as pq

from epf_gcs.codec.messages_gen import TELEMETRY_BY_NAME, XPLANE_ROWS
from epf_gcs.flights.convert import LOG, T_NS
from epf_gcs.xplane.mapping import INFO_SOURCES, in_our_unit

Kind = Literal["number", "flag", "text"]
_PROFILE: Final = "xp10"


class FieldMeaning(NamedTuple):
    """`unit` is "1" for a quantity without unit."""

    unit: str
    kind: Kind


@cache
def fields_of(topic: str) -> dict[str, FieldMeaning]:
    """The fields of a topic by name; empty for a topic that is not defined."""
    if topic in ("simulator", "xplane_info"):
        rows = XPLANE_ROWS[_PROFILE].values()
        found = {in_our_unit(value)[0]: _row_unit(value.unit) for row in rows for value in row.values}
        named = {f"{row.id}.{in_our_unit(value)[0]}": _row_unit(value.unit) for row in rows for value in row.values}
        if topic == "simulator":
            return {name: FieldMeaning(unit, "number") for name, unit in found.items()}
        return {name: FieldMeaning(named[f"{row}.{source}"], "number") for name, (row, source) in INFO_SOURCES.items()}
    message = TELEMETRY_BY_NAME.get(topic)
    if message is None or not message.topic:
        return {}
    return {value.name: FieldMeaning(value.unit, _kind(value.kind)) for value in message.values}


def log_fields(table: Path) -> dict[str, FieldMeaning]:
    """The fields of a topic that came in a log of another program, as its Parquet file has them; empty for a table that
    is none. Raises OSError."""
    if not table.exists():
        return {}
    schema = pq.read_schema(table)
    if LOG not in (schema.metadata or {}):
        return {}
    named = [(one.name, (one.metadata or {}).get(b"unit", b"1").decode()) for one in schema if one.name != T_NS.name]
    return {name: FieldMeaning(unit, "number") for name, unit in named}


def _row_unit(unit: str) -> str:
    return "rad/s" if unit == "deg/s" else unit


def _kind(kind: str) -> Kind:
    if kind == "text":
        return "text"
    return "flag" if kind == "boolean" else "number"
