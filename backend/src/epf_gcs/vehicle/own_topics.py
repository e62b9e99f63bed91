"""The rows with which a board describes its own topics: which can be used, and how their frames are read."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from math import isfinite, nan
from struct import Struct
from typing import Final

from epf_gcs.codec.description import FieldRow, Row, TopicRow, UnreadableRow
from epf_gcs.codec.tables import Encoding, Kind, Message, Value
from epf_gcs.contract.own_gains import MOST_ROWS, LeftOutRow, OwnGainTable, RowFault
from epf_gcs.contract.own_topics import OWN_TYPE_WORDS, OwnFieldDefinition, OwnFieldType, OwnTopicDefinition
from epf_gcs.recordings.log_table import T_NS
from epf_gcs.recordings.table_names import is_reserved
from epf_gcs.vehicle.own_gains import GAIN_TYPES, are_choices, choices_of, is_name

_TYPES: Final[Mapping[int, OwnFieldType]] = {**GAIN_TYPES, 6: "f64", 7: "i16", 8: "u16", 9: "i8", 10: "u8"}
_LETTERS: Final[dict[OwnFieldType, str]] = {
    "f32": "f",
    "i32": "i",
    "u32": "I",
    "flag": "B",
    "enum": "B",
    "f64": "d",
    "i16": "h",
    "u16": "H",
    "i8": "b",
    "u8": "B",
}
_WORD: Final = 4
MOST_BYTES: Final = 128
"""Of a topic's payload: no longer than a block of the table, so that a false header holds nothing back for longer."""
_MOST_CHOICES: Final = 256


def usable_topics(
    rows: Sequence[Row], *, is_whole: bool = True
) -> tuple[tuple[OwnTopicDefinition, ...], tuple[LeftOutRow, ...]]:
    """The topics out of all rows, and those of topics and fields that cannot be used.

    A field that cannot be used takes its topic with it, for nobody knows where the fields behind it lie; so does the
    end of a table that is not `is_whole`.
    """
    topics: list[OwnTopicDefinition] = []
    left_out: list[LeftOutRow] = []
    at = 0
    while at < len(rows):
        head = rows[at]
        if not isinstance(head, TopicRow):
            if isinstance(head, FieldRow):
                left_out.append(LeftOutRow(head.row, head.name, "topic"))
            at += 1
            continue
        end = at + 1
        while end < len(rows) and isinstance(rows[end], FieldRow | UnreadableRow):
            end += 1
        fields, faults = _fields(rows[at + 1 : end])
        is_known = not faults and not any(map(_may_be_field, rows[at + 1 : end])) and (is_whole or end < len(rows))
        topic = OwnTopicDefinition(
            head.row, head.type_word, head.name, head.period_ms, head.help, fields if is_known else ()
        )
        fault = _topic_fault(topic, topics)
        if fault is None:
            topics.append(topic)
        else:
            left_out.append(LeftOutRow(head.row, head.name, fault))
        left_out += faults
        at = end
    return tuple(topics), tuple(left_out)


def known_topics(table: OwnGainTable) -> tuple[OwnTopicDefinition, ...]:
    """The topics that the board has now, for sure: none while its table is not known.

    The table may be of a stranger's recording: what no board could have is not among them.
    """
    topics: list[OwnTopicDefinition] = []
    for topic in table.topics[:MOST_ROWS] if table.state == "known" else ():
        if _topic_fault(topic, topics) is None:
            topics.append(topic)
    return tuple(topics)


@lru_cache(maxsize=8)  # what was made for a table stays what it is: frames are told apart by it
def own_messages(topics: tuple[OwnTopicDefinition, ...]) -> tuple[Message, ...]:
    """How the frames of these topics are read."""
    return tuple(_message(topic) for topic in topics)


def _topic_fault(topic: OwnTopicDefinition, others: Sequence[OwnTopicDefinition]) -> RowFault | None:
    names = [field.name for field in topic.fields]
    if not is_name(topic.name):
        return "name"
    if is_reserved(topic.name) or any(topic.name == other.name for other in others):
        return "name_taken"
    if topic.type_word not in OWN_TYPE_WORDS or any(topic.type_word == other.type_word for other in others):
        return "type_word"
    if topic.period_ms <= 0:
        return "period"
    if not names or len(set(names)) < len(names) or any(map(_field_fault, topic.fields)):
        return "fields"
    return "size" if _size(topic.fields) > MOST_BYTES else None


def _fields(rows: Sequence[Row]) -> tuple[tuple[OwnFieldDefinition, ...], list[LeftOutRow]]:
    fields: dict[str, OwnFieldDefinition] = {}
    faults: list[LeftOutRow] = []
    for row in rows:
        if not isinstance(row, FieldRow):
            continue
        kind = _TYPES.get(row.type)
        if kind is None:
            faults.append(LeftOutRow(row.row, row.name, "type"))
            continue
        field = OwnFieldDefinition(
            name=row.name,
            type=kind,
            unit=row.unit or "1",
            scale=row.scale,
            minimum=row.minimum,
            maximum=row.maximum,
            choices=choices_of(row.choices),
            sign=row.sign,
        )
        fault = "name_taken" if field.name in fields else _field_fault(field)
        if fault is None:
            fields[field.name] = field
        else:
            faults.append(LeftOutRow(row.row, row.name, fault))
    return tuple(fields.values()), faults


def _field_fault(field: OwnFieldDefinition) -> RowFault | None:
    if not are_choices(field.choices) or len(field.choices) > _MOST_CHOICES:
        return "choices"
    if bool(field.choices) != (field.type == "enum"):
        return "choices"
    is_scalable = field.type not in ("f32", "f64", "flag", "enum")
    if not isfinite(field.scale) or field.scale == 0.0 or (field.scale != 1.0 and not is_scalable):
        return "scale"
    if not (isfinite(field.minimum) and isfinite(field.maximum)) or field.minimum > field.maximum:
        return "range"
    if field.name == T_NS:  # the time of each row in a table of them
        return "name_taken"
    return None if is_name(field.name) else "name"


def _message(topic: OwnTopicDefinition) -> Message:
    return Message(
        id=topic.type_word,
        name=topic.name,
        doc=topic.doc,
        source="described by the board",
        extension=True,
        topic=True,
        struct=Struct(f"{_format(topic.fields)}{-_size(topic.fields) % _WORD}x"),
        values=tuple(_value(slot, field) for slot, field in enumerate(topic.fields)),
    )


def _format(fields: Sequence[OwnFieldDefinition]) -> str:
    return "<" + "".join(_LETTERS[field.type] for field in fields)


def _size(fields: Sequence[OwnFieldDefinition]) -> int:
    return Struct(_format(fields)).size


def _value(slot: int, field: OwnFieldDefinition) -> Value:
    is_float = field.type in ("f32", "f64")
    kind: Kind = "boolean" if field.type == "flag" else "number" if is_float or field.scale != 1.0 else "integer"
    encoding: Encoding = "flag" if field.type == "flag" else "scaled" if field.scale != 1.0 else "plain"
    return Value(
        field.name,
        kind,
        slot,
        encoding,
        field.sign,
        unit=field.unit,
        minimum=0.0 if field.choices else field.minimum,
        maximum=len(field.choices) - 1.0 if field.choices else field.maximum,
        sign=field.sign,
        absent=nan if is_float else None,
        names={choice: place for place, choice in enumerate(field.choices)},
        scale=field.scale,
    )


def _may_be_field(row: Row) -> bool:
    return isinstance(row, UnreadableRow) and row.reason != "kind"
