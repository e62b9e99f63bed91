"""Made flights over ground and fences: an aircraft with bank, lag and airspeed in wind and gusts, flown by a pilot who
is not steady, seen by a GPS receiver with its errors. Nothing of it is shared with what predicts the path.
"""

from __future__ import annotations

import math
import random
import struct
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from epf_gcs.surroundings.motion import Fix

STEP_S = 0.1
_FIX_EVERY = 2
_LATENCY_STEPS = 2
_G = 9.81
_EARTH_M_PER_DEG = 111_195.0
FREE_S = 34.0
"""An encounter counts when the pilot has flown as he does for so long before it: 30 s, and the time to roll in and to
be measured. Nobody can be warned of a turn that was not begun."""

TrueHeight = Callable[[float, float], float]
"""Metres above the sea at latitude and longitude; NaN: nobody knows."""


@dataclass(frozen=True)
class Leg:
    """What the pilot wants for a time: this bank (0: hold the heading) and to keep to this climb."""

    for_s: float
    bank_rad: float
    climb_mps: float


@dataclass(frozen=True)
class Weather:
    """Wind to where it blows, and how gusty it is (standard deviations)."""

    east_mps: float
    north_mps: float
    gust_mps: float
    lift_mps: float


@dataclass
class Flown:
    """A flight: true places ten times a second, and the fixes that the station got, by their time."""

    latitude_deg: list[float] = field(default_factory=list)
    longitude_deg: list[float] = field(default_factory=list)
    altitude_m: list[float] = field(default_factory=list)
    fixes: list[Fix] = field(default_factory=list)
    begun_s: list[float] = field(default_factory=list)
    """When the pilot began each leg."""

    def begun_before(self, t_s: float) -> float:
        """When the leg that is flown at `t_s` began."""
        return max(one for one in self.begun_s if one <= t_s)


class _Wander:
    """A value that wanders about 0 and comes back."""

    def __init__(self, chance: random.Random, deviation: float, lasts_s: float) -> None:
        self._chance, self._deviation = chance, deviation
        self._keep = math.exp(-STEP_S / lasts_s)
        self.value = chance.gauss(0.0, deviation)

    def step(self) -> float:
        fresh = self._chance.gauss(0.0, self._deviation * math.sqrt(1.0 - self._keep**2))
        self.value = self.value * self._keep + fresh
        return self.value


def fly(
    seed: int,
    place_deg: tuple[float, float],
    altitude_m: float,
    heading_rad: float,
    airspeed_mps: float,
    legs: Sequence[Leg],
    weather: Weather,
    *,
    has_velocity: bool = True,
) -> Flown:
    """Fly these legs. The seed decides gusts, pilot and receiver, so that a longer last leg begins the same."""
    chance, seen = random.Random(seed), random.Random(seed + 1)
    flown = Flown()
    latitude_deg, longitude_deg = place_deg
    across = math.cos(math.radians(latitude_deg))
    bank = climb_mps = 0.0
    gust_east = _Wander(chance, weather.gust_mps, 5.0)
    gust_north = _Wander(chance, weather.gust_mps, 5.0)
    lift = _Wander(chance, weather.lift_mps, 3.0)
    hand = _Wander(chance, math.radians(2.0), 3.0)
    power = _Wander(chance, 1.0, 10.0)
    receiver = _Receiver(seen, has_velocity=has_velocity)
    time_s = 0.0
    for leg in legs:
        flown.begun_s.append(time_s)
        wanted_rad, wanted_m = heading_rad, altitude_m
        for _ in range(round(leg.for_s / STEP_S)):
            wanted_bank = leg.bank_rad
            if leg.bank_rad == 0.0:
                off = (wanted_rad - heading_rad + math.pi) % (2 * math.pi) - math.pi
                wanted_bank = max(-0.4, min(0.4, 1.2 * off))
            bank += max(-0.06, min(0.06, (wanted_bank + hand.step() - bank) * STEP_S / 0.5))
            speed_mps = airspeed_mps + power.step()
            heading_rad += _G * math.tan(bank) / speed_mps * STEP_S
            wanted_m += leg.climb_mps * STEP_S
            wanted_mps = leg.climb_mps + max(-1.5, min(1.5, 0.12 * (wanted_m - altitude_m)))
            climb_mps += (wanted_mps - climb_mps) * STEP_S / 1.5
            east_mps = speed_mps * math.sin(heading_rad) + weather.east_mps + gust_east.step()
            north_mps = speed_mps * math.cos(heading_rad) + weather.north_mps + gust_north.step()
            up_mps = climb_mps + lift.step()
            longitude_deg += east_mps * STEP_S / _EARTH_M_PER_DEG / across
            latitude_deg += north_mps * STEP_S / _EARTH_M_PER_DEG
            altitude_m += up_mps * STEP_S
            time_s += STEP_S
            flown.latitude_deg.append(latitude_deg)
            flown.longitude_deg.append(longitude_deg)
            flown.altitude_m.append(altitude_m)
            fix = receiver.step(time_s, latitude_deg, longitude_deg, altitude_m, east_mps, north_mps)
            if fix is not None:
                flown.fixes.append(fix)
    return flown


