"""Whether the simulator's rows are read as the generation of X-Plane that sends them: its angular rates must turn the
aircraft as its attitude says that it turned. Order and unit of the rates differ between the generations."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, Final

from epf_gcs.codec.messages_gen import NO_VALUE, XPLANE_ROWS
from epf_gcs.contract.base import SimulatorProfile
from epf_gcs.vehicle.judges import Finding
from epf_gcs.xplane.mapping import in_our_unit

RATES_ROW: Final = 16
ATTITUDE_ROW: Final = 17

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]

# A stretch ends with so large a turn: far above the steps of 32-bit angles, far below a bank that hurts. A shorter
# one is made of the jitter of the datagrams' times.
_TURN_RAD: Final = math.radians(1.5)
_SHORTEST_S: Final = 0.06
# A stretch that has turned less after so long says nothing.
_LONGEST_S: Final = 1.0
_LEAST_TURN_RAD: Final = math.radians(0.5)
# A pause of the datagrams, and a turn that no aircraft makes within one frame: another start.
_PAUSE_S: Final = 0.25
_JUMP_RAD: Final = math.radians(25.0)
# Another simulator may have begun meanwhile; a restart of X-Plane takes longer than this.
_FORGOTTEN_S: Final = 10.0
# The simulator's time may run slower or faster than the clock: the rates are compared within this factor.
_SLOWEST: Final = 0.2
_FASTEST: Final = 5.0
# Of the turn: in severe turbulence over a bad line the rates of the right generation leave up to 0.43 unexplained,
# those of the other one 0.9 or more; less only where it yaws while the simulator's time runs slower than the clock.
_EXPLAINED: Final = 0.5
_UNEXPLAINED: Final = 0.6
_AGREEING: Final = 3
_FASTEST_RATE: Final = 2300.0
_LARGEST_ANGLE_DEG: Final = 720.0

PROFILE_NAMES: Final[Mapping[str, str]] = {"xp10": "X-Plane 10 / 11", "xp12": "X-Plane 12"}
"""As X-Plane's users and the page call them."""

_STILL: Final[Vector] = (0.0, 0.0, 0.0)


class ProfileJudge:
    """Told rows 16 and 17 as they come. `fits` is the profile that the rows are of, None while the data have not said.

    A stretch of flight speaks for one profile if its rates explain how the attitude turned and the other's do not;
    three in a row decide, and as many against them change it. An aircraft that does not turn says nothing.
    """

    def __init__(self) -> None:
        self.fits: SimulatorProfile | None = None
        self._rates: Sequence[float] | None = None
        self._attitude: Sequence[float] | None = None
        self._heard_s: float | None = None
        self._before: tuple[float, Sequence[float], Quaternion] | None = None
        self._leaning: SimulatorProfile | None = None
        self._agreeing = 0
        self._began_s = 0.0
        self._turned: Vector = _STILL
        self._told: dict[SimulatorProfile, Vector] = {}

    def take(self, row: int, values: Sequence[float], t_s: float) -> None:
        """One of the two rows came at Unix time `t_s`."""
        if row == RATES_ROW:
            self._rates = values[:3]
        else:
            self._attitude = values[:3]
        if self._rates is None or self._attitude is None:
            return
        rates, attitude = self._rates, self._attitude
        self._rates = self._attitude = None
        if self._is_silent(t_s):
            self.fits, self._leaning, self._agreeing = None, None, 0
        self._heard_s = t_s
        if _is_usable(rates, _FASTEST_RATE) and _is_usable(attitude, _LARGEST_ANGLE_DEG):
            self._go_on(t_s, rates, _quaternion(attitude))
        else:
            self._before = None

    def is_wrong(self, profile: str) -> bool:
        """Whether the data say that they are of another profile than this one."""
        return self.fits is not None and self.fits != profile

    def look(self, now_s: float, profile: str) -> Finding | None:
        """`profile` is what the rows are read as; Unix time."""
        if not self.is_wrong(profile) or self._is_silent(now_s):
            return None
        sent, read = PROFILE_NAMES[str(self.fits)], PROFILE_NAMES[profile]
        text = (
            f"The simulator sends the rows of {sent} and they are read as {read}'s: the board gets wrong angular rates "
            f"and may not move the surfaces. Choose the profile {sent} in the simulator's link."
        )
        return Finding("profile_wrong", "critical", text, {"profile": read, "fits": sent})

    def kept(self) -> list[Any]:
        """Plain values for `restore`."""
        return [
            *(self.fits, self._rates, self._attitude, self._heard_s, self._before, self._leaning, self._agreeing),
            *(self._began_s, self._turned, self._told),
        ]

    def restore(self, kept: Sequence[Any]) -> None:
        """Go on from what `kept` gave."""
        self.fits, self._rates, self._attitude, self._heard_s, before, self._leaning, self._agreeing = kept[:7]
        self._before = None if before is None else (before[0], before[1], tuple(before[2]))
        self._began_s, turned, told = kept[7:]
        self._turned = tuple(turned)
        self._told = {profile: tuple(vector) for profile, vector in told.items()}

    def _is_silent(self, now_s: float) -> bool:
        return self._heard_s is not None and now_s - self._heard_s > _FORGOTTEN_S

    def _begin_stretch(self, t_s: float) -> None:
        self._began_s = t_s
        self._turned = _STILL
        self._told = dict.fromkeys(_RATES, _STILL)

    def _go_on(self, t_s: float, rates: Sequence[float], attitude: Quaternion) -> None:
        before, self._before = self._before, (t_s, rates, attitude)
        if before is None or not 0.0 <= t_s - before[0] < _PAUSE_S:
            self._begin_stretch(t_s)
            return
        step = _turn(before[2], attitude)
        if math.hypot(*step) > _JUMP_RAD:
            self._begin_stretch(t_s)
            return
        self._turned = _plus(self._turned, step, 1.0)
        half_s = 0.5 * (t_s - before[0])
        for profile, places in _RATES.items():
            both = (scale * (before[1][place] + rates[place]) for place, scale in places)
            self._told[profile] = _plus(self._told[profile], tuple(both), half_s)
        turned_rad, lasted_s = math.hypot(*self._turned), t_s - self._began_s
        if lasted_s >= _LONGEST_S or (lasted_s >= _SHORTEST_S and turned_rad >= _TURN_RAD):
            if turned_rad >= _LEAST_TURN_RAD:
                self._decide(turned_rad)
            self._begin_stretch(t_s)

    def _decide(self, turned_rad: float) -> None:
        rest = {profile: _unexplained(self._turned, told) / turned_rad for profile, told in self._told.items()}
        best = min(rest, key=lambda profile: rest[profile])
        if rest[best] > _EXPLAINED or any(rest[other] < _UNEXPLAINED for other in rest if other != best):
            return
        self._agreeing = self._agreeing + 1 if best == self._leaning else 1
        self._leaning = best
        if self._agreeing >= _AGREEING:
            self.fits = best


