"""The manoeuvres of a flight with the figures of each, as the report gives them."""

from __future__ import annotations

from typing import Final

import numpy as np

from epf_gcs.contract.report import NoManoeuvres, ReportLeg, ReportManoeuvre, ReportTrace
from epf_gcs.flights.flight_data import FlightData
from epf_gcs.flights.over_ground import offsets_m, steps_m
from epf_gcs.flights.report.manoeuvres import (
    Leg,
    Loop,
    Series,
    Step,
    alone,
    answer_of,
    changed,
    find_legs,
    find_steps,
    wrapped,
)
from epf_gcs.flights.report.response import respond
from epf_gcs.flights.report.sources import LOOPS, Place, PlanSignals, places
from epf_gcs.flights.signals import Array

UNITS: Final = {"altitude": "ft", "heading": "deg", "speed": "kt"}
_MOST: Final = 200
_TRACE: Final = 160
_BEFORE_S: Final = 3.0
# The bearing is of no use beside the waypoint.
_NEAR_M: Final = 60.0


def manoeuvres(flight: FlightData, plans: list[PlanSignals]) -> tuple[list[ReportManoeuvre], NoManoeuvres | None]:
    """All manoeuvres of both plans in order of time, and why there are none: `no_targets`, `autopilot_off` or
    `no_changes`. Raises OSError.
    """
    found: list[ReportManoeuvre] = []
    reason: NoManoeuvres = "no_targets"
    for signals in plans:
        if not any(len(target.t_s) for target in signals.targets.values()):
            continue
        if not signals.flown:
            reason = "autopilot_off" if reason == "no_targets" else reason
            continue
        reason = "no_changes"
        changes = signals.waypoint.t_s[1:][changed(signals.waypoint)]
        steps: list[Step] = []
        for loop in LOOPS:
            target, actual = signals.targets[loop], signals.actual[loop]
            steps += find_steps(loop, target, actual, signals.flown, changes, signals.actual["speed"])
        found += [_answered(step, signals) for step in alone(steps)]
        place = places(flight, signals.plan)
        found += [_leg(leg, signals, place) for leg in find_legs(signals.waypoint, signals.flown)]
    found.sort(key=lambda one: (one.at_s, one.kind))
    return found[:_MOST], None if found else reason


def loop_error(signals: PlanSignals, loop: Loop, from_s: float, to_s: float) -> float | None:
    """Root mean square of target minus signal in a stretch, while the autopilot flew; None without samples."""
    target, actual = signals.targets[loop], signals.actual[loop]
    squares: list[Array] = []
    for begin, end, _ in signals.flown:
        part = actual.part(max(begin, from_s), min(end, to_s))
        error = target.at(part.t_s) - part.values
        squares.append((wrapped(error) if loop == "heading" else error) ** 2)
    every = np.concatenate(squares) if squares else np.empty(0)
    every = every[np.isfinite(every)]
    return float(np.sqrt(np.mean(every))) if len(every) else None


def _answered(step: Step, signals: PlanSignals) -> ReportManoeuvre:
    target, actual = signals.targets[step.loop], signals.actual[step.loop]
    answer = answer_of(step, target, actual)
    figures = respond(answer.t_s, answer.values, step.start, step.target)
    return ReportManoeuvre(
        kind=step.kind,
        plan=signals.plan,
        cause=step.cause,
        at_s=step.at_s,
        until_s=step.until_s,
        unit=UNITS[step.loop],
        size=abs(step.target - step.start),
        start=step.start,
        target=step.target,
        waypoint=_waypoint(signals, step.at_s),
        **figures._asdict(),
        leg=None,
        trace=_trace(step, target, actual),
        earlier=None,
    )


def _waypoint(signals: PlanSignals, at_s: float) -> int | None:
    number = signals.waypoint.at(np.array([at_s + 0.5]))[0]
    return int(number) if np.isfinite(number) else None


