"""How a flight is measured: the definitions behind every figure that a test or the bench states.

A *leg* lasts from the sample in which the plan goes on to a waypoint until it goes on to the next. Its
line runs from the waypoint before (for the first leg: from where the plan was loaded) to its own.

- Steady altitude error: altitude above sea level less the leg's, from the first sample of the leg within
  30 ft of it until the leg ends. So a climb between two altitudes is not an error, a wave after it is.
- Cross-track: distance from the leg's line, over every sample of every leg. Nothing is left out, not even
  the turns: the whole circuit has to stay near its lines.
- Steady airspeed error: as the altitude's, from the first sample within 1 kt.
- Settling time of a step: from the step to the last sample outside the stated band.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final, Protocol, TypeVar

from epf_gcs.codec.tables import Waypoint

ALTITUDE_BAND_FT: Final = 30.0
SPEED_BAND_KT: Final = 1.0
# The capture radius up to 55 kt, which is what every route ends with, and what the board's 32-bit position leaves open.
REACHED_M: Final = 205.0

_METRES_PER_DEGREE: Final = 111_195.0


class State(Protocol):
    """What of the aircraft is measured: degrees, feet above sea level, indicated knots."""

    @property
    def latitude_deg(self) -> float: ...
    @property
    def longitude_deg(self) -> float: ...
    @property
    def altitude_ft(self) -> float: ...
    @property
    def airspeed_indicated_kt(self) -> float: ...


class Sample(Protocol):
    """One instant of a flight, from whatever flew it."""

    @property
    def time_s(self) -> float: ...
    @property
    def state(self) -> State: ...
    @property
    def waypoint(self) -> int:
        """From 0; -1 without a plan."""


AnySample = TypeVar("AnySample", bound=Sample)


@dataclass(frozen=True, slots=True)
class Leg:
    """The flight to one waypoint."""

    waypoint: Waypoint
    begin: tuple[float, float]  # latitude and longitude [deg] the line begins at
    samples: Sequence[Sample]

    def cross_track_m(self) -> list[float]:
        """Signed distances from the line, + right of it. A plane is flat enough: legs are a few km long."""
        end_north, end_east = _metres(self.begin, (self.waypoint.latitude_deg, self.waypoint.longitude_deg))
        length = math.hypot(end_north, end_east)
        distances = []
        for sample in self.samples:
            north, east = _metres(self.begin, (sample.state.latitude_deg, sample.state.longitude_deg))
            distances.append((east * end_north - north * end_east) / length)
        return distances

    def is_reached(self) -> bool:
        """Whether the leg ended as near to its waypoint as the capture."""
        return is_near(self.samples[-1], self.waypoint)

    def altitude_errors_ft(self) -> list[float]:
        """Steady ones."""
        errors = [sample.state.altitude_ft - self.waypoint.altitude_ft for sample in self.samples]
        return _from_first(errors, lambda error: abs(error) <= ALTITUDE_BAND_FT)

    def speed_errors_kt(self) -> list[float]:
        """Steady ones."""
        errors = [sample.state.airspeed_indicated_kt - self.waypoint.speed_kt for sample in self.samples]
        return _from_first(errors, lambda error: abs(error) <= SPEED_BAND_KT)


@dataclass(frozen=True, slots=True)
class Figures:
    """What a flight of a route comes to."""

    waypoints_reached: int
    time_s: float
    altitude_rms_ft: float
    altitude_p95_ft: float
    cross_track_rms_m: float
    speed_rms_kt: float


def measure(samples: Sequence[Sample], route: Sequence[Waypoint]) -> Figures:
    """Measure a flight from loading the plan to the capture of its last waypoint.

    A waypoint is reached where the plan goes on to the next; the last one, where the flight ends near it.
    """
    legs = split(samples, route)
    altitude = [error for leg in legs for error in leg.altitude_errors_ft()]
    cross_track = [distance for leg in legs for distance in leg.cross_track_m()]
    speed = [error for leg in legs for error in leg.speed_errors_kt()]
    return Figures(
        waypoints_reached=len(legs) - 1 + legs[-1].is_reached(),
        time_s=samples[-1].time_s - samples[0].time_s,
        altitude_rms_ft=rms(altitude),
        altitude_p95_ft=percentile(altitude, 0.95),
        cross_track_rms_m=rms(cross_track),
        speed_rms_kt=rms(speed),
    )


def split(samples: Sequence[Sample], route: Sequence[Waypoint]) -> list[Leg]:
    """Cut a flight into its legs, in the order of the route; a leg that was not flown ends the list."""
    legs: list[Leg] = []
    first = next(number for number, sample in enumerate(samples) if sample.waypoint == 0)
    begin = (samples[first].state.latitude_deg, samples[first].state.longitude_deg)
    for index, waypoint in enumerate(route):
        last = first
        while last < len(samples) and samples[last].waypoint == index:
            last += 1
        if last == first:
            break
        legs.append(Leg(waypoint, begin, samples[first:last]))
        first, begin = last, (waypoint.latitude_deg, waypoint.longitude_deg)
    return legs


def is_near(sample: Sample, waypoint: Waypoint) -> bool:
    """Whether the aircraft is as near to the waypoint as its capture."""
    place = (waypoint.latitude_deg, waypoint.longitude_deg)
    return math.hypot(*_metres(place, (sample.state.latitude_deg, sample.state.longitude_deg))) <= REACHED_M


class RouteEnd:
    """When a route has been flown: its last waypoint has been captured."""

    def __init__(self, route: Sequence[Waypoint]) -> None:
        self._route = route
        self._was_on_last = False

    def reached(self, sample: Sample) -> bool:
        """Whether this sample, the next of the flight, ends it."""
        last = len(self._route) - 1
        # A loop goes on to its first waypoint; any other route holds its last one.
        is_end = self._was_on_last and (sample.waypoint != last or is_near(sample, self._route[last]))
        self._was_on_last = sample.waypoint == last
        return is_end


def settling_s(samples: Sequence[AnySample], error: Callable[[AnySample], float], band: float) -> float:
    """Time from the first sample to the last one whose error is outside the band."""
    outside = [sample.time_s for sample in samples if abs(error(sample)) > band]
    return outside[-1] - samples[0].time_s if outside else 0.0


def rms(values: Sequence[float]) -> float:
    """Root of the mean square; NaN of nothing, which no limit lets pass."""
    return math.sqrt(sum(value * value for value in values) / len(values)) if values else math.nan


def percentile(values: Sequence[float], share: float) -> float:
    """Size that this share of the values does not exceed; NaN of nothing."""
    return sorted(abs(value) for value in values)[math.ceil(share * len(values)) - 1] if values else math.nan


def _from_first(values: list[float], good: Callable[[float], bool]) -> list[float]:
    first = next((number for number, value in enumerate(values) if good(value)), len(values))
    return values[first:]


def _metres(origin: tuple[float, float], place: tuple[float, float]) -> tuple[float, float]:
    """North and east of the origin."""
    north_m = (place[0] - origin[0]) * _METRES_PER_DEGREE
    east_m = (place[1] - origin[1]) * _METRES_PER_DEGREE * math.cos(math.radians(origin[0]))
    return north_m, east_m
