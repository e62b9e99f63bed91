"""How a flight is measured: the definitions behind every figure that a test, a campaign or the bench states.

A *leg* lasts from the sample in which the plan goes on to a waypoint until it goes on to the next. Its line runs from
the waypoint before (for the first leg: from where the plan was loaded) to its own.

- Cross-track: distance from the leg's line, over every sample of every leg. Nothing is left out, not even the turns.
- `leg`: the same without the first 10 s of each leg, in which the aircraft turns onto it.
- `near`: distance to the nearest point of this leg and the one before, over every sample.
- Settled altitude: altitude above sea level less the leg's, from the first sample of the leg within 30 ft of it until
  the leg ends. So a climb between two altitudes is not an error, a wave after it is.
- Settled airspeed: as the altitude's, from the first sample within 1 kt.
- A waypoint is *reached* where the plan goes on to the next; the last one, where the flight ends near it. It is
  *captured honestly* where the aircraft is within the capture radius and 100 ft of its altitude then.
- Settling time of a step: from the step to the last sample outside the stated band.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Final, TypeVar

import numpy as np

from epf_gcs.codec.tables import Waypoint
from epf_gcs.earth import M_PER_DEG
from epf_gcs.lab.truth import Column, Sample, Truth
from epf_gcs.rehearsal.flown_plan import capture_m

ALTITUDE_BAND_FT: Final = 30.0
SPEED_BAND_KT: Final = 1.0
# The capture radius up to 55 kt, which is what every route ends with, and what the board's 32-bit position leaves open.
REACHED_M: Final = 205.0
# What a capture may be beyond the law's own radius: a frame's way, and the board's position.
_BEYOND_M: Final = 5.0
HONEST_FT: Final = 100.0
TURN_S: Final = 10.0

Place = tuple[float, float]
"""Latitude and longitude, degrees."""

AnySample = TypeVar("AnySample", bound=Sample)


@dataclass(frozen=True, slots=True)
class Distance:
    """Of many distances, in metres."""

    rms_m: float
    p95_m: float
    largest_m: float


@dataclass(frozen=True, slots=True)
class AltitudeError:
    """Of many errors, in feet."""

    rms_ft: float
    p95_ft: float
    largest_ft: float


@dataclass(frozen=True, slots=True)
class SpeedError:
    """Of many errors, in knots."""

    rms_kt: float
    p95_kt: float
    largest_kt: float


@dataclass(frozen=True, slots=True)
class Altitude:
    """How the altitude was kept."""

    settled: AltitudeError


@dataclass(frozen=True, slots=True)
class Airspeed:
    """How the airspeed was kept."""

    settled: SpeedError


@dataclass(frozen=True, slots=True)
class Capture:
    """Where the aircraft was when the plan left a waypoint behind.

    `altitude_error_ft`: too high is positive. `within_m`: where the law may count it as captured at the speed flown.
    """

    waypoint: int
    time_s: float
    distance_m: float
    altitude_error_ft: float
    within_m: float

    @property
    def is_honest(self) -> bool:
        """Whether it was there."""
        return self.distance_m <= self.within_m and abs(self.altitude_error_ft) <= HONEST_FT


@dataclass(frozen=True, slots=True)
class Leg:
    """The flight to one waypoint; its line begins at `begin`."""

    waypoint: Waypoint
    begin: Place
    truth: Truth

    def cross_track_m(self) -> Column:
        """Signed distances from the line, + right of it. A plane is flat enough: legs are a few km long."""
        end_north, end_east = metres(self.begin, self._end)
        north, east = columns_m(self.begin, self.truth)
        distances: Column = (east * end_north - north * end_east) / math.hypot(end_north, end_east)
        return distances

    def settled_cross_track_m(self) -> Column:
        """Without the turn onto the line."""
        is_on_it = self.truth.time_s >= self.truth.time_s[0] + TURN_S
        distances: Column = self.cross_track_m()[is_on_it]
        return distances

    def distance_m(self, truth: Truth) -> Column:
        """From the nearest point of this leg, whichever leg these samples are of."""
        end_north, end_east = metres(self.begin, self._end)
        north, east = columns_m(self.begin, truth)
        along = np.clip((north * end_north + east * end_east) / (end_north**2 + end_east**2), 0.0, 1.0)
        distances: Column = np.hypot(north - along * end_north, east - along * end_east)
        return distances

    def is_reached(self) -> bool:
        """Whether the leg ended as near to its waypoint as the capture."""
        return self.capture(0).distance_m <= REACHED_M

    def capture(self, waypoint: int) -> Capture:
        """Where the leg ended."""
        last = self.truth.part(len(self.truth) - 1, len(self.truth))
        north, east = columns_m(self._end, last)
        error_ft = float(last.altitude_ft[0]) - self.waypoint.altitude_ft
        within_m = capture_m(float(last.airspeed_kt[0])) + _BEYOND_M
        return Capture(waypoint, float(last.time_s[0]), float(np.hypot(north, east)[0]), error_ft, within_m)

    def altitude_errors_ft(self) -> Column:
        """Settled ones."""
        return _from_first(self.truth.altitude_ft - self.waypoint.altitude_ft, ALTITUDE_BAND_FT)

    def speed_errors_kt(self) -> Column:
        """Settled ones."""
        return _from_first(self.truth.airspeed_kt - self.waypoint.speed_kt, SPEED_BAND_KT)

    @property
    def _end(self) -> Place:
        return self.waypoint.latitude_deg, self.waypoint.longitude_deg


@dataclass(frozen=True, slots=True)
class Figures:
    """What a flight of a route comes to, from loading the plan to the capture of its last waypoint. `furthest_at_s`:
    when `near` was largest."""

    waypoints_reached: int
    captures: tuple[Capture, ...]
    time_s: float
    cross_track: Distance
    leg: Distance
    near: Distance
    furthest_at_s: float
    altitude: Altitude
    airspeed: Airspeed

    @property
    def captured_honestly(self) -> int:
        """How many waypoints were left behind only when the aircraft was there."""
        return sum(one.is_honest for one in self.captures)


def measure(truth: Truth, route: Sequence[Waypoint]) -> Figures:
    """Measure a flight. Figures of nothing are NaN, which no limit lets pass."""
    legs = split(truth, route)
    is_last_reached = bool(legs) and legs[-1].is_reached()
    reached = len(legs) - 1 + is_last_reached if legs else 0
    near = list(_near(legs))
    return Figures(
        waypoints_reached=reached,
        captures=tuple(leg.capture(number) for number, leg in enumerate(legs[:reached])),
        time_s=float(truth.time_s[-1] - truth.time_s[0]) if len(truth) else math.nan,
        cross_track=Distance(*_spread([leg.cross_track_m() for leg in legs])),
        leg=Distance(*_spread([leg.settled_cross_track_m() for leg in legs])),
        near=Distance(*_spread(near)),
        furthest_at_s=_at_largest_s([leg.truth for leg in legs], near),
        altitude=Altitude(AltitudeError(*_spread([leg.altitude_errors_ft() for leg in legs]))),
        airspeed=Airspeed(SpeedError(*_spread([leg.speed_errors_kt() for leg in legs]))),
    )


def split(truth: Truth, route: Sequence[Waypoint]) -> list[Leg]:
    """Cut a flight into its legs, in the order of the route; a leg that was not flown ends the list."""
    legs: list[Leg] = []
    begins = np.flatnonzero(truth.waypoint == 0)
    if not len(begins):
        return legs
    first = int(begins[0])
    begin = (float(truth.latitude_deg[first]), float(truth.longitude_deg[first]))
    for index, waypoint in enumerate(route):
        others = np.flatnonzero(truth.waypoint[first:] != index)
        end = first + int(others[0]) if len(others) else len(truth)
        if end == first:
            break
        legs.append(Leg(waypoint, begin, truth.part(first, end)))
        first, begin = end, (waypoint.latitude_deg, waypoint.longitude_deg)
    return legs


class RouteEnd:
    """When a route has been flown: its last waypoint has been captured."""

    def __init__(self, route: Sequence[Waypoint]) -> None:
        self._last = len(route) - 1
        self._place = (route[-1].latitude_deg, route[-1].longitude_deg)
        self._was_on_last = False

    def reached(self, sample: Sample) -> bool:
        """Whether this sample, the next of the flight, ends it."""
        return self.is_at(sample.waypoint, sample.state.latitude_deg, sample.state.longitude_deg)

    def is_at(self, waypoint: int, latitude_deg: float, longitude_deg: float) -> bool:
        """The same, of a sample's values."""
        # A loop goes on to its first waypoint; any other route holds its last one.
        was_on_last, self._was_on_last = self._was_on_last, waypoint == self._last
        if not was_on_last:
            return False
        return not self._was_on_last or math.hypot(*metres(self._place, (latitude_deg, longitude_deg))) <= REACHED_M


