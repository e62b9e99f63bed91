"""Finds the manoeuvres of a flight: steps of the targets while the autopilot flew, and the legs between waypoints."""

from __future__ import annotations

from bisect import bisect_right
from itertools import pairwise
from typing import Final, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from epf_gcs.flights.signals import Array

Kind = Literal["climb", "descent", "turn_right", "turn_left", "faster", "slower", "leg"]
Cause = Literal["waypoint", "target", "engaged"]
Loop = Literal["altitude", "heading", "speed"]

LEAST: Final[dict[Loop, float]] = {"altitude": 30.0, "heading": 15.0, "speed": 2.0}
"""The smallest step that counts: ft, deg, kt."""
_KINDS: Final[dict[Loop, tuple[Kind, Kind]]] = {
    "altitude": ("climb", "descent"),
    "heading": ("turn_right", "turn_left"),
    "speed": ("faster", "slower"),
}
# Changes of a target that come within this time are one step.
_ONE_STEP_S: Final = 1.0
_LONGEST_S: Final = 120.0
# The mean of this time before the step is where it began.
_BEFORE_S: Final = 0.5
# On the ground no loop can answer.
_LEAST_SPEED_KT: Final = 20.0
# Longer without samples, and nothing is said of what happened in between.
_LONGEST_GAP_S: Final = 2.0
# Longer than so many usual steps of a slow stream.
_USUAL_STEPS: Final = 3.0


class Series(NamedTuple):
    """One signal: times in s since the flight's start, in order, and values without gaps in them, both (n,)."""

    t_s: Array
    values: Array

    def at(self, at_s: Array) -> Array:
        """The newest value at each of these times; NaN before the first."""
        if not len(self.t_s):
            return np.full(len(at_s), np.nan)
        places = np.searchsorted(self.t_s, at_s, side="right") - 1
        return np.where(places >= 0, self.values[np.maximum(places, 0)], np.nan)

    def part(self, from_s: float, to_s: float) -> Series:
        """The samples from `from_s` to `to_s`, without the latter."""
        first, last = np.searchsorted(self.t_s, (from_s, to_s))
        return Series(self.t_s[first:last], self.values[first:last])


class Stretch(NamedTuple):
    """From and to of a stretch with the autopilot on. `is_engaged`: it was switched on at its begin, and not only heard
    of after a silence, a pause or a jump."""

    from_s: float
    to_s: float
    is_engaged: bool


class Step(NamedTuple):
    """A target that changed at `at_s` and was alone to change until `until_s`. `start` is the signal at that moment.

    For the heading loop `start` is minus the error at the step, and the target 0: the bearing moves on as it flies.
    """

    kind: Kind
    loop: Loop
    cause: Cause
    at_s: float
    until_s: float
    start: float
    target: float


class Leg(NamedTuple):
    """The flight to one waypoint: `waypoint` is its number in the plan, from 0."""

    waypoint: int
    at_s: float
    until_s: float


def find_steps(
    loop: Loop, target: Series, actual: Series, flown: list[Stretch], waypoints: Array, speed: Series
) -> list[Step]:
    """The steps of one loop. `waypoints`: times at which the plan's waypoint changed."""
    found: list[Step] = []
    jumps = _jumps(loop, target)
    for from_s, to_s, is_engaged in flown:
        inside = [at_s for at_s in jumps if from_s < at_s < to_s]
        places: list[tuple[float, Cause]] = [(from_s, "engaged")] if is_engaged else []
        for at_s in inside:
            is_waypoint = len(waypoints) > 0 and float(np.min(np.abs(waypoints - at_s))) <= _ONE_STEP_S
            places.append((at_s, "waypoint" if is_waypoint else "target"))
        for number, (at_s, cause) in enumerate(places):
            next_s = places[number + 1][0] if number + 1 < len(places) else to_s
            step = _step(loop, cause, (at_s, min(next_s, at_s + _LONGEST_S)), target, actual, speed)
            if step is not None:
                found.append(step)
    return found


def alone(steps: list[Step]) -> list[Step]:
    """The steps of all loops in order, each until the next one: what another loop is asked for moves this one's signal
    too. Steps of one moment, as beside a waypoint, are answered side by side."""
    steps = sorted(steps, key=lambda one: one.at_s)
    begun_s = [step.at_s for step in steps]
    following = (bisect_right(begun_s, step.at_s + _ONE_STEP_S) for step in steps)
    return [
        step._replace(until_s=min(step.until_s, *begun_s[place : place + 1], np.inf))
        for step, place in zip(steps, following, strict=True)
    ]


def answer_of(step: Step, target: Series, actual: Series) -> Series:
    """The signal that answers a step, with times from the step on; of a turn it is minus the heading's error."""
    part = actual.part(step.at_s, step.until_s)
    values = part.values
    if step.loop == "heading":
        values = -wrapped(target.at(part.t_s) - part.values)
    return Series(part.t_s - step.at_s, values)


