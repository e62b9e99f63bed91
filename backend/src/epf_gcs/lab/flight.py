"""One flight of the lab, with all that is judged of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from pathlib import Path

from epf_gcs.lab.conditions import USUAL, Conditions
from epf_gcs.lab.figures import Figures, measure
from epf_gcs.lab.laws import BANK_LIMIT, LINE, USUAL_BANK_DEG
from epf_gcs.lab.lock_step import LockStep, Upset
from epf_gcs.lab.passages import in_passing
from epf_gcs.lab.routes import Route
from epf_gcs.lab.truth import Truth


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Flight(Figures):
    """What was flown, in which conditions, and the figures of it, from the simulator's truth. `upset`: how it ended
    before its time; None: its end is the route's, or time was up."""

    route: Route
    conditions: Conditions
    gains: Mapping[str, float]
    truth: Truth
    upset: Upset | None

    @property
    def is_safe(self) -> bool:
        """Whether the aircraft was kept, and was at each waypoint when it counted as captured."""
        return self.upset is None and self.captured_honestly == len(self.route.waypoints)

    def __str__(self) -> str:
        """For a failed test: what to fly to see it again, and how it ended."""
        changed = [f"{name}={getattr(self.conditions, name)!r}" for name in _changed(self.conditions)]
        changed += [f"{name}={value!r}" for name, value in self.gains.items()]
        end = f"lost after {self.upset.time_s:.1f} s: {self.upset.cause}" if self.upset else f"{self.time_s:.0f} s"
        reached = f"{self.captured_honestly} of {len(self.route.waypoints)} waypoints"
        return f"<flight of {self.route.name} ({', '.join(changed)}): {reached}, {end}>"

    __repr__ = __str__


def fly(
    route: Route, conditions: Conditions, gains: Mapping[str, float] | None = None, library: Path | None = None
) -> Flight:
    """Fly a route from its start to its end, in lock-step. Raises LabError if it cannot be flown as asked."""
    with LockStep(conditions.options(), library) as loop:
        loop.select(conditions.law)
        loop.set_gains(gains or {})
        for name, values in route.commands():
            loop.command(name, *values)
        loop.command("autopilot_on")
        truth = loop.fly(route.waypoints, route.longest_s())
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
        )


def _changed(conditions: Conditions) -> list[str]:
    """The seed always, and what else is not as usual."""
    return [name for name, usual in USUAL.items() if name == "seed" or getattr(conditions, name) != usual]
