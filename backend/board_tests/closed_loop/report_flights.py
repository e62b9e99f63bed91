"""Flights of steps in all loops, flown by the board's own laws in JSBSim, and what is read off their truth.

The truth is read without any of the report's code: first crossings, the extreme, the mean of the last eighth.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any, Final, NamedTuple

import numpy as np

from board_tests.closed_loop.closed_loop import ClosedLoop
from epf_gcs.codec.frame import Frame, FrameDecoder
from epf_gcs.contract.report import ReportManoeuvre
from epf_gcs.simulator.simulation import SimulationOptions
from epf_gcs.simulator.situation import AIRPORT_LATITUDE_DEG, AIRPORT_LONGITUDE_DEG, RUNWAY_HEADING_DEG, Situation
from tests.flights.report.made import KINDS, found_in
from tests.flights.test_events import MadeFlight

_HIL_PLAN: Final = 1
_SETTLE_S: Final = 60.0
_FAR_M: Final = 60_000.0
_M_PER_DEG: Final = 111_195.0


class Truth(NamedTuple):
    """A step as its samples say it: seconds, percent of the step, and the signal's unit. None: not reached."""

    kind: str
    at_s: float
    size: float
    rise_s: float | None
    overshoot_percent: float
    end_error: float


@dataclass
class FlownSteps:
    """One flight: its truths, and the manoeuvres of the report."""

    truths: list[Truth] = field(default_factory=list)
    found: list[ReportManoeuvre] = field(default_factory=list)

    def pairs(self) -> Iterator[tuple[Truth, ReportManoeuvre | None]]:
        """Each step with the manoeuvre that the report has of it."""
        for truth in self.truths:
            same = (one for one in self.found if one.kind == truth.kind and abs(one.at_s - truth.at_s) < 1.0)
            yield truth, next(same, None)


class _Listening(ClosedLoop):
    """Keeps what the plan asks for, with its time."""

    def __init__(self, options: SimulationOptions) -> None:
        self.plan: list[tuple[float, tuple[Any, ...]]] = []
        self._listener = FrameDecoder()
        super().__init__(options)

    def _take(self, data: bytes) -> None:
        for found in self._listener.feed(data):
            if isinstance(found, Frame) and found.message.name == "fms_hil_plan":
                self.plan.append((self.simulation.time_s, tuple(found.values)))
        super()._take(data)


