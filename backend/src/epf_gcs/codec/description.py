"""The table in which a board describes its own gains and topics: bytes to rows and back.

A row is its length (u8, this byte included), its kind (u8) and what its kind says; see "Description" in the protocol.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from struct import Struct
from types import MappingProxyType
from typing import Final, Literal, TypeAlias

from epf_gcs.codec.messages_gen import COMMANDS, TELEMETRY_BY_NAME
from epf_gcs.codec.values import shortest

BLOCK_SIZE: Final = TELEMETRY_BY_NAME["description_block"].size - 4
"""Bytes of the table in one block: the payload without the block's number."""
BLOCKS_AT_ONCE: Final = int(next(one.maximum or 1 for one in COMMANDS["describe_blocks"].values if one.name == "count"))
"""The most blocks that one question asks for."""

UnreadableReason = Literal[
    "kind",  # a kind that is not known here
    "length",  # too short for its kind, or a length byte that cannot be
    "text",  # not printable ASCII, or without an end
]

_HEAD_SIZE: Final = 2
_LONGEST: Final = 255
_RESTART_FLAG: Final = 1


@dataclass(frozen=True, slots=True)
class GainRow:
    """One gain. `type` is the wire's number; limits, step and default are in `unit`, in their shortest decimal form."""

    row: int
    type: int
    needs_restart: bool
    minimum: float
    maximum: float
    step: float
    default: float
    name: str
    unit: str
    group: str
    choices: str
    help: str


@dataclass(frozen=True, slots=True)
class TopicRow:
    """One topic, sent as frames of `type_word` each `period_ms`. The field rows after it are its own."""

    row: int
    type_word: int
    period_ms: int
    name: str
    help: str


@dataclass(frozen=True, slots=True)
class FieldRow:
    """One value of the topic before it. The wire's number, of `type`, times `scale` is in `unit`."""

    row: int
    type: int
    scale: float
    minimum: float
    maximum: float
    name: str
    unit: str
    choices: str
    sign: str


@dataclass(frozen=True, slots=True)
class UnreadableRow:
    """A row that cannot be read; `name` is None where that cannot be read either."""

    row: int
    name: str | None
    reason: UnreadableReason


KnownRow: TypeAlias = GainRow | TopicRow | FieldRow
Row: TypeAlias = KnownRow | UnreadableRow


@dataclass(frozen=True, slots=True)
class _Layout:
    """What follows the head: numbers, and then `texts` texts, the name first."""

    numbers: Struct
    texts: int
    make: Callable[[int, tuple[float, ...], tuple[str, ...]], KnownRow]


def rows_of(table: bytes) -> list[Row]:
    """All rows in order, numbered from 0. Never raises: what cannot be read is an `UnreadableRow`.

    A length byte that cannot be leaves nobody knowing where the next row begins: the rest is one unreadable row.
    """
    rows: list[Row] = []
    start = 0
    while start < len(table):
        length = table[start]
        if length < _HEAD_SIZE or start + length > len(table):
            rows.append(UnreadableRow(len(rows), None, "length"))
            break
        rows.append(_row(len(rows), table[start + 1], table[start + _HEAD_SIZE : start + length]))
        start += length
    return rows


def packed_rows(rows: Iterable[KnownRow]) -> bytes:
    """The table of these rows; their own numbers are not part of it.

    Raises ValueError for a row that is too long. Texts are not judged, so that a stand-in board can break the rules:
    letters up to U+00FF become one byte each.
    """
    return b"".join(_packed(row) for row in rows)


def block_count(size: int) -> int:
    """The blocks of a table of `size` bytes."""
    return -(-size // BLOCK_SIZE)


def block_questions(size: int) -> list[tuple[int, int]]:
    """First block and number of blocks of each question that reads a table of `size` bytes."""
    count = block_count(size)
    return [(first, min(BLOCKS_AT_ONCE, count - first)) for first in range(0, count, BLOCKS_AT_ONCE)]


def blocks_of(table: bytes) -> list[bytes]:
    """The table in blocks of `BLOCK_SIZE` bytes, the last one filled up with zeros."""
    return [table[at : at + BLOCK_SIZE].ljust(BLOCK_SIZE, b"\0") for at in range(0, len(table), BLOCK_SIZE)]


def _row(row: int, kind: int, content: bytes) -> Row:
    layout = _LAYOUTS.get(kind)
    if layout is None:
        return UnreadableRow(row, None, "kind")
    texts, fault = _texts(content[layout.numbers.size :], layout.texts)
    if fault is None:
        return layout.make(row, layout.numbers.unpack_from(content), texts)
    return UnreadableRow(row, (texts[0] or None) if texts else None, fault)


def _texts(raw: bytes, count: int) -> tuple[tuple[str, ...], UnreadableReason | None]:
    """The first `count` texts, or those before the first fault. What follows them is skipped: rows may grow."""
    ended = raw.split(b"\0", count)
    texts: list[str] = []
    for one in ended[: min(count, len(ended) - 1)]:
        text = one.decode("latin-1")
        if not (text.isascii() and text.isprintable()):
            return tuple(texts), "text"
        texts.append(text)
    if len(texts) == count:
        return tuple(texts), None
    return tuple(texts), "text" if ended[-1] else "length"


def _packed(row: KnownRow) -> bytes:
    if isinstance(row, GainRow):
        flags = row.needs_restart * _RESTART_FLAG
        numbers = (row.type, flags, row.minimum, row.maximum, row.step, row.default)
        return _whole(1, numbers, (row.name, row.unit, row.group, row.choices, row.help))
    if isinstance(row, TopicRow):
        return _whole(2, (row.type_word, row.period_ms), (row.name, row.help))
    numbers_of_field = (row.type, row.scale, row.minimum, row.maximum)
    return _whole(3, numbers_of_field, (row.name, row.unit, row.choices, row.sign))


def _whole(kind: int, numbers: tuple[float, ...], texts: tuple[str, ...]) -> bytes:
    content = _LAYOUTS[kind].numbers.pack(*numbers) + b"".join(text.encode("latin-1") + b"\0" for text in texts)
    length = _HEAD_SIZE + len(content)
    if length > _LONGEST:
        raise ValueError(f"the row {texts[0]} is too long")
    return bytes((length, kind)) + content


def _gain(row: int, numbers: tuple[float, ...], texts: tuple[str, ...]) -> GainRow:
    kind, flags, minimum, maximum, step, default = map(shortest, numbers)
    needs_restart = bool(int(flags) & _RESTART_FLAG)
    return GainRow(row, int(kind), needs_restart, minimum, maximum, step, default, *texts)


def _topic(row: int, numbers: tuple[float, ...], texts: tuple[str, ...]) -> TopicRow:
    type_word, period_ms = numbers
    return TopicRow(row, int(type_word), int(period_ms), *texts)


def _field(row: int, numbers: tuple[float, ...], texts: tuple[str, ...]) -> FieldRow:
    kind, scale, minimum, maximum = map(shortest, numbers)
    return FieldRow(row, int(kind), scale, minimum, maximum, *texts)


_LAYOUTS: Final[Mapping[int, _Layout]] = MappingProxyType(
    {
        1: _Layout(Struct("<BBffff"), 5, _gain),
        2: _Layout(Struct("<HH"), 2, _topic),
        3: _Layout(Struct("<Bfff"), 4, _field),
    }
)
