"""The present track of an aircraft, from its last positions: speed over the ground, climb, turn, and the wind.

Everything is measured from the positions alone, so that it works with every board. Pure; told the time.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, NamedTuple

import numpy as np
import numpy.typing as npt

from epf_gcs.earth import M_PER_DEG

_KEPT_S: Final = 90.0
# Fixes nearer together than this are thinned: more of them measure nothing better.
_APART_S: Final = 0.18
# Positions over this time make one velocity where the receiver measures none.
_BASE_S: Final = 1.0
_SPEED_S: Final = 1.5
_STRAIGHT_S: Final = 6.0
_SHORT_S: Final = 4.0


class Span(NamedTuple):
    """The last so many seconds, over which a line is laid. It counts while its slope is nearly that of the next shorter
    span, by `same`; what is less than `nothing` cannot be told from no slope."""

    for_s: float
    same: float
    nothing: float = 0.0


# A turn and a climb are measured over the longest time in which they were steady: gusts and the pilot's hand disturb
# the mean of a long time little. After a change only the shortest counts. Turns are compared by their sideways
# acceleration in m/s2: the same gust turns a slow aircraft's track more.
_TURN_SPANS: Final = (
    Span(_SHORT_S, math.inf, 0.5),
    Span(10.0, 0.8, 0.5),
    Span(20.0, 0.32, 0.26),
    Span(40.0, 0.16, 0.16),
)
# Lift and sink of gusty air are a climb of 1 m/s for some seconds: only a greater change counts at once.
_CLIMB_SPANS: Final = (Span(_SHORT_S, math.inf), Span(8.0, 2.0), Span(16.0, 0.6), Span(32.0, 0.3))
# What was followed for less time is believed in part.
_SETTLED_S: Final = 8.0
_LONG_S: Final = 10.0
_LONGEST_S: Final = 40.0
_LEAST_S: Final = 2.5
# A receiver that was silent for longer may have flown anything meanwhile.
_GAP_S: Final = 2.0
# A jump in the position (another flight, another aircraft) is no flight.
_FASTEST_MPS: Final = 350.0
_STEEPEST_BANK_RAD: Final = math.radians(50.0)
_G_MPS2: Final = 9.81
# The velocities must spread at least by this share of the speed across their main direction to show the wind.
_SPREAD: Final = 0.15
_STRONGEST_WIND: Final = 0.8
_WIND_LASTS_S: Final = 600.0
_SLOWEST_MPS: Final = 3.0

Vector = npt.NDArray[np.float64]


class Fix(NamedTuple):
    """A position; altitude above the sea. The velocity over the ground, as the receiver measured it, or None."""

    t_s: float
    latitude_deg: float
    longitude_deg: float
    altitude_m: float
    east_mps: float | None = None
    north_mps: float | None = None


class Velocity(NamedTuple):
    """Over the ground."""

    t_s: float
    east_mps: float
    north_mps: float


@dataclass(frozen=True, slots=True)
class Motion:
    """Where the aircraft is at `t_s` and how it moves. `turn_rad_s`: positive turns right. The wind is where it blows
    to; 0 while it is not known, which matters only in a turn."""

    t_s: float
    latitude_deg: float
    longitude_deg: float
    altitude_m: float
    east_mps: float
    north_mps: float
    climb_mps: float = 0.0
    turn_rad_s: float = 0.0
    wind_east_mps: float = 0.0
    wind_north_mps: float = 0.0

    @property
    def speed_mps(self) -> float:
        """Over the ground."""
        return math.hypot(self.east_mps, self.north_mps)


class MotionEstimate:
    """Gathers the fixes of one aircraft."""

    def __init__(self) -> None:
        self._fixes: deque[Fix] = deque()
        self._velocities: deque[Velocity] = deque()
        self._wind = (0.0, 0.0)
        self._wind_s = -math.inf

    def add(self, fix: Fix) -> None:
        """Take the newest fix. One that does not follow from the last begins anew."""
        last = self._fixes[-1] if self._fixes else None
        if last is not None:
            apart_s = fix.t_s - last.t_s
            if 0.0 <= apart_s < _APART_S:
                return
            if not 0.0 < apart_s <= _GAP_S or math.hypot(*_metres(last, fix)) > _FASTEST_MPS * apart_s:
                self.forget()
        self._fixes.append(fix)
        velocity = self._velocity(fix)
        if velocity is not None:
            self._velocities.append(velocity)
        while fix.t_s - self._fixes[0].t_s > _KEPT_S:
            self._fixes.popleft()
        while self._velocities and fix.t_s - self._velocities[0].t_s > _KEPT_S:
            self._velocities.popleft()

    def forget(self) -> None:
        """Begin anew; the wind stays."""
        self._fixes.clear()
        self._velocities.clear()

    @property
    def newest(self) -> Fix | None:
        """The last fix."""
        return self._fixes[-1] if self._fixes else None

    def now(self) -> Motion | None:
        """The motion at the newest fix; None until it was followed for some seconds."""
        if not self._fixes or self._fixes[-1].t_s - self._fixes[0].t_s < _LEAST_S or not self._velocities:
            return None
        newest = self._fixes[-1]
        self._measure_wind(newest.t_s)
        wind_east_mps, wind_north_mps = self._wind if newest.t_s - self._wind_s <= _WIND_LASTS_S else (0.0, 0.0)
        recent = np.array(self._since(newest.t_s - _LONGEST_S))
        times_s = recent[:, 0] - newest.t_s
        air_east, air_north = recent[:, 1] - wind_east_mps, recent[:, 2] - wind_north_mps
        airspeed_mps = float(np.hypot(air_east, air_north)[times_s >= -_LONG_S].mean())
        turn_rad_s = _turn(times_s, air_east, air_north, airspeed_mps)
        east_mps, north_mps = _turned_to_now(times_s, air_east, air_north, turn_rad_s)
        altitude_m, climb_mps = self._climb(newest)
        return Motion(
            newest.t_s,
            newest.latitude_deg,
            newest.longitude_deg,
            altitude_m,
            east_mps + wind_east_mps,
            north_mps + wind_north_mps,
            climb_mps,
            turn_rad_s,
            wind_east_mps,
            wind_north_mps,
        )

    def _since(self, from_s: float) -> list[Velocity]:
        found = [one for one in self._velocities if one.t_s >= from_s]
        return found or [self._velocities[-1]]

    def _velocity(self, fix: Fix) -> Velocity | None:
        if fix.east_mps is not None and fix.north_mps is not None:
            return Velocity(fix.t_s, fix.east_mps, fix.north_mps)
        for before in reversed(self._fixes):
            base_s = fix.t_s - before.t_s
            if base_s >= _BASE_S:
                east_m, north_m = _metres(before, fix)
                return Velocity(fix.t_s - base_s / 2, east_m / base_s, north_m / base_s)
        return None

    def _climb(self, newest: Fix) -> tuple[float, float]:
        """Altitude at the newest fix and climb, by the line through the last altitudes."""
        recent = [(one.t_s - newest.t_s, one.altitude_m) for one in self._fixes if newest.t_s - one.t_s <= _LONGEST_S]
        times_s, altitudes_m = np.array(recent).T
        climb_mps = _steady_slope(times_s, altitudes_m, _CLIMB_SPANS)
        is_last = times_s >= -_SHORT_S
        return float(altitudes_m[is_last].mean() - climb_mps * times_s[is_last].mean()), climb_mps

    def _measure_wind(self, now_s: float) -> None:
        """In still air all velocities of a turn lie on a circle about 0; the wind moves its centre."""
        velocities = np.array(self._velocities)[::3, 1:]
        if len(velocities) < 10:
            return
        centred = velocities - velocities.mean(axis=0)
        least_mps = math.sqrt(max(0.0, float(np.linalg.eigvalsh(centred.T @ centred / len(centred))[0])))
        columns = np.column_stack([2.0 * velocities, np.ones(len(velocities))])
        found, *_ = np.linalg.lstsq(columns, (velocities**2).sum(axis=1), rcond=None)
        wind_mps = math.hypot(found[0], found[1])
        airspeed_mps = math.sqrt(max(0.0, float(found[2]) + wind_mps**2))
        if least_mps > _SPREAD * airspeed_mps and wind_mps < _STRONGEST_WIND * airspeed_mps:
            self._wind = (float(found[0]), float(found[1]))
            self._wind_s = now_s


def _metres(one: Fix, other: Fix) -> tuple[float, float]:
    """East and north from one fix to the other."""
    east_deg = (other.longitude_deg - one.longitude_deg + 180.0) % 360.0 - 180.0
    across = math.cos(math.radians(other.latitude_deg))
    return east_deg * M_PER_DEG * across, (other.latitude_deg - one.latitude_deg) * M_PER_DEG


def _turn(times_s: Vector, east: Vector, north: Vector, airspeed_mps: float) -> float:
    """Rate of turn through the air, at most what a steep bank turns; 0 for straight flight."""
    if airspeed_mps < _SLOWEST_MPS or len(times_s) < 3:
        return 0.0
    sideways_mps = np.unwrap(np.arctan2(east, north)) * airspeed_mps
    turn_rad_s = _steady_slope(times_s, sideways_mps, _TURN_SPANS) / airspeed_mps
    fastest = _G_MPS2 * math.tan(_STEEPEST_BANK_RAD) / airspeed_mps
    return max(-fastest, min(fastest, turn_rad_s))


def _turned_to_now(times_s: Vector, east: Vector, north: Vector, turn_rad_s: float) -> tuple[float, float]:
    """The mean of the last velocities through the air, each turned on to the present."""
    is_last = times_s >= times_s[-1] - (_STRAIGHT_S if turn_rad_s == 0.0 else _SPEED_S)
    angle = -turn_rad_s * times_s[is_last]
    now_east = east[is_last] * np.cos(angle) + north[is_last] * np.sin(angle)
    now_north = north[is_last] * np.cos(angle) - east[is_last] * np.sin(angle)
    return float(now_east.mean()), float(now_north.mean())


def _steady_slope(times_s: Vector, values: Vector, spans: Sequence[Span]) -> float:
    """Of the longest span in which it did not change; 0 where that is too little to be told."""
    found = 0.0
    counts = spans[0]
    for span in spans:
        if span is not spans[0] and times_s[0] > -0.9 * span.for_s:
            break
        is_in = times_s >= -span.for_s
        slope = _slope(times_s[is_in], values[is_in])
        if span is not spans[0] and abs(slope - found) >= span.same:
            break
        found, counts = slope, span
    return 0.0 if abs(found) < counts.nothing else found * min(1.0, -float(times_s[0]) / _SETTLED_S)


def _slope(times_s: Vector, values: Vector) -> float:
    """Of the line of least squares."""
    centred_s = times_s - times_s.mean()
    spread = float(centred_s @ centred_s)
    return 0.0 if spread < 1e-6 else float(centred_s @ values) / spread
