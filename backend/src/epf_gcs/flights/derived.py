"""Signals as a question names them: a recorded one, or one that is computed from recorded ones.

`rate(a)` is the change of `a` in a second, from one sample to the next. `diff(a,b)` is `a` less `b`, taken at each
sample of `a` from the newest of `b`; `error(a,target)` is the target less `a`, taken in the same way. Angles go the
short way round.
"""

from __future__ import annotations

import re
from typing import Final, NamedTuple

import numpy as np

from epf_gcs.errors import InvalidInputError
from epf_gcs.flights.flight_data import FlightData, PeriodCache, split_name
from epf_gcs.flights.signals import Array, longest_step_s
from epf_gcs.units import M_PER_FT, MPS_PER_KT

_RECORDED: Final = r"[A-Za-z0-9_]+\.[A-Za-z0-9_]+"
_ONE: Final = rf"(?:{_RECORDED}|rate\({_RECORDED}\)|(?:diff|error)\({_RECORDED},{_RECORDED}\))"
_ARGUMENTS: Final = re.compile(r"(rate|diff|error)\((.*)\)")
_ANGLE: Final = "deg"
# One of the first in the second.
_FACTORS: Final = {
    ("m", "ft"): M_PER_FT,
    ("ft", "m"): 1 / M_PER_FT,
    ("kt", "m/s"): 1 / MPS_PER_KT,
    ("m/s", "kt"): MPS_PER_KT,
    ("deg", "rad"): 180 / np.pi,
    ("rad", "deg"): np.pi / 180,
}


class Signal(NamedTuple):
    """A signal: times in seconds since the flight's start, in order, and values (NaN: no value), both (n,).

    `period_s` is the usual time between samples, None where there are too few to tell.
    """

    unit: str
    t_s: Array
    values: Array
    period_s: float | None


def split_names(names: str) -> list[str]:
    """The names of a question, which commas separate, in their order."""
    return re.findall(_ONE, names)


def find(flight: FlightData, periods: PeriodCache, name: str) -> Signal:
    """One signal, empty if the flight does not have it. Raises NotFoundError for a name that the definition does not
    have, and InvalidInputError for a difference of unlike units.
    """
    derived = _ARGUMENTS.fullmatch(name)
    if derived is None:
        return _recorded(flight, periods, name)
    return periods.computed(name, flight.end_ns, lambda: _computed(flight, periods, name, derived))


def _computed(flight: FlightData, periods: PeriodCache, name: str, derived: re.Match[str]) -> Signal:
    operands = [_recorded(flight, periods, one) for one in derived[2].split(",")]
    if derived[1] == "rate":
        return _rate(operands[0])
    found = _difference(name, *operands)
    return found if derived[1] == "diff" else found._replace(values=-found.values)


def _recorded(flight: FlightData, periods: PeriodCache, name: str) -> Signal:
    topic, field = split_name(flight, name)
    unit = flight.fields(topic)[field].unit
    if topic not in {span.name for span in flight.topics()}:
        return Signal(unit, np.empty(0), np.empty(0), None)
    t_s, values = flight.samples(topic, field)
    return Signal(unit, t_s, values, periods.of(topic, t_s))


def _rate(signal: Signal) -> Signal:
    """The first sample, and one after a gap, have no rate. Of samples with one time only the last counts."""
    unit, t_s, values, period_s = signal
    last = np.append(np.diff(t_s) > 0, True)[: len(t_s)]
    t_s, values = t_s[last], values[last]
    rates = np.full(len(t_s), np.nan)
    steps_s = np.diff(t_s)
    rates[1:] = _short_way(np.diff(values), unit) / steps_s
    rates[1:][steps_s > longest_step_s(period_s)] = np.nan
    return Signal("1/s" if unit == "1" else f"{unit}/s", t_s, rates, period_s)


def _difference(name: str, one: Signal, other: Signal) -> Signal:
    """No value before the other's first sample, and in its gaps."""
    factor = 1.0 if one.unit == other.unit else _FACTORS.get((one.unit, other.unit))
    if factor is None:
        raise InvalidInputError(
            "signal_units_differ",
            f"The signals of '{name}' have the units {one.unit} and {other.unit}: only like quantities are compared.",
            signal=name,
            unit=one.unit,
            other=other.unit,
        )
    newest = np.searchsorted(other.t_s, one.t_s, side="right") - 1
    there = newest >= 0
    there[there] = one.t_s[there] - other.t_s[newest[there]] <= longest_step_s(other.period_s)
    values = np.full(len(one.t_s), np.nan)
    values[there] = _short_way(one.values[there] - other.values[newest[there]] * factor, one.unit)
    return Signal(one.unit, one.t_s, values, one.period_s)


def _short_way(change: Array, unit: str) -> Array:
    """From 359 deg to 1 deg are 2 deg."""
    if unit != _ANGLE:
        return change
    return np.where(np.abs(change) > 180, change - 360 * np.round(change / 360), change)