def _trace(step: Step, target: Series, actual: Series) -> ReportTrace:
    """What the small picture draws: from a little before the step to its end; times from the step on."""
    part = actual.part(step.at_s - _BEFORE_S, step.until_s)
    if len(part.t_s) > _TRACE:
        chosen = np.unique(np.linspace(0, len(part.t_s) - 1, _TRACE).astype(np.int64))
        part = Series(part.t_s[chosen], part.values[chosen])
    wanted = target.at(part.t_s)
    values = part.values
    if step.loop == "heading":
        values, wanted = -wrapped(wanted - values), np.zeros(len(values))
        values = np.where(part.t_s < step.at_s, np.nan, values)
    else:
        after = part.t_s >= step.at_s
        wanted = np.where(after, step.target, wanted)
    return ReportTrace(_times(part.t_s - step.at_s), _rounded(values, 3), _rounded(wanted, 3))


def _leg(leg: Leg, signals: PlanSignals, place: Place | None) -> ReportManoeuvre:
    """A leg has no step to answer: the course flown and how well the targets were held."""
    across = None if place is None else _across_m(leg, place, signals)
    flown_m = None if place is None else _flown_m(place, leg.at_s, leg.until_s)
    half_s = (leg.at_s + leg.until_s) / 2
    return ReportManoeuvre(
        kind="leg",
        plan=signals.plan,
        cause="waypoint",
        at_s=leg.at_s,
        until_s=leg.until_s,
        unit="m",
        size=leg.until_s - leg.at_s,
        start=None,
        target=None,
        waypoint=leg.waypoint,
        **respond(np.empty(0), np.empty(0), 0.0, 0.0)._asdict(),
        leg=ReportLeg(
            duration_s=leg.until_s - leg.at_s,
            distance_m=flown_m,
            across_rms_m=None if across is None else float(np.sqrt(np.mean(across.values**2))),
            across_most_m=None if across is None else float(np.max(np.abs(across.values))),
            altitude_error_ft=loop_error(signals, "altitude", half_s, leg.until_s),
            speed_error_kt=loop_error(signals, "speed", half_s, leg.until_s),
        ),
        trace=None if across is None else _across_trace(across, leg.at_s),
        earlier=None,
    )


def _across_m(leg: Leg, place: Place, signals: PlanSignals) -> Series | None:
    """Distance to the right of the straight line from where the leg began to its waypoint."""
    first, last = np.searchsorted(place.t_s, (leg.at_s, leg.until_s))
    if last - first < 2:
        return None
    bearing, distance_m = signals.targets["heading"], signals.distance_m
    moment = np.array([leg.at_s])
    towards, away_m = bearing.at(moment)[0], distance_m.at(moment)[0]
    if not np.isfinite(towards) or not np.isfinite(away_m) or away_m < _NEAR_M:
        return None
    latitude, longitude = place.latitude_deg[first:last], place.longitude_deg[first:last]
    north_m, east_m = offsets_m(latitude, longitude, latitude[:1], longitude[:1])
    course = np.radians(towards)
    return Series(place.t_s[first:last], east_m * np.cos(course) - north_m * np.sin(course))


def _flown_m(place: Place, from_s: float, to_s: float) -> float | None:
    first, last = np.searchsorted(place.t_s, (from_s, to_s))
    if last - first < 2:
        return None
    return float(steps_m(place.latitude_deg[first:last], place.longitude_deg[first:last]).sum())


def _across_trace(across: Series, at_s: float) -> ReportTrace:
    chosen = np.unique(np.linspace(0, len(across.t_s) - 1, min(_TRACE, len(across.t_s))).astype(np.int64))
    return ReportTrace(_times(across.t_s[chosen] - at_s), _rounded(across.values[chosen], 2), [0.0] * len(chosen))


def _times(t_s: Array) -> list[float]:
    return [round(one_s, 3) for one_s in t_s.tolist()]


def _rounded(values: Array, digits: int) -> list[float | None]:
    return [round(value, digits) if np.isfinite(value) else None for value in values.tolist()]
