"""One flight of the lab, with all that is judged of it."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Final, NamedTuple

from epf_gcs.contract.simulator_faults import Fault
from epf_gcs.lab.aircraft_loop import AircraftLoop
from epf_gcs.lab.conditions import USUAL, Conditions
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.faulty import FaultyLockStep
from epf_gcs.lab.figures import Figures, measure
from epf_gcs.lab.laws import BANK_LIMIT, LINE, USUAL_BANK_DEG
from epf_gcs.lab.lock_step import LockStep, Upset
from epf_gcs.lab.passages import in_passing
from epf_gcs.lab.routes import FLIGHT_PLAN, HIL_PLAN, Route
from epf_gcs.lab.truth import Truth


class Moment(NamedTuple):
    """A moment of a flight, and what is to be seen there."""

    at_s: float
    why: str


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Flight(Figures):
    """What was flown, in which conditions, and the figures of it, from the simulator's truth. `upset`: how it ended
    before its time; None: its end is the route's, or time was up. `evidence`: what shows that each fault was there.
    `library`: the laws; None: this station's own. `bounds`: what `check` held it against."""

    route: Route
    conditions: Conditions
    gains: Mapping[str, float]
    truth: Truth
    upset: Upset | None
    faults: tuple[Fault, ...] = ()
    evidence: tuple[str, ...] = ()
    longest_s: float = math.inf
    library: Path | None = None
    bounds: dict[str, float] = field(default_factory=dict, compare=False)

    @property
    def is_safe(self) -> bool:
        """Whether the aircraft was kept, and was at each waypoint when it counted as captured."""
        return self.upset is None and self.captured_honestly == len(self.route.waypoints)

    @property
    def moment(self) -> Moment:
        """The moment to look at first: where the aircraft was lost, else where the first waypoint was left behind away
        from it, else where it was furthest off the way."""
        if self.upset is not None:
            return Moment(self.upset.time_s, f"lost: {self.upset.cause}")
        for one in self.captures:
            if not one.is_honest:
                off = f"{one.distance_m:.0f} m and {one.altitude_error_ft:+.0f} ft"
                return Moment(one.time_s, f"waypoint {one.waypoint + 1} is left behind {off} away")
        return Moment(self.furthest_at_s, f"furthest off the way: {self.near.largest_m:.1f} m")

    def check(self, **bounds: float) -> None:
        """Hold figures against bounds, by the names of `FIGURES`: of waypoints it must be at least so many, of all else
        at most so much. Raises AssertionError with each figure beside its bound; LabError for an unknown name."""
        unknown = bounds.keys() - FIGURES.keys()
        if unknown:
            raise LabError(f"there is no figure {', '.join(sorted(unknown))}: choose of {', '.join(FIGURES)}")
        self.bounds.update(bounds)
        if not all(self.is_within(name) for name in bounds):
            told = (f"{name} {FIGURES[name](self):g}, bound {bound:g}" for name, bound in bounds.items())
            raise AssertionError(f"{self}: {'; '.join(told)}")

    def is_within(self, name: str) -> bool:
        """Whether a figure that has a bound is within it; a figure of nothing is not."""
        figure, bound = FIGURES[name](self), self.bounds[name]
        return figure >= bound if name in AT_LEAST else figure <= bound

    def __str__(self) -> str:
        """For a failed test: what to fly to see it again, and how it ended."""
        changed = [f"{name}={getattr(self.conditions, name)!r}" for name in _changed(self.conditions)]
        changed += [f"{name}={value!r}" for name, value in self.gains.items()]
        changed += [f"fault={fault}" for fault in self.faults]
        end = f"lost after {self.upset.time_s:.1f} s: {self.upset.cause}" if self.upset else f"{self.time_s:.0f} s"
        reached = f"{self.captured_honestly} of {len(self.route.waypoints)} waypoints"
        return f"<flight of {self.route.name} ({', '.join(changed)}): {reached}, {end}>"

    __repr__ = __str__


def fly(
    route: Route,
    conditions: Conditions,
    gains: Mapping[str, float] | None = None,
    library: Path | None = None,
    faults: Sequence[Fault] = (),
    longest_s: float = math.inf,
) -> Flight:
    """Fly a route from its start to its end, or for so long, in lock-step. Raises LabError if it cannot be flown as
    asked, or if a fault that was asked for was not there."""
    with _loop(conditions, library, faults) as loop:
        truth = fly_in(loop, route, conditions, gains or {}, longest_s)
        figures = measure(truth, route.waypoints)
        if conditions.law == LINE:
            figures = in_passing(figures, truth, route, (gains or {}).get(BANK_LIMIT, USUAL_BANK_DEG))
        return Flight(
            **{one.name: getattr(figures, one.name) for one in fields(Figures)},
            route=route,
            conditions=conditions,
            gains=dict(gains or {}),
            truth=truth,
            upset=loop.upset,
            faults=tuple(faults),
            evidence=loop.evidence() if isinstance(loop, FaultyLockStep) else (),
            longest_s=longest_s,
            library=library,
        )


def fly_in(
    loop: LockStep, route: Route, conditions: Conditions, gains: Mapping[str, float], longest_s: float = math.inf
) -> Truth:
    """Fly a route in a loop that was made for these conditions. Raises LabError if it cannot be flown as asked."""
    loop.select(conditions.law)
    loop.set_gains(gains)
    for name, values in route.commands(FLIGHT_PLAN if conditions.loop == "aircraft" else HIL_PLAN):
        loop.command(name, *values)
    loop.command("autopilot_on")
    return loop.fly(route.waypoints, min(longest_s, route.longest_s()))


FIGURES: Final[Mapping[str, Callable[[Flight], float]]] = {
    "waypoints_reached": lambda flight: flight.waypoints_reached,
    "captured_honestly": lambda flight: flight.captured_honestly,
    "time_s": lambda flight: flight.time_s,
    "cross_track_rms_m": lambda flight: flight.cross_track.rms_m,
    "leg_rms_m": lambda flight: flight.leg.rms_m,
    "leg_largest_m": lambda flight: flight.leg.largest_m,
    "near_rms_m": lambda flight: flight.near.rms_m,
    "altitude_rms_ft": lambda flight: flight.altitude.settled.rms_ft,
    "altitude_largest_ft": lambda flight: flight.altitude.settled.largest_ft,
    "speed_rms_kt": lambda flight: flight.airspeed.settled.rms_kt,
}
"""The figures by the names that a campaign's columns and bounds have; NaN for one of nothing."""
AT_LEAST: Final = frozenset({"waypoints_reached", "captured_honestly"})
"""Figures of which more is better."""


def _loop(conditions: Conditions, library: Path | None, faults: Sequence[Fault]) -> LockStep:
    if conditions.loop == "aircraft":
        return AircraftLoop(conditions.options(), faults, library)
    return FaultyLockStep(conditions.options(), faults, library) if faults else LockStep(conditions.options(), library)


def _changed(conditions: Conditions) -> list[str]:
    """The seed always, and what else is not as usual."""
    return [name for name, usual in USUAL.items() if name == "seed" or getattr(conditions, name) != usual]
