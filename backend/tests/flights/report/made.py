"""Synthetic flights: loops of known second-order dynamics that answer known steps, with noise and gusts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np
import pytest
from numpy.typing import NDArray

from epf_gcs.contract.report import ReportManoeuvre
from epf_gcs.flights.breaks import breaks_of
from epf_gcs.flights.events import find_events
from epf_gcs.flights.report.found import manoeuvres
from epf_gcs.flights.report.sources import PLANS, plan_signals
from tests.flights.test_events import MadeFlight

Array = NDArray[np.float64]
KINDS = {"altitude": ("climb", "descent"), "heading": ("turn_right", "turn_left"), "speed": ("faster", "slower")}
# Rates of the streams that the station sees, Hz: the simulator's, the plan's, the heartbeat's.
SIMULATOR_HZ, PLAN_HZ, HEARTBEAT_HZ = 50.0, 10.0, 5.0


@dataclass
class Dynamics:
    """What the loop does: `bias` is the steady error as a share of each step."""

    frequency_rad_s: float
    damping: float
    bias: float
    delay_s: float = 0.0

    def answer(self, t_s: Array, rate: float | None = None) -> Array:
        """The textbook's unit step answer of a second-order system, after its dead time.

        With `rate` it is integrated, and moves no faster than that each second.
        """
        t_s = np.maximum(t_s - self.delay_s, 0.0)
        if rate is not None:
            return self._integrated(t_s, rate)
        decay = self.damping * self.frequency_rad_s
        if self.damping < 1.0:
            turn = self.frequency_rad_s * np.sqrt(1.0 - self.damping**2)
            swing = np.cos(turn * t_s) + decay / turn * np.sin(turn * t_s)
        else:
            turn = self.frequency_rad_s * np.sqrt(self.damping**2 - 1.0)
            swing = np.cosh(turn * t_s) + decay / turn * np.sinh(turn * t_s)
        return np.asarray(1.0 - np.exp(-decay * t_s) * swing)

    def _integrated(self, t_s: Array, rate: float) -> Array:
        """Small steps of time; where the limit is reached the speed stays at it, as behind a limiter."""
        step_s, place, speed = 0.002, 0.0, 0.0
        course = [0.0]
        for _ in range(int(float(t_s[-1]) / step_s) + 2):
            push = self.frequency_rad_s**2 * (1.0 - place) - 2.0 * self.damping * self.frequency_rad_s * speed
            speed = max(-rate, min(rate, speed + push * step_s))
            place += speed * step_s
            course.append(place)
        return np.asarray(np.interp(t_s, step_s * np.arange(len(course)), course))


@dataclass
class Truth:
    kind: str
    at_s: float
    size: float
    rise_s: float
    overshoot_percent: float
    damping: float
    steady_error: float


@dataclass
class Made:
    flight: MadeFlight
    truths: list[Truth] = field(default_factory=list)


def truth(kind: str, at_s: float, size: float, loop: Dynamics, rate: float | None = None) -> Truth:
    t_s = np.arange(0.0, 30.0 / (loop.frequency_rad_s * min(1.0, loop.damping)), 0.002)
    course = (1.0 - loop.bias) * loop.answer(t_s, rate)
    rise_s = float(t_s[np.argmax(course >= 0.9)] - t_s[np.argmax(course >= 0.1)])
    return Truth(kind, at_s, abs(size), rise_s, 100 * max(0.0, float(course.max()) - 1), loop.damping, loop.bias * size)


def make(seed: int, *, steps: int = 4, noise: float = 1.0, hard: bool = False) -> Made:
    """Three minutes or so for each of `steps` steps of every loop's target; every loop has its own dynamics.

    `hard`: gusts as large as they come beside the sensors' noise, a dead time of up to a second in each loop, and in
    half of the steps a limit of rate that bites.
    """
    rng = np.random.default_rng(seed)
    spacing_s = 60.0
    end_s = 40.0 + 3 * spacing_s * steps
    t_s = np.cumsum(rng.normal(1.0, 0.05, int(end_s * SIMULATOR_HZ))) / SIMULATOR_HZ
    plan_s = np.arange(0.05, t_s[-1], 1 / PLAN_HZ)
    made = Made(MadeFlight({}))
    loops = {
        "altitude": (Dynamics(rng.uniform(0.35, 0.9), rng.uniform(0.3, 1.2), rng.uniform(-0.06, 0.06)), 1000.0, 60.0),
        "heading": (Dynamics(rng.uniform(0.5, 1.2), rng.uniform(0.35, 1.2), 0.0), 40.0, 25.0),
        "speed": (Dynamics(rng.uniform(0.35, 0.9), rng.uniform(0.3, 1.2), rng.uniform(-0.06, 0.06)), 55.0, 4.0),
    }
    if hard:
        for loop, _, _ in loops.values():
            loop.delay_s = rng.uniform(0.0, 1.0)
    quiet = {"altitude": 0.8, "heading": 0.4, "speed": 0.06}
    targets, actual = {}, {}
    for place, (name, (loop, level, least)) in enumerate(loops.items()):
        wanted, flown, reached = np.full(len(plan_s), level), np.full(len(t_s), level), level
        for number in range(steps):
            # One loop after the other: an answer ends where another loop is asked for something.
            at_s = float(plan_s[int((20.0 + spacing_s * (3 * number + place) + rng.uniform(-4, 4)) * PLAN_HZ)])
            size = rng.uniform(1.0, 3.0) * least * rng.choice([-1.0, 1.0])
            # The earlier step's answer has ended: this one begins where it came to rest.
            final = reached + size * (1.0 - loop.bias)
            wanted[plan_s >= at_s] = reached + size
            after = t_s >= at_s
            rate = None
            if hard and rng.uniform() < 0.5:
                course = loop.answer(np.arange(0.0, 30.0, 0.01))
                rate = float(rng.uniform(0.4, 0.9) * np.max(np.diff(course)) / 0.01)
            flown[after] += (final - reached) * loop.answer(t_s[after] - at_s, rate)
            made.truths.append(truth(KINDS[name][0 if size > 0 else 1], at_s, size, loop, rate))
            reached = final
        gust = _gusts(rng, len(t_s)) * (1.0 if hard else 0.4) * quiet[name] * noise
        actual[name] = flown + gust + rng.normal(0.0, quiet[name] * noise, len(t_s))
        targets[name] = wanted
    waypoint = np.searchsorted(sorted(one.at_s for one in made.truths if "turn" in one.kind), plan_s, side="right")
    beats = np.arange(0.0, t_s[-1], 1 / HEARTBEAT_HZ)
    made.flight = MadeFlight(
        {
            "heartbeat": (beats, {"autopilot_hil": np.ones(len(beats)), "autopilot": np.zeros(len(beats))}),
            "fms_hil_plan": (
                plan_s,
                {
                    "altitude_ft": targets["altitude"],
                    "bearing_deg": targets["heading"] % 360.0,
                    "speed_kt": targets["speed"],
                    "waypoint": waypoint.astype(float),
                    "distance_m": np.full(len(plan_s), 1500.0),
                },
            ),
            "simulator": (
                t_s,
                {
                    "altitude_indicated_ft": actual["altitude"],
                    "horizontal_path_deg": actual["heading"] % 360.0,
                    "indicated_airspeed_kt": actual["speed"],
                },
            ),
        }
    )
    return made


def _gusts(rng: np.random.Generator, count: int) -> Array:
    """Turbulence: noise that lasts about two seconds, of size 1."""
    keep = np.exp(-1.0 / (2.0 * SIMULATOR_HZ))
    found = np.empty(count)
    value = 0.0
    for number, push in enumerate(rng.normal(0.0, np.sqrt(1 - keep * keep), count)):
        value = keep * value + push
        found[number] = value
    return found


def near(value: float, **tolerance: Any) -> Any:
    """`pytest.approx` for a field whose type is a number."""
    return pytest.approx(value, **tolerance)


def matches(found: list[ReportManoeuvre], truths: list[Truth]) -> list[tuple[Truth, ReportManoeuvre]]:
    """What was found rightly: of the same kind, within a second."""
    left = list(found)
    pairs = []
    for truth in truths:
        one = next((o for o in left if o.kind == truth.kind and abs(o.at_s - truth.at_s) <= 1.0), None)
        if one is not None:
            left.remove(one)
            pairs.append((truth, one))
    return pairs


Flown = tuple[Made, list[ReportManoeuvre]]
"""A flight with the steps that were found in it."""

WITHIN: Final = 0.05
"""The share of the truth by which a figure may be off."""


def found_in(flight: MadeFlight) -> tuple[list[ReportManoeuvre], str | None]:
    """The manoeuvres that the report finds, or why there are none."""
    breaks = breaks_of(find_events(flight, [], []), flight.start_ns)
    return manoeuvres(flight, [plan_signals(flight, plan, breaks) for plan in PLANS])


def fly(count: int) -> list[Flown]:
    """Flights of one step in each loop, and what the report finds in them."""
    every = [make(seed, steps=1) for seed in range(count)]
    return [(made, [one for one in found_in(made.flight)[0] if one.kind != "leg"]) for made in every]


def f1_of(flown: Sequence[Flown]) -> float:
    """How well the manoeuvres were found: the harmonic mean of precision and recall."""
    right = sum(len(matches(found, made.truths)) for made, found in flown)
    wrong = sum(len(found) for _, found in flown) - right
    missed = sum(len(made.truths) for made, _ in flown) - right
    return 2 * right / (2 * right + wrong + missed)


def worst_errors(flown: Sequence[Flown]) -> dict[str, float]:
    """Rise time and damping as shares of the true ones, overshoot and steady error as shares of the step."""
    worst: dict[str, float] = {}
    for made, found in flown:
        for truth, one in matches(found, made.truths):
            assert one.rise_s is not None
            assert one.overshoot_percent is not None
            assert one.model is not None
            assert one.model.damping is not None
            assert one.steady_error is not None
            errors = {
                "rise_s": one.rise_s / truth.rise_s - 1.0,
                "overshoot": (one.overshoot_percent - truth.overshoot_percent) / 100.0,
                "damping": one.model.damping / truth.damping - 1.0,
                "steady_error": (one.steady_error - truth.steady_error) / truth.size,
            }
            worst = {name: max(worst.get(name, 0.0), abs(error)) for name, error in errors.items()}
    return worst
