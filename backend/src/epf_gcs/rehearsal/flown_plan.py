"""A plan flown from its start to its last waypoint and once around it, as the board's navigation leads through it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Final, Literal, NamedTuple

from epf_gcs.codec.tables import Waypoint
from epf_gcs.earth import GRAVITY_M_S2, M_PER_DEG
from epf_gcs.rehearsal.flight_model import STEP_S, FlightModel, Start, SteadyWind, wrap_180
from epf_gcs.units import mps_from_kt

LONGEST_S: Final = 6 * 3600.0
"""Nothing is flown for longer: a plan that takes more is left where it is."""
SAMPLE_S: Final = 1.0
_STEPS: Final = round(SAMPLE_S / STEP_S)
# A waypoint that comes no nearer in so long, once the turn to it is done, is not reached any more.
_PATIENCE_S: Final = 120.0
_TURN_S: Final = 60.0
_NEARER_M: Final = 10.0
# As `firmware/src/navigation/plan.c` has them.
_CAPTURE_M: Final = 200.0
_CAPTURE_TURNS: Final = 1.5
_HOLD_GAIN: Final = 2.0
_TURN_MPS2: Final = GRAVITY_M_S2 * math.tan(math.radians(30.0))


class Sample(NamedTuple):
    """A second of the flight: on its way to waypoint `row`, or around it."""

    row: int
    latitude_deg: float
    longitude_deg: float
    altitude_ft: float


Left = Literal["too_long", "unreached"]
"""Why a flight ends before its plan does: time, or a waypoint that it comes no nearer to."""


class LegEnd(NamedTuple):
    """When a waypoint was captured. `off_track_deg`: between the track and the bearing to it, not negative."""

    time_s: float
    altitude_ft: float
    off_track_deg: float


@dataclass(slots=True)
class FlownLeg:
    """The way to waypoint `row`, from `begin_deg` (latitude, longitude) and `begin_s` on; `samples` long. `end`: None
    if the waypoint was not reached."""

    row: int
    begin_deg: tuple[float, float]
    begin_s: float
    samples: int = 0
    end: LegEnd | None = None


@dataclass(slots=True)
class FlownPlan:
    """What came of it. `time_s`: until the last waypoint was reached, or the flight was left."""

    samples: list[Sample] = field(default_factory=list)
    legs: list[FlownLeg] = field(default_factory=list)
    time_s: float = 0.0
    left: Left | None = None


def capture_m(speed_kt: float) -> float:
    """Distance, metres, at which the board counts a waypoint as reached at this indicated airspeed."""
    return max(_CAPTURE_M, _CAPTURE_TURNS * mps_from_kt(speed_kt) ** 2 / _TURN_MPS2) if speed_kt > 55.0 else _CAPTURE_M


def start_at_first(waypoints: Sequence[Waypoint]) -> Start:
    """Over the first waypoint on the way to the second, for an aircraft whose place is not known."""
    first, second = waypoints[0], waypoints[min(1, len(waypoints) - 1)]
    north_m, east_m = metres((first.latitude_deg, first.longitude_deg), (second.latitude_deg, second.longitude_deg))
    track_deg = math.degrees(math.atan2(east_m, north_m))
    return Start(first.latitude_deg, first.longitude_deg, first.altitude_ft, track_deg, first.speed_kt)


def metres(origin_deg: tuple[float, float], place_deg: tuple[float, float]) -> tuple[float, float]:
    """North and east of the origin in a plane; places are latitude and longitude."""
    across = math.cos(math.radians((origin_deg[0] + place_deg[0]) / 2.0))
    east_m = wrap_180(place_deg[1] - origin_deg[1]) * M_PER_DEG * across
    return (place_deg[0] - origin_deg[0]) * M_PER_DEG, east_m


def fly(waypoints: Sequence[Waypoint], first: int, start: Start, wind: SteadyWind) -> FlownPlan:
    """Fly the plan from its waypoint `first` on, from this start."""
    model, flown = FlightModel(start, wind), FlownPlan()
    begin_deg = (start.latitude_deg, start.longitude_deg)
    for row, waypoint in enumerate(waypoints[first:], first):
        leg = FlownLeg(row, begin_deg, model.time_s)
        flown.legs.append(leg)
        before = len(flown.samples)
        flown.left = _fly_leg(model, waypoint, leg, flown.samples)
        leg.samples, flown.time_s = len(flown.samples) - before, model.time_s
        if flown.left is not None:
            return flown
        begin_deg = (waypoint.latitude_deg, waypoint.longitude_deg)
    _hold(model, waypoints[-1], len(waypoints) - 1, flown.samples)
    return flown


def _fly_leg(model: FlightModel, waypoint: Waypoint, leg: FlownLeg, samples: list[Sample]) -> Left | None:
    """Fly until the waypoint is captured; else why not."""
    place_deg = (waypoint.latitude_deg, waypoint.longitude_deg)
    look_s, seen_m = model.time_s + _TURN_S, math.inf
    while True:
        north_m, east_m = metres((model.latitude_deg, model.longitude_deg), place_deg)
        distance_m, bearing_deg = math.hypot(north_m, east_m), math.degrees(math.atan2(east_m, north_m))
        if distance_m < capture_m(model.speed_kt):
            leg.end = LegEnd(model.time_s, model.altitude_ft, abs(wrap_180(bearing_deg - model.track_deg)))
            return None
        if model.time_s >= look_s:
            if distance_m > seen_m - _NEARER_M:
                return "unreached"
            look_s, seen_m = look_s + _PATIENCE_S, distance_m
        if model.time_s > LONGEST_S:
            return "too_long"
        _step(model, bearing_deg, waypoint, leg.row, samples)


def _hold(model: FlightModel, waypoint: Waypoint, row: int, samples: list[Sample]) -> None:
    """Circle the last waypoint once, to the right, as the board does."""
    place_deg = (waypoint.latitude_deg, waypoint.longitude_deg)
    radius_m = capture_m(model.speed_kt)
    once_s = 2.0 * math.pi * radius_m / mps_from_kt(model.speed_kt)
    until_s = model.time_s + 1.5 * once_s
    while model.time_s < until_s:
        north_m, east_m = metres((model.latitude_deg, model.longitude_deg), place_deg)
        inwards = math.atan(_HOLD_GAIN * (math.hypot(north_m, east_m) - radius_m) / radius_m)
        course_deg = math.degrees(math.atan2(east_m, north_m) + inwards) - 90.0
        _step(model, course_deg, waypoint, row, samples)


def _step(model: FlightModel, course_deg: float, waypoint: Waypoint, row: int, samples: list[Sample]) -> None:
    if round(model.time_s / STEP_S) % _STEPS == 0:
        samples.append(Sample(row, model.latitude_deg, model.longitude_deg, model.altitude_ft))
    model.step(course_deg, waypoint.altitude_ft, waypoint.speed_kt)