def find_legs(waypoint: Series, flown: list[Stretch]) -> list[Leg]:
    """Stretches of flight to one waypoint, between two changes of it."""
    found = []
    changes = np.flatnonzero(changed(waypoint)) + 1
    for place, after in zip(changes[:-1].tolist(), changes[1:].tolist(), strict=True):
        begin, end = float(waypoint.t_s[place]), float(waypoint.t_s[after])
        if any(one.from_s <= begin and end <= one.to_s for one in flown):
            found.append(Leg(int(waypoint.values[place]), begin, end))
    return found


def changed(series: Series) -> NDArray[np.bool_]:
    """Whether each sample but the first is another than the one before, without those whose time nobody saw: after a
    silence."""
    return np.asarray((np.diff(series.values) != 0) & _is_seen(series.t_s))


def stretches(flag: Series) -> list[Stretch]:
    """The stretches in which a flag is set, cut where no sample came for long."""
    found: list[Stretch] = []
    if not len(flag.t_s):
        return found
    # Whether the change to each sample, and the end behind the last, was seen.
    is_seen = np.concatenate(([False], _is_seen(flag.t_s), [False]))
    edges = np.flatnonzero((np.diff(flag.values) != 0) | ~is_seen[1:-1]) + 1
    for first, after in pairwise([0, *edges.tolist(), len(flag.t_s)]):
        begin, end = float(flag.t_s[first]), float(flag.t_s[after if is_seen[after] else after - 1])
        if flag.values[first] and end > begin:
            found.append(Stretch(begin, end, bool(is_seen[first])))
    return found


def without(flown: list[Stretch], spans: list[tuple[float, float]], *, is_engaged: bool) -> list[Stretch]:
    """The stretches outside of these spans, in order; `is_engaged` of those that begin behind one."""
    found: list[Stretch] = []
    for stretch in flown:
        rest = stretch
        for begin, end in spans:
            if begin >= rest.to_s or end <= rest.from_s:
                continue
            if begin > rest.from_s:
                found.append(rest._replace(to_s=begin))
            rest = Stretch(end, rest.to_s, is_engaged)
        if rest.to_s > rest.from_s:
            found.append(rest)
    return found


def wrapped(angle_deg: Array) -> Array:
    """Angles as -180 up to 180 deg."""
    return np.asarray((angle_deg + 180.0) % 360.0 - 180.0)


def _is_seen(t_s: Array) -> NDArray[np.bool_]:
    """Whether each sample but the first came soon after the one before; a slow stream is not silent."""
    apart_s = np.diff(t_s)
    usual_s = float(np.median(apart_s)) if len(apart_s) else 0.0
    return np.asarray(apart_s <= max(_LONGEST_GAP_S, _USUAL_STEPS * usual_s))


def _jumps(loop: Loop, target: Series) -> list[float]:
    """When the target stepped. A bearing also drifts as the aircraft passes: only what jumps between two samples."""
    change, is_seen = np.diff(target.values), _is_seen(target.t_s)
    if loop == "heading":
        places = np.flatnonzero(is_seen & (np.abs(wrapped(change)) >= LEAST[loop] / 2)) + 1
        return [float(at_s) for at_s in target.t_s[places]]
    places = np.flatnonzero(is_seen & (np.abs(change) > LEAST[loop] / 100)) + 1
    found: list[float] = []
    last_s = -np.inf
    for at_s in target.t_s[places].tolist():
        if at_s - last_s > _ONE_STEP_S:
            found.append(at_s)
        last_s = at_s
    return found


def _step(
    loop: Loop, cause: Cause, span_s: tuple[float, float], target: Series, actual: Series, speed: Series
) -> Step | None:
    """The step, if it is one and the signals are there; it ends where the samples do."""
    at_s, until_s = span_s
    part = actual.part(at_s, until_s)
    if len(part.t_s) < 2 or part.t_s[0] - at_s > _LONGEST_GAP_S:
        return None
    gaps = np.flatnonzero(np.diff(part.t_s) > _LONGEST_GAP_S)
    until_s = float(part.t_s[gaps[0]]) if len(gaps) else until_s
    # Later than the step by what may come in several changes; the mean of what is there just before it.
    settled_s = min(at_s + _ONE_STEP_S, until_s)
    wanted = float(target.at(np.array([settled_s if loop != "heading" else at_s]))[0])
    before = actual.part(at_s - _BEFORE_S, at_s).values
    before = before if len(before) else part.values[:1]
    if loop == "heading":
        start, wanted = -float(np.mean(wrapped(wanted - before))), 0.0
    else:
        start = float(np.mean(before))
    flying = speed.at(np.array([at_s]))[0]
    size = wanted - start
    if not np.isfinite(size) or abs(size) < LEAST[loop] or (np.isfinite(flying) and flying < _LEAST_SPEED_KT):
        return None
    return Step(_KINDS[loop][0 if size > 0 else 1], loop, cause, at_s, until_s, start, wanted)
