"""The rows with which a board describes its own topics: which can be used, and how their frames are read."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from math import isfinite, nan
from struct import Struct
from typing import Final, NoReturn

from epf_gcs.codec.description import FieldRow, Row, TopicRow, UnreadableRow
from epf_gcs.codec.tables import Encoding, Kind, Message, Value
from epf_gcs.codec.values import shortest
from epf_gcs.contract.own_gains import LeftOutRow, OwnGainTable, RowFault
from epf_gcs.contract.own_topics import OWN_TYPE_WORDS, OwnFieldDefinition, OwnFieldType, OwnTopicDefinition
from epf_gcs.recordings.table_names import is_reserved
from epf_gcs.vehicle.own_gains import SNAKE_CASE

_TYPES: Final[dict[int, OwnFieldType]] = {
    1: "f32",
    2: "i32",
    3: "u32",
    4: "flag",
    5: "enum",
    6: "f64",
    7: "i16",
    8: "u16",
    9: "i8",
    10: "u8",
}
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
_LONGEST_NAME: Final = 32
_MOST_CHOICES: Final = 256


class _FaultyRowError(ValueError):
    def __init__(self, reason: RowFault) -> None:
        super().__init__(reason)
        self.reason = reason


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
        try:
            topics.append(_topic(head, fields if is_known else (), topics))
        except _FaultyRowError as fault:
            left_out.append(LeftOutRow(head.row, head.name, fault.reason))
        left_out += faults
        at = end
    return tuple(topics), tuple(left_out)


def known_topics(table: OwnGainTable) -> tuple[OwnTopicDefinition, ...]:
    """The topics that the board has now, for sure: none while its table is not known."""
    return table.topics if table.state == "known" else ()


@lru_cache(maxsize=8)  # what was made for a table stays what it is: frames are told apart by it
def own_messages(topics: tuple[OwnTopicDefinition, ...]) -> tuple[Message, ...]:
    """How the frames of these topics are read."""
    return tuple(_message(topic) for topic in topics)


def _topic(
    head: TopicRow,
    fields: tuple[OwnFieldDefinition, ...],
    others: Sequence[OwnTopicDefinition],
) -> OwnTopicDefinition:
    name = _name(head.name)
    if is_reserved(name) or any(name == other.name for other in others):
        _refuse("name_taken")
    if head.type_word not in OWN_TYPE_WORDS or any(head.type_word == other.type_word for other in others):
        _refuse("type_word")
    if head.period_ms <= 0:
        _refuse("period")
    if not fields:
        _refuse("fields")
    if _size(fields) > MOST_BYTES:
        _refuse("size")
    return OwnTopicDefinition(head.row, head.type_word, name, head.period_ms, head.help, fields)


def _fields(rows: Sequence[Row]) -> tuple[tuple[OwnFieldDefinition, ...], list[LeftOutRow]]:
    fields: dict[str, OwnFieldDefinition] = {}
    faults: list[LeftOutRow] = []
    for row in rows:
        if not isinstance(row, FieldRow):
            continue
        try:
            if row.name in fields:
                _refuse("name_taken")
            fields[row.name] = _field(row)
        except _FaultyRowError as fault:
            faults.append(LeftOutRow(row.row, row.name, fault.reason))
    return tuple(fields.values()), faults


def _field(row: FieldRow) -> OwnFieldDefinition:
    kind = _TYPES.get(row.type)
    if kind is None:
        _refuse("type")
    choices = tuple(row.choices.split("|")) if row.choices else ()
    are_distinct = len(set(choices)) == len(choices) <= _MOST_CHOICES and "" not in choices
    if not are_distinct or bool(choices) != (kind == "enum"):
        _refuse("choices")
    is_scalable = kind not in ("f32", "f64", "flag", "enum")
    if not isfinite(row.scale) or row.scale == 0.0 or (row.scale != 1.0 and not is_scalable):
        _refuse("scale")
    if not (isfinite(row.minimum) and isfinite(row.maximum)) or row.minimum > row.maximum:
        _refuse("range")
    return OwnFieldDefinition(
        name=_name(row.name),
        type=kind,
        unit=row.unit or "1",
        scale=shortest(row.scale),
        minimum=shortest(row.minimum),
        maximum=shortest(row.maximum),
        choices=choices,
        sign=row.sign,
    )


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


def _name(text: str) -> str:
    if len(text) > _LONGEST_NAME or SNAKE_CASE.fullmatch(text) is None:
        _refuse("name")
    return text


def _refuse(reason: RowFault) -> NoReturn:
    raise _FaultyRowError(reason)
