"""Gains that were changed in flight, and how the loop that they belong to flew before and after."""

from __future__ import annotations

from typing import Final, NamedTuple

import numpy as np

from epf_gcs.codec.messages_gen import PARAMETERS
from epf_gcs.contract.report import ReportEffect, ReportGain, ReportManoeuvre
from epf_gcs.flights.flight_data import FlightData
from epf_gcs.flights.report.found import loop_error
from epf_gcs.flights.report.manoeuvres import Loop
from epf_gcs.flights.report.sources import PlanSignals
from epf_gcs.recordings import notes

_GROUPS: Final = {parameter.name: parameter.group for parameter in PARAMETERS}
# Groups of gains are named after the loop; the rudder has none of its own.
_LOOPS: Final[dict[str, Loop]] = {"altitude": "altitude", "heading": "heading", "speed": "speed"}
KINDS: Final[dict[Loop, tuple[str, ...]]] = {
    "altitude": ("climb", "descent"),
    "heading": ("turn_right", "turn_left"),
    "speed": ("faster", "slower"),
}
FIGURES: Final = ("rise_s", "overshoot_percent", "settling_s", "steady_error")
# Changes within this time were written together, and share what came before and after.
_TOGETHER_S: Final = 2.0
# Less flight than this before or after a change tells nothing of its effect.
_LEAST_S: Final = 10.0


class GainChange(NamedTuple):
    """A gain that was known to be another at `at_s`, in seconds since the flight's start. `until_s`: until when it was
    known to be `before`, which is earlier where the board began anew meanwhile."""

    name: str
    at_s: float
    before: float
    after: float
    until_s: float


def gain_changes(flight: FlightData, plans: list[PlanSignals], manoeuvres: list[ReportManoeuvre]) -> list[ReportGain]:
    """Changes in order of time, with the loop before (since its last change) and after (until its next)."""
    changes = _changes(flight)
    end_s = (flight.end_ns - flight.start_ns) * 1e-9
    flown = next((signals for signals in plans if signals.flown), plans[0])
    found = []
    for change in changes:
        loop = _LOOPS.get(_GROUPS[change.name])
        at_s = change.at_s
        others = [
            other.at_s
            for other in changes
            if _GROUPS[other.name] == _GROUPS[change.name] and abs(other.at_s - at_s) > _TOGETHER_S
        ]
        from_s = max((other for other in others if other < at_s), default=0.0)
        to_s = min((other for other in others if other > at_s), default=end_s)
        found.append(
            ReportGain(
                change.name,
                at_s,
                change.before,
                change.after,
                loop=loop,
                earlier=None if loop is None else effect(loop, flown, manoeuvres, from_s, change.until_s),
                later=None if loop is None else effect(loop, flown, manoeuvres, at_s, to_s),
            )
        )
    return found


def effect(
    loop: Loop, flown: PlanSignals, manoeuvres: list[ReportManoeuvre], from_s: float, to_s: float
) -> ReportEffect:
    """How a loop flew in a stretch: medians of its manoeuvres that lie in it whole, and its error all the time."""
    inside = [
        one
        for one in manoeuvres
        if one.kind in KINDS[loop] and from_s <= one.at_s and one.until_s <= to_s and one.method != "none"
    ]
    error = loop_error(flown, loop, from_s, to_s) if to_s - from_s >= _LEAST_S else None
    return ReportEffect(from_s, to_s, len(inside), error, **medians(inside))


def medians(manoeuvres: list[ReportManoeuvre]) -> dict[str, float | None]:
    """The medians of each of the FIGURES, and of the damping where a model tells it."""
    found = {name: _median([getattr(one, name) for one in manoeuvres]) for name in FIGURES}
    return found | {"damping": _median([one.model.damping for one in manoeuvres if one.model is not None])}


def _median(values: list[float | None]) -> float | None:
    """The median of those that are known."""
    known = [value for value in values if value is not None]
    return float(np.median(known)) if known else None


def last_gains(flight: FlightData) -> dict[str, float]:
    """The gains as they were known at the end; those of a board that began anew are known once they were read again."""
    known: dict[str, float] = {}
    for _, values in _noted(flight):
        known = {name: value for name, value in (known | values).items() if value is not None}
    return known


def _changes(flight: FlightData) -> list[GainChange]:
    """What is not known is no change; a value that differs once it is known again has changed at some time between."""
    known: dict[str, float] = {}
    lost_s: dict[str, float] = {}
    found = []
    for at_s, values in _noted(flight):
        for name, value in values.items():
            if value is None:
                lost_s.setdefault(name, at_s)
                continue
            before = known.get(name)
            if before is not None and before != value:
                found.append(GainChange(name, at_s, before, value, lost_s.get(name, at_s)))
            known[name] = value
            lost_s.pop(name, None)
    return found


def _noted(flight: FlightData) -> list[tuple[float, dict[str, float | None]]]:
    """The gains of each note, None where they were not known, and its time."""
    found = []
    for note in flight.notes():
        if note.name == notes.PARAMETERS and isinstance(note.content, dict):
            values = {
                name: None if one.get("value") is None else float(one["value"])
                for name, one in note.content.items()
                if name in _GROUPS and isinstance(one, dict) and isinstance(one.get("value"), int | float | None)
            }
            found.append(((note.t_ns - flight.start_ns) * 1e-9, values))
    return found