def _is_usable(values: Sequence[float], largest: float) -> bool:
    return all(abs(value) <= largest and value != NO_VALUE for value in values)


def _quaternion(attitude: Sequence[float]) -> Quaternion:
    """From north, east, down to nose, right wing, down. Has no heading that wraps and no pitch that locks."""
    pitch, roll, heading = (math.radians(angle) / 2.0 for angle in attitude)
    cr, sr = math.cos(roll), math.sin(roll)
    cp, sp = math.cos(pitch), math.sin(pitch)
    ch, sh = math.cos(heading), math.sin(heading)
    return (
        ch * cp * cr + sh * sp * sr,
        ch * cp * sr - sh * sp * cr,
        ch * sp * cr + sh * cp * sr,
        sh * cp * cr - ch * sp * sr,
    )


def _turn(first: Quaternion, second: Quaternion) -> Vector:
    """The small turn from one attitude to another, about nose, right wing and down [rad]."""
    a, b, c, d = first
    w, x, y, z = second
    twice = 2.0 if a * w + b * x + c * y + d * z >= 0.0 else -2.0
    return (
        twice * (a * x - b * w - c * z + d * y),
        twice * (a * y - c * w - d * x + b * z),
        twice * (a * z - d * w - b * y + c * x),
    )


def _plus(total: Vector, step: Sequence[float], weight: float) -> Vector:
    return (total[0] + weight * step[0], total[1] + weight * step[1], total[2] + weight * step[2])


def _unexplained(turned: Vector, told: Vector) -> float:
    """What is left of the turn after that of the rates, the simulator's time being as fast as suits them best [rad]."""
    square = sum(part * part for part in told)
    pace = sum(one * other for one, other in zip(turned, told, strict=True)) / square if square else 1.0
    return math.hypot(*_plus(turned, told, -min(_FASTEST, max(_SLOWEST, pace))))


def _places(profile: str) -> tuple[tuple[int, float], ...]:
    """Where P, Q and R are in the row, and the factors to rad/s."""
    named = {
        in_our_unit(wanted)[0]: (wanted.index, in_our_unit(wanted)[1]) for wanted in XPLANE_ROWS[profile][16].values
    }
    return tuple(named[name] for name in ("p_rad_s", "q_rad_s", "r_rad_s"))


_RATES: Final[Mapping[SimulatorProfile, tuple[tuple[int, float], ...]]] = {
    "xp10": _places("xp10"),
    "xp12": _places("xp12"),
}
