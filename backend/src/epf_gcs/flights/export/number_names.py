"""Names of the numbers that stand for something, as commands and results do: a column of text behind each of them."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Final

import pyarrow as pa
import pyarrow.compute as pc

from epf_gcs.codec.messages_gen import COMMANDS_BY_ID, TELEMETRY
from epf_gcs.codec.tables import Message
from epf_gcs.recordings.table_names import SENT

SUFFIX: Final = "_text"
MESSAGES: Final[Mapping[str, Message]] = {message.name: message for message in TELEMETRY.values()} | {
    SENT + message.name: message for message in COMMANDS_BY_ID.values()
}
"""The message of each topic that has one."""
_COMMAND: Final = "command_type"


@cache
def names_of(topic: str) -> Mapping[str, Mapping[int, str]]:
    """The names by number of each field of a topic that has any."""
    message = MESSAGES.get(topic)
    values = () if message is None else message.values
    found = {value.name: {number: name for name, number in value.names.items()} for value in values if value.names}
    if any(value.name == _COMMAND for value in values):
        found[_COMMAND] = {number: command.name for number, command in COMMANDS_BY_ID.items()}
    return found


def named_schema(topic: str, schema: pa.Schema) -> pa.Schema:
    """The columns with those of names."""
    fields = [
        field
        for column in schema
        for field in (
            column,
            *([pa.field(column.name + SUFFIX, pa.string())] if column.name in names_of(topic) else ()),
        )
    ]
    return pa.schema(fields, metadata=schema.metadata)


def named_rows(topic: str, batch: pa.RecordBatch) -> pa.RecordBatch:
    """The rows with the names of their numbers; a number without a name has none."""
    names = names_of(topic)
    if not names:
        return batch
    columns = []
    for field, column in zip(batch.schema, batch.columns, strict=True):
        columns.append(column)
        if field.name in names:
            known = names[field.name]
            places = pc.index_in(column, value_set=pa.array(list(known), column.type))
            columns.append(pa.array(list(known.values()), pa.string()).take(places))
    return pa.record_batch(columns, schema=named_schema(topic, batch.schema))
