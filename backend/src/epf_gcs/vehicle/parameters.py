"""The 17 gains: what the board has, what was asked for, and what is allowed."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Final

from epf_gcs.codec.messages_gen import PARAMETERS
from epf_gcs.codec.tables import Parameter
from epf_gcs.codec.values import Json, shortest, single
from epf_gcs.contract.answers import GainState, GainStateName
from epf_gcs.contract.own_gains import OwnGainState
from epf_gcs.vehicle.limits import value_fault

BY_NAME: Final[Mapping[str, Parameter]] = {parameter.name: parameter for parameter in PARAMETERS}


@dataclass(frozen=True, slots=True)
class GainRecord:
    """One gain as far as it is known. `value` is the board's, None until it was read.

    `loaded` is the board's value when it was first read, or when the operator last loaded all gains; the page shows
    changes against it.
    """

    value: float | None = None
    state: GainStateName = "unknown"
    loaded: float | None = None


Held17 = Mapping[str, GainRecord]
UNKNOWN: Final[Held17] = dict.fromkeys(BY_NAME, GainRecord())


def after_read(held: Held17, values: Mapping[str, Json]) -> Held17:
    """The gains after the board sent its values. A pending gain stays pending until its own confirmation."""
    return {name: _after_read(held[name], values.get(name)) for name in BY_NAME}


def state_after_read(held: GainRecord | OwnGainState, found: float) -> GainStateName:
    """A pending gain stays so until its end, a confirmed one while the board has that value; any other is loaded."""
    keeps = held.state == "pending" or (held.state == "confirmed" and held.value == found)
    return held.state if keeps else "loaded"


def loaded_now(held: Held17) -> Held17:
    """The gains after the operator loaded all of them: changes are counted from the present values."""
    return {name: replace(one, loaded=one.value) for name, one in held.items()}


def forgotten(held: Held17, names: Iterable[str]) -> Held17:
    """The gains with the values of `names` unknown again."""
    gone = frozenset(names)
    return {name: replace(one, value=None, state="unknown") if name in gone else one for name, one in held.items()}


def with_state(held: Held17, names: Mapping[str, object], state: GainStateName) -> Held17:
    """The same values, with this state for `names`."""
    return {name: replace(one, state=state) if name in names else one for name, one in held.items()}


def differing(wanted: Mapping[str, float], values: Mapping[str, Json]) -> list[str]:
    """Names whose value on the board differs from the requested one, compared in single precision."""
    return [name for name, value in wanted.items() if not _same(BY_NAME[name], value, values.get(name))]


def as_held(name: str, value: float) -> float:
    """What the board holds after it took `value` (rounded to single precision), in the shortest decimal form."""
    return value if BY_NAME[name].is_integer else shortest(single(value))


def gain_state(name: str, one: GainRecord) -> GainState:
    """A gain as the stream and the interface give it."""
    return GainState(
        None if one.value is None else shown(name, one.value),
        one.state,
        None if one.loaded is None else shown(name, one.loaded),
    )


def shown(name: str, value: float) -> float:
    """A value of the board in the shortest decimal form: 0.6, not 0.6000000238418579."""
    return value if BY_NAME[name].is_integer else shortest(value)


def fault(name: str, value: float) -> str | None:
    """Why this value is not allowed, in one sentence; None if it is allowed."""
    parameter = BY_NAME[name]
    # The limit is compared as the wire will carry it: 99.99 is allowed although its nearest single is above it.
    return value_fault(name, value, parameter.minimum, parameter.maximum, is_integer=parameter.is_integer)


def _after_read(held: GainRecord, value: Json) -> GainRecord:
    if value is None or isinstance(value, str):
        return GainRecord(loaded=held.loaded)
    found = float(value)
    return GainRecord(found, state_after_read(held, found), found if held.loaded is None else held.loaded)


def _same(parameter: Parameter, wanted: float, found: Json) -> bool:
    if not isinstance(found, int | float):
        return False
    return found == (wanted if parameter.is_integer else single(wanted))