class _Receiver:
    """Five fixes a second, late, with errors that wander, in the board's single precision."""

    def __init__(self, chance: random.Random, *, has_velocity: bool) -> None:
        self._chance = chance
        self._has_velocity = has_velocity
        self._off = [_Wander(chance, 1.5, 60.0), _Wander(chance, 1.5, 60.0), _Wander(chance, 3.0, 60.0)]
        self._steps = 0

    def step(
        self, time_s: float, latitude_deg: float, longitude_deg: float, altitude_m: float, east: float, north: float
    ) -> Fix | None:
        self._steps += 1
        off_m = [one.step() + self._chance.gauss(0.0, 0.3) for one in self._off]
        if self._steps % _FIX_EVERY:
            return None
        across = math.cos(math.radians(latitude_deg))
        place = (
            _single(latitude_deg + off_m[0] / _EARTH_M_PER_DEG),
            _single(longitude_deg + off_m[1] / _EARTH_M_PER_DEG / across),
            _single(altitude_m + off_m[2]),
        )
        late_s = time_s + _LATENCY_STEPS * STEP_S
        if not self._has_velocity:
            return Fix(late_s, *place)
        return Fix(late_s, *place, east + self._chance.gauss(0.0, 0.15), north + self._chance.gauss(0.0, 0.15))


def _single(value: float) -> float:
    return float(struct.unpack("<f", struct.pack("<f", value))[0])


def least_clearance(flown: Flown, height: TrueHeight) -> list[float]:
    """The true clearance above the ground every tenth of a second; NaN where nobody knows the ground."""
    return [
        altitude_m - height(north, east)
        for north, east, altitude_m in zip(flown.latitude_deg, flown.longitude_deg, flown.altitude_m, strict=True)
    ]


def weather(chance: random.Random) -> Weather:
    """Any wind up to 10 m/s, calm to gusty."""
    strength, towards = 10.0 * chance.random() ** 0.7, chance.uniform(0.0, 2 * math.pi)
    gust = 0.4 + 0.12 * strength * chance.random()
    return Weather(strength * math.sin(towards), strength * math.cos(towards), gust, 0.6 * gust)


def border_clearance(flown: Flown, corners_deg: Sequence[tuple[float, float]]) -> list[float]:
    """Metres to the border every tenth of a second, positive inside: by the angles under which the corners are seen."""
    north0, east0 = corners_deg[0]
    across = math.cos(math.radians(north0))
    border = [((e - east0) * _EARTH_M_PER_DEG * across, (n - north0) * _EARTH_M_PER_DEG) for n, e in corners_deg]
    found = []
    for north, east in zip(flown.latitude_deg, flown.longitude_deg, strict=True):
        x, y = (east - east0) * _EARTH_M_PER_DEG * across, (north - north0) * _EARTH_M_PER_DEG
        turned, nearest = 0.0, math.inf
        for (ax, ay), (bx, by) in zip(border, [*border[1:], border[0]], strict=True):
            one, other = complex(ax - x, ay - y), complex(bx - x, by - y)
            if one != 0 and other != 0:
                angle = (math.atan2(other.imag, other.real) - math.atan2(one.imag, one.real) + math.pi) % (2 * math.pi)
                turned += angle - math.pi
            side = other - one
            share = max(0.0, min(1.0, -(one.real * side.real + one.imag * side.imag) / max(1e-9, abs(side) ** 2)))
            nearest = min(nearest, abs(one + share * side))
        found.append(nearest if abs(turned) > math.pi else -nearest)
    return found
