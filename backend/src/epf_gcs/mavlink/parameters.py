"""MAVLink's parameter protocol over the board's gains: what is answered was read back from the board."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final, Protocol

from epf_gcs.client import StationError
from epf_gcs.contract.answers import ParameterState
from epf_gcs.mavlink.dialect import MAKE, WIRE, Message

_REAL: Final = WIRE.MAV_PARAM_TYPE_REAL32
# MAVLink carries a gain in single precision; two values that it cannot tell apart are one.
_SAME: Final = 1e-6
_NO_INDEX: Final = -1


class Gains(Protocol):
    """What is needed of a station."""

    async def gains(self) -> Mapping[str, ParameterState]:
        """All gains as far as they are known."""

    async def load_gains(self) -> Mapping[str, ParameterState]:
        """All gains, read from the board."""

    async def set_gains(self, changes: Mapping[str, float]) -> Mapping[str, ParameterState]:
        """Write and read back."""


class Parameters:
    """Answers PARAM_REQUEST_LIST, PARAM_REQUEST_READ and PARAM_SET. Raises StationError where the station refuses."""

    def __init__(self, station: Gains) -> None:
        self._station = station

    async def every(self) -> list[Message]:
        """All gains."""
        gains = await self._known()
        return [_value(gains, name) for name in gains]

    async def one(self, asked: Message) -> list[Message]:
        """The gain that was asked for, by its name or by its number; nothing for one that there is not."""
        gains = await self._known()
        names = list(gains)
        index = asked.param_index
        if index != _NO_INDEX:
            return [_value(gains, names[index])] if 0 <= index < len(names) else []
        return [_value(gains, asked.param_id)] if asked.param_id in gains else []

    async def set(self, asked: Message) -> tuple[list[Message], str]:
        """Write a gain: the answer with the board's value, and a sentence for people where that is not what was asked.

        One that has the value already is not written again: a station that lost the answer asks a second time.
        """
        name = asked.param_id
        gains = await self._known()
        if name not in gains:
            return [], f"This board has no gain {name}."
        if asked.param_type != _REAL:
            return [_value(gains, name)], f"{name} is a REAL32."
        known = gains[name]
        value = round(asked.param_value) if known.is_integer else _short(asked.param_value)
        if known.value is not None and abs(known.value - value) <= _SAME * max(1.0, abs(value)):
            return [_value(gains, name)], ""
        try:
            gains = await self._station.set_gains({name: value})
        except StationError as refusal:
            return [_value(gains, name)], refusal.detail
        if gains[name].state == "confirmed":
            return [_value(gains, name)], ""
        return [_value(gains, name)], f"The board did not take {value:g} for {name}."

    async def _known(self) -> Mapping[str, ParameterState]:
        """The gains with values that the board has told; read from it the first time."""
        gains = await self._station.gains()
        if any(one.value is None for one in gains.values()):
            gains = await self._station.load_gains()
        return {name: one for name, one in gains.items() if one.value is not None}


def _value(gains: Mapping[str, ParameterState], name: str) -> Message:
    return MAKE.param_value_encode(name.encode(), gains[name].value, _REAL, len(gains), list(gains).index(name))


def _short(value: float) -> float:
    """The shortest number that single precision cannot tell from this one: 2.4, and not 2.4000000953674316."""
    return float(f"{value:.7g}")
