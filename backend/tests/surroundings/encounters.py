"""Many made flights, each judged: an encounter that was warned of in time or not, quiet minutes warned or not."""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from epf_gcs.surroundings.aircraft import AircraftSurroundings, Heights, WatchChoice
from tests.surroundings.flown import (
    FREE_S,
    STEP_S,
    Flown,
    Leg,
    TrueHeight,
    Weather,
    border_clearance,
    fly,
    least_clearance,
    weather,
)

LOOK_S = 0.5
WARN_S = 30.0
_EARLIEST_S = 45.0
_MINUTE_S = 60.0
_AFTER_S = 40.0
# A warning tells what was flown so long ago: a threat counts when it lasted 1 s, and fixes and looks are a little old.
# A pilot who turns away just then was warned rightly.
_DECIDES_S = 1.5


@dataclass(frozen=True)
class Plan:
    """How a flight is flown; `longer` of it is the same flight with the last leg so much longer."""

    seed: int
    place_deg: tuple[float, float]
    altitude_m: float
    heading_rad: float
    airspeed_mps: float
    legs: tuple[Leg, ...]
    weather: Weather
    has_velocity: bool

    def fly(self) -> Flown:
        """Fly it."""
        return fly(
            self.seed,
            self.place_deg,
            self.altitude_m,
            self.heading_rad,
            self.airspeed_mps,
            self.legs,
            self.weather,
            has_velocity=self.has_velocity,
        )

    def going_on(self, from_s: float, for_s: float) -> Plan:
        """The pilot goes on as he flies at `from_s`, for `for_s`."""
        legs: list[Leg] = []
        begun_s = 0.0
        for leg in self.legs:
            if begun_s + leg.for_s > from_s:
                legs.append(Leg(from_s - begun_s + for_s, leg.bank_rad, leg.climb_mps))
                break
            legs.append(leg)
            begun_s += leg.for_s
        return Plan(
            self.seed,
            self.place_deg,
            self.altitude_m,
            self.heading_rad,
            self.airspeed_mps,
            tuple(legs),
            self.weather,
            self.has_velocity,
        )


def some_plan(seed: int, place_deg: tuple[float, float], altitude_m: float, kind: str) -> Plan:
    """`kind`: straight, climbing, turning or wandering (a pilot who changes what he does)."""
    chance = random.Random(seed)
    climb_mps = {"climbing": chance.uniform(0.5, 3.0)}.get(kind, chance.choice((0.0, 0.0, chance.uniform(-2.0, 0.0))))
    side = chance.choice((-1.0, 1.0))
    turning = Leg(200.0, side * math.radians(chance.uniform(6.0, 30.0)), climb_mps)
    # Most flights have turned before: after take-off, or onto this leg.
    before = [Leg(5.0, 0.0, 0.0), Leg(chance.uniform(8.0, 25.0), -side * math.radians(20.0), 0.0)]
    legs = before if chance.random() < 0.7 else []
    if kind == "wandering":
        for _ in range(12):
            bank = chance.choice((0.0, 0.0, math.radians(chance.uniform(-30.0, 30.0))))
            legs.append(Leg(chance.uniform(8.0, 60.0), bank, chance.choice((0.0, chance.uniform(-1.5, 2.5)))))
    elif kind == "turning":
        legs += [Leg(chance.uniform(5.0, 60.0), 0.0, 0.0), turning]
    else:
        legs.append(Leg(260.0, 0.0, climb_mps))
    heading_rad, airspeed_mps = chance.uniform(0.0, 2 * math.pi), chance.uniform(17.0, 38.0)
    air = weather(chance)
    return Plan(seed, place_deg, altitude_m, heading_rad, airspeed_mps, tuple(legs), air, chance.random() < 0.8)


@dataclass
class Score:
    """`warned` of `encounters` in time; `alarmed` of `quiet` minutes. `avoided`: minutes in which the pilot would have
    met it and turned away: neither. `near`: quiet minutes with less than twice the margin."""

    encounters: int = 0
    warned: int = 0
    quiet: int = 0
    alarmed: int = 0
    near: int = 0
    near_alarmed: int = 0
    avoided: int = 0

    @property
    def warned_percent(self) -> float:
        """Of the encounters."""
        return 100.0 * self.warned / max(1, self.encounters)

    @property
    def alarmed_percent(self) -> float:
        """Of the quiet minutes."""
        return 100.0 * self.alarmed / max(1, self.quiet)


Clearance = Callable[[Flown], Sequence[float]]


def ground_clearance(height: TrueHeight) -> Clearance:
    """Above the true ground."""
    return lambda flown: least_clearance(flown, height)


