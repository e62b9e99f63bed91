"""The unit and kind of every field of a topic, from the definition of the wire and of the simulator's rows."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Final, Literal, NamedTuple

import pyarrow as pa
import pyarrow.parquet as pq

from epf_gcs.codec.messages_gen import TELEMETRY_BY_NAME, XPLANE_ROWS
from epf_gcs.flights.convert import OWN, T_NS
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


def fields_of_table(table: pa.Schema) -> dict[str, FieldMeaning]:
    """The fields of an own or a log's topic by name, read from its table's schema; empty for any other table."""
    if OWN not in (table.metadata or {}):
        return {}
    return {
        one.name: FieldMeaning(
            (one.metadata or {}).get(b"unit", b"1").decode(), "flag" if pa.types.is_boolean(one.type) else "number"
        )
        for one in table
        if one.name != T_NS.name
    }


def fields_of_file(table: Path) -> dict[str, FieldMeaning]:
    """The same from a Parquet file; empty where the file does not exist. Raises OSError."""
    return fields_of_table(pq.read_schema(table)) if table.exists() else {}


def _row_unit(unit: str) -> str:
    return "rad/s" if unit == "deg/s" else unit


def _kind(kind: str) -> Kind:
    if kind == "text":
        return "text"
    return "flag" if kind == "boolean" else "number"
