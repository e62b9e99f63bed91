"""Flights of JSBSim under the board's own code whose targets are stepped: what was flown, read from the simulator's own
states, beside what the flight report reads from the recording.

The states are neither smoothed nor decoded. A step lasts until any target is stepped again. Roll and pitch are stepped
by the laws themselves; the board does not send what they ask for, so no report can judge them.
"""

from __future__ import annotations

import math
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final, NamedTuple

import numpy as np

from board_tests.closed_loop.recorded_flight import RecordedLoop
from epf_gcs.contract.report import ReportManoeuvre
from epf_gcs.earth import M_PER_DEG
from epf_gcs.flights.report.making import make
from epf_gcs.lab.closed_loop import Sample
from epf_gcs.recordings.places import Places
from epf_gcs.simulator.simulation import SimulationOptions
from epf_gcs.simulator.situation import RUNWAY_HEADING_DEG, Situation, Turbulence, Wind

WITHIN: Final = 0.05
"""The share by which a figure may be off: rise time of itself, overshoot and settled error of the step."""

_HIL_PLAN: Final = 1
_SETTLE_S: Final = 30.0
_SHORTEST_S, _LONGEST_S = 25.0, 80.0
# So far away that the bearing hardly drifts.
_FAR_M: Final = 60_000.0
_LEVEL: Final = {"altitude": 1000.0, "heading": RUNWAY_HEADING_DEG, "speed": 55.0}
_SIZES: Final = {"altitude": (60.0, 300.0), "heading": (20.0, 120.0), "speed": (4.0, 9.0)}
_REACH: Final = {"altitude": (400.0, 2000.0), "heading": (-1e9, 1e9), "speed": (45.0, 70.0)}
_KINDS: Final = {
    "altitude": ("climb", "descent"),
    "heading": ("turn_right", "turn_left"),
    "speed": ("faster", "slower"),
}
# So much beyond the target must be told.
_OWED_PERCENT: Final = 0.5
# The gains of each loop and the factors within which they are changed: from sluggish to well beyond what one would fly.
_GAINS: Final[dict[str, tuple[float, float, float]]] = {
    "k_altura": (0.06, 0.5, 2.5),
    "k_int_altura": (0.06, 0.3, 3.0),
    "k_heading": (0.8, 0.5, 2.0),
    "k_div_velocidad": (700, 0.4, 2.0),
    "k_pitch": (2.0, 0.7, 1.5),
    "k_roll": (2.0, 0.6, 1.5),
}


class Flown(NamedTuple):
    """One answer as the simulator flew it; None for what was not flown. `settled_error` has the unit of the signal.

    `is_gust`: gusts, which are a part of the airspeed, moved it as much as the loop did.
    """

    kind: str
    at_s: float
    size: float
    rise_s: float | None
    overshoot_percent: float
    settled_error: float
    is_gust: bool = False


@dataclass(frozen=True, slots=True)
class SteppedFlight:
    """What was flown and what the report found, in order of time."""

    flown: list[Flown]
    found: list[ReportManoeuvre]

    def pairs(self) -> Iterator[tuple[Flown, ReportManoeuvre]]:
        """What was found rightly: of the same kind, within a second."""
        for one in self.flown:
            yield from ((one, other) for other in self.found if _is_same(one, other))


def fly(seed: int, steps: int = 5) -> SteppedFlight:
    """Settle, then step one target after the other, some two at a time; gains, sizes, order and air are the seed's."""
    rng = np.random.default_rng(seed)
    situation = Situation(seed=seed)
    if seed % 3 == 1:
        situation = Situation(wind=Wind(float(rng.uniform(0, 360)), float(rng.uniform(3, 15))), seed=seed)
    elif seed % 3 == 2:
        situation = Situation(turbulence=Turbulence.LIGHT, seed=seed)
    is_rough = situation.turbulence is not Turbulence.NONE
    flown: list[Flown] = []
    with RecordedLoop(SimulationOptions(situation=situation)) as loop:
        for name, (usual, low, high) in _GAINS.items():
            value = usual * float(np.exp(rng.uniform(np.log(low), np.log(high))))
            loop.command(f"set_{name}", round(value) if isinstance(usual, int) else value)
        targets = [dict(_LEVEL), *_targets(rng, steps)]
        places = _upload(loop, targets)
        loop.command("autopilot_on")
        loop.fly(_SETTLE_S)
        for index in range(1, len(targets)):
            before = loop.samples[-1]
            loop.command("go_to_waypoint", _HIL_PLAN, index)
            part = [before, *loop.fly(float(rng.uniform(_SHORTEST_S, _LONGEST_S)))]
            changed = [name for name in _LEVEL if targets[index][name] != targets[index - 1][name]]
            answers = [_measured(name, part, targets[index][name], places[index]) for name in changed]
            flown += [one._replace(is_gust=is_rough and one.kind in _KINDS["speed"]) for one in answers]
        assert loop.crashes == []
        with tempfile.TemporaryDirectory() as folder:
            recording = loop.write(Path(folder))
            report = make(recording, Places(Path(folder)).made_of(recording.stem))
    return SteppedFlight(flown, [one for one in report.manoeuvres if one.kind != "leg"])


