"""The gains that a board describes itself: the table of their definitions, and their values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final, Literal

from epf_gcs.contract.answers import GainState, GainStateName
from epf_gcs.contract.base import Shape

MOST_ROWS: Final = 512
"""Far more than any board has: a damaged count does not make the station ask for hours."""
OwnGainType = Literal["f32", "i32", "u32", "flag", "enum"]
OwnTableState = Literal["none", "unknown", "reading", "known"]
"""none: the board does not describe itself; unknown: it does, and its table was not read yet."""
RowFault = Literal[
    "lost",  # the board did not send it
    "too_many",  # this row and all after it
    "kind",  # no gain
    "type",
    "name",  # no name in snake_case
    "name_taken",  # by an earlier row, or by a built-in gain
    "group",
    "text",  # unit or help that cannot be printed
    "range",  # a minimum above the maximum, or no number
    "step",
    "default",  # outside of its range
    "choices",  # of an enum: fewer or more texts than its range has values, an empty one, or one twice
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
    """The board's table. Until it is known `gains` are those of the board that was heard last, if any.

    `rows_read` of `row_count` have come while it is being read.
    """

    state: OwnTableState = "none"
    rows_read: int = 0
    row_count: int = 0
    gains: tuple[OwnGainDefinition, ...] = ()
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
