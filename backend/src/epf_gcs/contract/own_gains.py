"""The gains that a board describes itself: the table of their definitions, and their values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final, Literal

from epf_gcs.contract.answers import GainState, GainStateName
from epf_gcs.contract.base import Shape
from epf_gcs.contract.own_topics import OwnTopicDefinition

MOST_ROWS: Final = 1024
"""Far more than any board has: the pages are not told of thousands of faulty ones."""
OwnGainType = Literal["f32", "i32", "u32", "flag", "enum"]
OwnTableState = Literal["none", "unknown", "reading", "known"]
"""none: the board does not describe itself; unknown: it does, and its table was not read yet."""
RowFault = Literal[
    "lost",  # the board did not send it; this row and all after it
    "too_many",  # this row and all after it
    "kind",  # one that is not known
    "length",  # too short for its kind, or a length that cannot be: this row and all after it
    "type",
    "name",  # no name in snake_case
    "name_taken",  # by an earlier row, or by a built-in gain
    "group",
    "text",  # one that cannot be printed, or has no end
    "range",  # a minimum above the maximum, or no number
    "step",
    "default",  # outside of its range
    "choices",  # of an enum: fewer or more texts than its range has values, an empty one, or one twice
    "topic",  # a field before any topic
    "type_word",  # of a topic: not from 0x1000, or another topic's
    "period",
    "scale",  # zero, or of a number that has none
    "fields",  # of a topic: none, or one that cannot be used
    "checksum",  # of a topic: the table may have come otherwise than the board has it
    "size",  # of a topic: more than a frame holds
]


@dataclass(frozen=True, slots=True)
class OwnGainDefinition(Shape):
    """One row of a board's table. Limits, step and default are in `unit`; of an enum, places of `choices` from 0."""

    row: int
    name: str
    group: str
    type: OwnGainType
    unit: str
    minimum: float
    maximum: float
    step: float
    default: float
    choices: tuple[str, ...]
    needs_restart: bool
    doc: str

    @property
    def is_integer(self) -> bool:
        """Only whole numbers are allowed."""
        return self.type != "f32"


@dataclass(frozen=True, slots=True)
class LeftOutRow(Shape):
    """A row that breaks a rule and cannot be used; `name` is null where it has none that can be read."""

    row: int
    name: str | None
    reason: RowFault


@dataclass(frozen=True, slots=True)
class OwnGainTable(Shape):
    """The board's table. Until it is known `gains` and `topics` are those of the board that was heard last, if any.

    `blocks_read` of `block_count` have come while it is being read.
    """

    state: OwnTableState = "none"
    blocks_read: int = 0
    block_count: int = 0
    gains: tuple[OwnGainDefinition, ...] = ()
    topics: tuple[OwnTopicDefinition, ...] = ()
    left_out: tuple[LeftOutRow, ...] = ()


@dataclass(frozen=True, slots=True)
class OwnGainState(Shape):
    """A value as far as it is known: the board's, when it was heard (Unix seconds), and what it was when all were
    last loaded."""

    value: float | None = None
    state: GainStateName = "unknown"
    loaded: float | None = None
    heard_s: float | None = None


@dataclass(frozen=True, slots=True)
class OwnGains(Shape):
    """The table, and the values by name: one for each of its gains."""

    table: OwnGainTable = OwnGainTable()
    values: Mapping[str, OwnGainState] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class AllGains(Shape):
    """All gains as far as they are known: the built-in ones by name, and the board's own."""

    built_in: Mapping[str, GainState]
    own: OwnGains
