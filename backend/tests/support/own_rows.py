"""Tables of boards that describe topics of their own, and frames of these."""

from __future__ import annotations

from typing import Any

import orjson

from epf_gcs.codec.description import FieldRow, KnownRow, TopicRow
from epf_gcs.codec.encode import frame_bytes
from epf_gcs.codec.frame import FROM_BOARD
from epf_gcs.contract.events import OwnGainsEvent
from epf_gcs.contract.own_gains import OwnGainTable
from epf_gcs.contract.own_topics import OwnTopicDefinition
from epf_gcs.vehicle.own_topics import own_messages

U8, I16, F32, FLAG, ENUM = 10, 7, 1, 4, 5


def topic_row(row: int = 0, *, name: str = "filter", type_word: int = 0x1000, period_ms: int = 50) -> TopicRow:
    """The head of a topic."""
    return TopicRow(row, type_word, period_ms, name, "What the filter found.")


def field_row(
    row: int,
    name: str,
    kind: int = F32,
    *,
    scale: float = 1.0,
    minimum: float = -1.0,
    maximum: float = 1.0,
    unit: str = "rad/s",
    choices: str = "",
) -> FieldRow:
    """One of its fields."""
    return FieldRow(row, kind, scale, minimum, maximum, name, unit, choices, "right wing down")


def filter_rows() -> list[KnownRow]:
    """A topic with a field of each sort."""
    return [
        topic_row(),
        field_row(1, "bias_x_rad_s"),
        field_row(2, "temperature_c", I16, scale=0.01, minimum=-40.0, maximum=85.0, unit="degC"),
        field_row(3, "is_settled", FLAG, minimum=0.0, unit="1"),
        field_row(4, "mode", ENUM, minimum=0.0, maximum=2.0, unit="1", choices="idle|slow|fast"),
    ]


def own_frame(topics: tuple[OwnTopicDefinition, ...], *values: float, of: int = 0) -> bytes:
    """A frame of one of these topics as the board sends it; values are the wire's."""
    message = own_messages(topics)[of]
    return frame_bytes(FROM_BOARD, message, message.struct.pack(*values))


def table_note(topics: tuple[OwnTopicDefinition, ...], *, is_known: bool = True) -> dict[str, Any]:
    """What a recording notes of a board's table."""
    table = OwnGainTable("known" if is_known else "unknown", topics=topics)
    content: dict[str, Any] = orjson.loads(orjson.dumps({"event": "own_gains", "data": OwnGainsEvent(table, {})}))
    return content
