"""The rows with which a board describes its own gains: which can be used, and what their values may be."""

from __future__ import annotations

import re
from collections.abc import Container, Iterable, Sequence
from typing import Final, cast

from epf_gcs.codec.frame import Frame
from epf_gcs.codec.messages_gen import TELEMETRY_BY_NAME
from epf_gcs.codec.values import Json, meaning, shortest, single
from epf_gcs.contract.own_gains import (
    LeftOutRow,
    OwnGainDefinition,
    OwnGainState,
    OwnGainType,
    RowFault,
)
from epf_gcs.vehicle import limits
from epf_gcs.vehicle.parameters import BY_NAME, state_after_read

_ROW: Final = TELEMETRY_BY_NAME["description_row"]
SNAKE_CASE: Final = re.compile(r"[a-z][a-z0-9]*(_[a-z0-9]+)*")
_KIND_GAIN: Final = 1
_TYPES: Final = cast(
    dict[int, OwnGainType],
    {number: name for value in _ROW.values if value.name == "type" for name, number in value.names.items()},
)


class _FaultyRowError(ValueError):
    def __init__(self, reason: RowFault) -> None:
        super().__init__(reason)
        self.reason = reason


def usable_rows(rows: Sequence[bytes | None]) -> tuple[tuple[OwnGainDefinition, ...], tuple[LeftOutRow, ...]]:
    """The gains out of the payloads of all rows (None: lost), and the rows that cannot be used."""
    gains: dict[str, OwnGainDefinition] = {}
    left_out: list[LeftOutRow] = []
    for number, payload in enumerate(rows):
        values = {} if payload is None else meaning(Frame(_ROW, payload)).values
        try:
            if payload is None:
                raise _FaultyRowError("lost")
            gain = _gain(number, values, taken=gains)
        except _FaultyRowError as fault:
            name = values.get("name")
            left_out.append(LeftOutRow(number, name if isinstance(name, str) and name else None, fault.reason))
        else:
            gains[gain.name] = gain
    return tuple(gains.values()), tuple(left_out)


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


def unknown_values(gains: Iterable[OwnGainDefinition]) -> dict[str, OwnGainState]:
    """A state for each gain; nothing is known."""
    return {gain.name: OwnGainState() for gain in gains}


def _gain(number: int, values: dict[str, Json], *, taken: Container[str]) -> OwnGainDefinition:
    if values["kind"] != _KIND_GAIN:
        raise _FaultyRowError("kind")
    kind = values["type"]
    if not isinstance(kind, int) or kind not in _TYPES:
        raise _FaultyRowError("type")
    name = _in_snake_case(values["name"], "name")
    if name in taken or name in BY_NAME:
        raise _FaultyRowError("name_taken")
    gain = OwnGainDefinition(
        row=number,
        name=name,
        group=_in_snake_case(values["group"], "group"),
        type=_TYPES[kind],
        unit=_text(values["unit"]),
        minimum=_number(values["minimum"], "range"),
        maximum=_number(values["maximum"], "range"),
        step=_number(values["step"], "step"),
        default=_number(values["default_value"], "default"),
        choices=_choices(_text(values["choices"])),
        needs_restart=values["needs_restart"] == 1,
        doc=_text(values["help"]),
    )
    fault = _range_fault(gain)
    if fault is not None:
        raise _FaultyRowError(fault)
    return gain


def _range_fault(gain: OwnGainDefinition) -> RowFault | None:
    if gain.minimum > gain.maximum:
        return "range"
    if gain.type == "enum":
        are_distinct = len(set(gain.choices)) == len(gain.choices) and "" not in gain.choices
        if not are_distinct or (gain.minimum, gain.maximum) != (0.0, len(gain.choices) - 1.0):
            return "choices"
    elif gain.step <= 0.0:
        return "step"
    return None if value_fault(gain, gain.default) is None else "default"


def _in_snake_case(value: Json, reason: RowFault) -> str:
    if not isinstance(value, str) or SNAKE_CASE.fullmatch(value) is None:
        raise _FaultyRowError(reason)
    return value


def _number(value: Json, reason: RowFault) -> float:
    if not isinstance(value, int | float):
        raise _FaultyRowError(reason)
    return shortest(float(value))


def _text(value: Json) -> str:
    if not isinstance(value, str):
        raise _FaultyRowError("text")
    return value


def _choices(text: str) -> tuple[str, ...]:
    return tuple(text.split("|")) if text else ()