def _targets(rng: np.random.Generator, steps: int) -> Iterator[dict[str, float]]:
    now = dict(_LEVEL)
    for number in range(steps):
        names = [list(_LEVEL)[number % 3], *([str(rng.choice(list(_LEVEL)))] if rng.uniform() < 0.25 else [])]
        for name in dict.fromkeys(names):
            size = float(rng.uniform(*_SIZES[name])) * float(rng.choice((-1.0, 1.0)))
            low, high = _REACH[name]
            now[name] += size if low <= now[name] + size <= high else -size
        yield dict(now)


def _upload(loop: RecordedLoop, targets: Sequence[dict[str, float]]) -> list[tuple[float, float]]:
    """Give the board a plan with a waypoint far away for each set of targets; returns their places."""
    start = loop.simulation.state
    shrink = math.cos(math.radians(start.latitude_deg))
    places = []
    loop.command("mission_begin", _HIL_PLAN, len(targets))
    for index, one in enumerate(targets):
        course = math.radians(one["heading"])
        place = (
            start.latitude_deg + _FAR_M * math.cos(course) / M_PER_DEG,
            start.longitude_deg + _FAR_M * math.sin(course) / (M_PER_DEG * shrink),
        )
        loop.command("mission_item", _HIL_PLAN, index, *place, one["altitude"], one["speed"])
        places.append(place)
    loop.command("mission_commit", _HIL_PLAN)
    return places


def _measured(loop: str, samples: Sequence[Sample], target: float, place: tuple[float, float]) -> Flown:
    """When 10 and 90 % of the step were first reached, the peak, and the mean of what is left in the last eighth."""
    if loop == "heading":
        rest = np.array([_turn_left_deg(sample, place) for sample in samples])
    else:
        field = {"altitude": "altitude_ft", "speed": "airspeed_indicated_kt"}[loop]
        rest = np.array([target - getattr(sample.state, field) for sample in samples])
    share = 1.0 - rest / rest[0]
    t_s = np.array([sample.time_s for sample in samples])
    reached = [float(t_s[np.argmax(share >= level)]) if (share >= level).any() else None for level in (0.1, 0.9)]
    return Flown(
        _KINDS[loop][0 if rest[0] > 0 else 1],
        float(t_s[0]),
        float(rest[0]),
        None if reached[0] is None or reached[1] is None else reached[1] - reached[0],
        100.0 * max(0.0, float(share.max()) - 1.0),
        float(rest[t_s >= t_s[0] + 0.875 * (t_s[-1] - t_s[0])].mean()),
    )


def _turn_left_deg(sample: Sample, place: tuple[float, float]) -> float:
    """Bearing to the place less the track: what is left of the turn, to the right positive."""
    state = sample.state
    latitude, to = math.radians(state.latitude_deg), math.radians(place[0])
    east = math.radians(place[1] - state.longitude_deg)
    bearing = math.atan2(
        math.sin(east) * math.cos(to),
        math.cos(latitude) * math.sin(to) - math.sin(latitude) * math.cos(to) * math.cos(east),
    )
    return (math.degrees(bearing) - state.track_deg + 180.0) % 360.0 - 180.0


def _is_same(one: Flown, other: ReportManoeuvre) -> bool:
    return one.kind == other.kind and abs(one.at_s - other.at_s) <= 1.0


def f1_of(flights: Sequence[SteppedFlight]) -> float:
    """How well the steps were found: the harmonic mean of precision and recall."""
    right = sum(len(list(flight.pairs())) for flight in flights)
    return 2 * right / sum(len(flight.flown) + len(flight.found) for flight in flights)


def errors(flights: Sequence[SteppedFlight], *, is_gust: bool = False) -> dict[str, list[float]]:
    """How far each figure of the report is off what was flown; infinite for one that it owes, or that nobody flew."""
    found: dict[str, list[float]] = {"rise time": [], "overshoot": [], "settled error": []}
    for flown, told in (pair for flight in flights for pair in flight.pairs() if pair[0].is_gust == is_gust):
        if flown.rise_s is not None or told.rise_s is not None:
            found["rise time"].append(abs((told.rise_s or math.inf) / (flown.rise_s or math.inf) - 1.0))
        if told.overshoot_percent is not None or flown.overshoot_percent > _OWED_PERCENT:
            over = math.inf if told.overshoot_percent is None else told.overshoot_percent
            found["overshoot"].append(abs(over - flown.overshoot_percent) / 100.0)
        if told.steady_error is not None:
            found["settled error"].append(abs((told.steady_error - flown.settled_error) / flown.size))
    return found