def settling_s(samples: Sequence[AnySample], error: Callable[[AnySample], float], band: float) -> float:
    """Time from the first sample to the last one whose error is outside the band."""
    outside = [sample.time_s for sample in samples if abs(error(sample)) > band]
    return outside[-1] - samples[0].time_s if outside else 0.0


def rms(values: Sequence[float] | Column) -> float:
    """Root of the mean square; NaN of nothing, which no limit lets pass."""
    return math.sqrt(float(np.mean(np.square(values)))) if len(values) else math.nan


def percentile(values: Sequence[float] | Column, share: float) -> float:
    """Size that this share of the values does not exceed; NaN of nothing."""
    return float(np.sort(np.abs(values))[math.ceil(share * len(values)) - 1]) if len(values) else math.nan


def metres(origin: Place, place: Place) -> Place:
    """North and east of the origin."""
    shrink = math.cos(math.radians(origin[0]))
    return (place[0] - origin[0]) * M_PER_DEG, (place[1] - origin[1]) * M_PER_DEG * shrink


def columns_m(origin: Place, truth: Truth) -> tuple[Column, Column]:
    """North and east of the origin, of each sample."""
    shrink = math.cos(math.radians(origin[0]))
    north = (truth.latitude_deg - origin[0]) * M_PER_DEG
    return north, (truth.longitude_deg - origin[1]) * (M_PER_DEG * shrink)


def _near(legs: Sequence[Leg]) -> Iterator[Column]:
    for number, leg in enumerate(legs):
        here = leg.distance_m(leg.truth)
        yield here if number == 0 else np.minimum(here, legs[number - 1].distance_m(leg.truth))


def _spread(parts: Sequence[Column]) -> tuple[float, float, float]:
    values = np.concatenate(parts) if parts else np.empty(0)
    return rms(values), percentile(values, 0.95), percentile(values, 1.0)


def _at_largest_s(parts: Sequence[Truth], values: Sequence[Column]) -> float:
    if not parts:
        return math.nan
    times = np.concatenate([part.time_s for part in parts])
    return float(times[int(np.argmax(np.concatenate(values)))])


def _from_first(errors: Column, band: float) -> Column:
    inside = np.flatnonzero(np.abs(errors) <= band)
    return errors[int(inside[0]) :] if len(inside) else errors[:0]