def fence_clearance(corners_deg: Sequence[tuple[float, float]], ceiling_m: float | None) -> Clearance:
    """To the border and the ceiling, whichever is nearer."""

    def found(flown: Flown) -> list[float]:
        border = border_clearance(flown, corners_deg) if corners_deg else [math.inf] * len(flown.altitude_m)
        if ceiling_m is None:
            return border
        return [min(one, ceiling_m - high) for one, high in zip(border, flown.altitude_m, strict=True)]

    return found


def judge(
    plan: Plan,
    wanted: WatchChoice,
    heights: Heights,
    clearance: Clearance,
    margin_m: float,
    score: Score,
    *,
    counts: str,
) -> None:
    """Fly and count. `counts`: "encounters" or "quiet": which of both is still wanted."""
    flown = plan.fly()
    found = clearance(flown)
    met = next((index for index, one in enumerate(found) if one <= 0.0), None)
    if counts == "encounters":
        if met is None:
            return
        met_s = (met + 1) * STEP_S
        clear_before = any(one >= 2 * margin_m for one in found[:met])
        if met_s < _EARLIEST_S or met_s - flown.begun_before(met_s) < FREE_S or not clear_before:
            return
        score.encounters += 1
        warnings = list(_warnings(flown, wanted, heights, met_s))
        score.warned += any(t_s <= met_s - WARN_S and until_s >= met_s - STEP_S for t_s, until_s in warnings)
        return
    if not all(one >= margin_m for one in found):  # NaN, ground that nobody knows, is not quiet either
        return
    end_s = len(found) * STEP_S
    warnings = list(_warnings(flown, wanted, heights, end_s))
    minute_s = 0.0
    while minute_s + _MINUTE_S + _AFTER_S <= end_s:
        during = [one for one in warnings if one[0] < minute_s + _MINUTE_S and one[1] > minute_s]
        least = min(found[round(minute_s / STEP_S) : round((minute_s + _MINUTE_S + _AFTER_S) / STEP_S)])
        if during and all(_would_meet(plan, clearance, margin_m, t_s) for t_s, _ in during):
            score.avoided += 1
        else:
            score.quiet += 1
            score.alarmed += bool(during)
            score.near += least < 2 * margin_m
            score.near_alarmed += bool(during) and least < 2 * margin_m
        minute_s += _MINUTE_S


def _would_meet(plan: Plan, clearance: Clearance, margin_m: float, t_s: float) -> bool:
    """Whether the aircraft would have come nearer than the margin, had the pilot gone on as he flew when the station
    decided to warn."""
    decided_s = max(0.0, t_s - _DECIDES_S)
    found = clearance(plan.going_on(decided_s, t_s + _AFTER_S - decided_s).fly())
    return any(one < margin_m for one in found[round(decided_s / STEP_S) :])


def _warnings(flown: Flown, wanted: WatchChoice, heights: Heights, end_s: float) -> Iterator[tuple[float, float]]:
    """When each warning began and ended."""
    aircraft = AircraftSurroundings()
    fixes = iter(flown.fixes)
    fix = next(fixes, None)
    begun_s: float | None = None
    now_s = 0.0
    while now_s < end_s:
        now_s += LOOK_S
        while fix is not None and fix.t_s <= now_s:
            aircraft.add(fix)
            fix = next(fixes, None)
        seen = aircraft.look(now_s, wanted, heights, has_heights=True)
        is_warned = seen.terrain is not None or seen.fence is not None
        if is_warned and begun_s is None:
            begun_s = now_s
        elif not is_warned and begun_s is not None:
            yield begun_s, now_s
            begun_s = None
    if begun_s is not None:
        yield begun_s, now_s


def some_fence(
    seed: int, place_deg: tuple[float, float], altitude_m: float
) -> tuple[tuple[tuple[float, float], ...], float | None]:
    """A border around this place, of any shape, or a ceiling above it, or both."""
    chance = random.Random(seed)
    ceiling_m = altitude_m + chance.uniform(60.0, 250.0) if chance.random() < 0.4 else None
    if ceiling_m is not None and chance.random() < 0.5:
        return (), ceiling_m
    angles = sorted(chance.uniform(0.0, 2 * math.pi) for _ in range(chance.randint(5, 10)))
    across = math.cos(math.radians(place_deg[0]))
    corners = []
    scale_m = chance.choice((2500.0, 4000.0, 6000.0, 9000.0))
    for angle in angles:
        reach_deg = scale_m * chance.uniform(0.5, 1.0) / 111_195.0
        north_deg, east_deg = reach_deg * math.cos(angle), reach_deg * math.sin(angle) / across
        corners.append((place_deg[0] + north_deg, place_deg[1] + east_deg))
    return tuple(corners), ceiling_m


def no_heights(latitude_deg: np.ndarray, longitude_deg: np.ndarray) -> np.ndarray:
    """For fences alone."""
    return np.full(latitude_deg.shape, np.nan)
