"""The rows with which a board describes its own gains: which can be used, and what their values may be."""

from __future__ import annotations

import math
import re
from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import Final

from epf_gcs.codec.description import GainRow, Row, UnreadableRow
from epf_gcs.codec.values import Json, shortest, single
from epf_gcs.contract.events import OwnGainsEvent
from epf_gcs.contract.own_gains import (
    MOST_ROWS,
    LeftOutRow,
    OwnGainDefinition,
    OwnGains,
    OwnGainState,
    OwnGainType,
    RowFault,
)
from epf_gcs.vehicle import limits
from epf_gcs.vehicle.parameters import BY_NAME, state_after_read

_SNAKE_CASE: Final = re.compile(r"[a-z][a-z0-9]*(_[a-z0-9]+)*")
_LONGEST_NAME: Final = 32
GAIN_TYPES: Final[Mapping[int, OwnGainType]] = MappingProxyType({1: "f32", 2: "i32", 3: "u32", 4: "flag", 5: "enum"})


class _FaultyRowError(ValueError):
    def __init__(self, reason: RowFault) -> None:
        super().__init__(reason)
        self.reason = reason


def usable_rows(
    rows: Sequence[Row], *, is_whole: bool = True
) -> tuple[tuple[OwnGainDefinition, ...], tuple[LeftOutRow, ...]]:
    """The gains among a table's rows, and the rows that cannot be used; topics and their fields are neither.

    Of a table that is not `is_whole`, the row in which it ends and all after it are lost.
    """
    gains: dict[str, OwnGainDefinition] = {}
    left_out: list[LeftOutRow] = []
    for row in rows[:MOST_ROWS]:
        if isinstance(row, UnreadableRow):
            left_out.append(LeftOutRow(row.row, row.name, row.reason))
        elif isinstance(row, GainRow):
            try:
                gain = _gain(row, taken=gains)
            except _FaultyRowError as fault:
                left_out.append(LeftOutRow(row.row, row.name or None, fault.reason))
            else:
                gains[gain.name] = gain
    if not is_whole:
        is_cut = bool(rows) and isinstance(rows[-1], UnreadableRow) and rows[-1].reason == "length"
        lost = len(rows) - is_cut
        left_out = [one for one in left_out if one.row < lost] + [LeftOutRow(lost, None, "lost")]
    if len(rows) > MOST_ROWS:
        left_out.append(LeftOutRow(MOST_ROWS, None, "too_many"))
    return tuple(gains.values()), tuple(left_out)


def is_name(text: str) -> bool:
    """Whether a gain, a topic or a field may be called this."""
    return len(text) <= _LONGEST_NAME and _SNAKE_CASE.fullmatch(text) is not None


def choices_of(text: str) -> tuple[str, ...]:
    """The texts of an enum's values, which stand in its row with a bar between them."""
    return tuple(text.split("|")) if text else ()


def are_choices(choices: Sequence[str]) -> bool:
    """Whether each has a text, and no two the same."""
    return len(set(choices)) == len(choices) and "" not in choices


def value_fault(gain: OwnGainDefinition, value: float) -> str | None:
    """Why this value is not allowed, in one sentence; None if it is allowed."""
    return limits.value_fault(gain.name, value, gain.minimum, gain.maximum, is_integer=gain.is_integer)


def as_held(value: float) -> float:
    """What the board holds after it took `value` (rounded to single precision), in the shortest decimal form."""
    return shortest(single(value))


def after_read(held: OwnGainState, value: Json, now_s: float) -> OwnGainState:
    """A gain after the board sent its value, null for no number. A pending one stays pending until its own end."""
    if not isinstance(value, int | float):
        return OwnGainState(loaded=held.loaded)
    found = shortest(float(value))
    return OwnGainState(found, state_after_read(held, found), found if held.loaded is None else held.loaded, now_s)


def own_gains_after(known: OwnGains | None, event: OwnGainsEvent) -> OwnGains:
    """What is known of the board's own gains after this event: with a table come all of its values."""
    if event.table is not None:
        return OwnGains(event.table, event.values)
    held = OwnGains() if known is None else known
    return replace(held, values={**held.values, **event.values})


def unknown_values(gains: Iterable[OwnGainDefinition]) -> dict[str, OwnGainState]:
    """A state for each gain; nothing is known."""
    return {gain.name: OwnGainState() for gain in gains}


def _gain(row: GainRow, *, taken: Container[str]) -> OwnGainDefinition:
    if row.type not in GAIN_TYPES:
        raise _FaultyRowError("type")
    if not is_name(row.name):
        raise _FaultyRowError("name")
    if row.name in taken or row.name in BY_NAME:
        raise _FaultyRowError("name_taken")
    if _SNAKE_CASE.fullmatch(row.group) is None:
        raise _FaultyRowError("group")
    gain = OwnGainDefinition(
        row=row.row,
        name=row.name,
        group=row.group,
        type=GAIN_TYPES[row.type],
        unit=row.unit,
        minimum=_number(row.minimum, "range"),
        maximum=_number(row.maximum, "range"),
        step=_number(row.step, "step"),
        default=_number(row.default, "default"),
        choices=choices_of(row.choices),
        needs_restart=row.needs_restart,
        doc=row.help,
    )
    fault = _range_fault(gain)
    if fault is not None:
        raise _FaultyRowError(fault)
    return gain


def _range_fault(gain: OwnGainDefinition) -> RowFault | None:
    if gain.minimum > gain.maximum:
        return "range"
    if gain.type == "enum":
        if not are_choices(gain.choices) or (gain.minimum, gain.maximum) != (0.0, len(gain.choices) - 1.0):
            return "choices"
    elif gain.step <= 0.0:
        return "step"
    return None if value_fault(gain, gain.default) is None else "default"


def _number(value: float, reason: RowFault) -> float:
    if not math.isfinite(value):
        raise _FaultyRowError(reason)
    return value
