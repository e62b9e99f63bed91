"""One flight of the lab, with all that is judged of it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from pathlib import Path

from epf_gcs.lab.aircraft_loop import AircraftLoop
from epf_gcs.lab.conditions import USUAL, Conditions
from epf_gcs.lab.faults import Fault
from epf_gcs.lab.faulty import FaultyLockStep
from epf_gcs.lab.figures import Figures, measure
from epf_gcs.lab.lock_step import LockStep, Upset
from epf_gcs.lab.routes import FLIGHT_PLAN, HIL_PLAN, Route
from epf_gcs.lab.truth import Truth


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Flight(Figures):
    """What was flown, in which conditions, and the figures of it, from the simulator's truth. `upset`: how it ended
    before its time; None: its end is the route's, or time was up. `evidence`: what shows that each fault was there."""

    route: Route
    conditions: Conditions
    gains: Mapping[str, float]
    truth: Truth
    upset: Upset | None
    faults: tuple[Fault, ...] = ()
    evidence: tuple[str, ...] = ()

    @property
    def is_safe(self) -> bool:
        """Whether the aircraft was kept, and was at each waypoint when it counted as captured."""
        return self.upset is None and self.captured_honestly == len(self.route.waypoints)

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
        loop.set_gains(gains or {})
        for name, values in route.commands(FLIGHT_PLAN if conditions.loop == "aircraft" else HIL_PLAN):
            loop.command(name, *values)
        loop.command("autopilot_on")
        truth = loop.fly(route.waypoints, min(longest_s, route.longest_s()))
        figures = measure(truth, route.waypoints)
        return Flight(
            **{one.name: getattr(figures, one.name) for one in fields(Figures)},
            route=route,
            conditions=conditions,
            gains=dict(gains or {}),
            truth=truth,
            upset=loop.upset,
            faults=tuple(faults),
            evidence=loop.evidence() if isinstance(loop, FaultyLockStep) else (),
        )


def _loop(conditions: Conditions, library: Path | None, faults: Sequence[Fault]) -> LockStep:
    if conditions.loop == "aircraft":
        return AircraftLoop(conditions.options(), faults, library)
    return FaultyLockStep(conditions.options(), faults, library) if faults else LockStep(conditions.options(), library)


def _changed(conditions: Conditions) -> list[str]:
    """The seed always, and what else is not as usual."""
    return [name for name, usual in USUAL.items() if name == "seed" or getattr(conditions, name) != usual]