def fly_steps(seed: int, situation: Situation | None = None, steps: int = 6) -> FlownSteps:
    """Steady flight, then steps of one quantity each, some of which end before they come to rest."""
    rng = random.Random(seed)
    options = SimulationOptions() if situation is None else SimulationOptions(situation=situation)
    course, altitude_ft, speed_kt = RUNWAY_HEADING_DEG, 1000.0, 55.0
    loops = [name for name in KINDS for _ in range(steps // len(KINDS))]
    rng.shuffle(loops)
    waypoints = [(*_far_away(course), altitude_ft, speed_kt)]
    for loop in loops:
        if loop == "altitude":
            altitude_ft += rng.choice((-1.0, 1.0)) * rng.uniform(80.0, 250.0)
        elif loop == "heading":
            course += rng.choice((-1.0, 1.0)) * rng.uniform(30.0, 90.0)
        else:
            speed_kt += rng.uniform(4.0, 8.0) * (1.0 if speed_kt < 58.0 else -1.0)
        waypoints.append((*_far_away(course), altitude_ft, speed_kt))
    flown = FlownSteps()
    with _Listening(options) as flight:
        flight.command("mission_begin", _HIL_PLAN, len(waypoints))
        for index, waypoint in enumerate(waypoints):
            flight.command("mission_item", _HIL_PLAN, index, *waypoint)
        flight.command("mission_commit", _HIL_PLAN)
        flight.command("autopilot_on")
        flight.fly(_SETTLE_S)
        spans = []
        for index in range(1, len(waypoints)):
            begin_s = flight.simulation.time_s
            flight.command("go_to_waypoint", _HIL_PLAN, index)
            flight.fly(rng.uniform(35.0, 110.0))
            spans.append((begin_s, flight.simulation.time_s))
        assert flight.crashes == []
        signals = _signals(flight)
        for loop, (begin_s, end_s), before, after in zip(loops, spans, waypoints, waypoints[1:], strict=False):
            flown.truths.append(_truth(loop, signals, (begin_s, end_s), before, after))
        flown.found = found_in(_recorded(flight, signals))[0]
    return flown


def _far_away(course_deg: float) -> tuple[float, float]:
    """A place so far on this course that the bearing to it hardly changes on the way."""
    north_m = _FAR_M * math.cos(math.radians(course_deg))
    east_m = _FAR_M * math.sin(math.radians(course_deg))
    shrink = math.cos(math.radians(AIRPORT_LATITUDE_DEG))
    return AIRPORT_LATITUDE_DEG + north_m / _M_PER_DEG, AIRPORT_LONGITUDE_DEG + east_m / (_M_PER_DEG * shrink)


def _signals(flight: _Listening) -> dict[str, Any]:
    states = [sample.state for sample in flight.samples]
    return {
        "t_s": np.array([sample.time_s for sample in flight.samples]),
        "altitude": np.array([state.altitude_indicated_ft for state in states]),
        "heading": np.array([state.track_deg for state in states]),
        "speed": np.array([state.airspeed_indicated_kt for state in states]),
        "plan_s": np.array([at_s for at_s, _ in flight.plan]),
        "plan": np.array([values for _, values in flight.plan], dtype=float),
    }


def _truth(
    loop: str, signals: dict[str, Any], span_s: tuple[float, float], before: tuple[float, ...], after: tuple[float, ...]
) -> Truth:
    inside = (signals["t_s"] > span_s[0]) & (signals["t_s"] <= span_s[1])
    t_s, values = signals["t_s"][inside] - span_s[0], signals[loop][inside]
    if loop == "heading":
        bearings = np.interp(t_s + span_s[0], signals["plan_s"] - 1e-6, np.unwrap(signals["plan"][:, 0], period=360.0))
        # The plan says its new bearing a tenth of a second after the step.
        bearings[t_s < 0.2] = bearings[np.argmax(t_s >= 0.2)]
        values, target = -((bearings - values + 180.0) % 360.0 - 180.0), 0.0
    else:
        target = after[2 if loop == "altitude" else 3]
    size = target - values[0]
    share = (values - values[0]) / size
    reached = [np.flatnonzero(share >= level) for level in (0.1, 0.9)]
    rise_s = float(t_s[reached[1][0]] - t_s[reached[0][0]]) if len(reached[1]) else None
    return Truth(
        KINDS[loop][0 if size > 0 else 1],
        span_s[0],
        abs(size),
        rise_s,
        100.0 * max(0.0, float(share.max()) - 1.0),
        float(target - np.mean(values[t_s >= 0.875 * t_s[-1]])),
    )


def _recorded(flight: _Listening, signals: dict[str, Any]) -> MadeFlight:
    """What the station has of it."""
    beats_s = np.arange(0.0, signals["t_s"][-1], 0.2)
    names = ("bearing_deg", "altitude_ft", "speed_kt", "distance_m", "waypoint")
    single = {name: signals[name].astype(np.float32) for name in KINDS}
    return MadeFlight(
        {
            "heartbeat": (beats_s, {"autopilot_hil": np.ones(len(beats_s)), "autopilot": np.zeros(len(beats_s))}),
            "fms_hil_plan": (signals["plan_s"], dict(zip(names, signals["plan"].T, strict=True))),
            "simulator": (
                signals["t_s"],
                {
                    "altitude_indicated_ft": single["altitude"],
                    "horizontal_path_deg": single["heading"],
                    "indicated_airspeed_kt": single["speed"],
                },
            ),
        }
    )
