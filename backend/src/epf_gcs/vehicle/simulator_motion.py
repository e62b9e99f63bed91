"""Whether the simulated aircraft moves as an aircraft does: it hangs still in the air, or is suddenly elsewhere.

A paused simulator goes on sending its rows, all equal. They arrive, but they are not live.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from operator import itemgetter
from typing import Final, NamedTuple

from epf_gcs.codec.messages_gen import XPLANE_ROWS
from epf_gcs.contract.events import SimulatorJumpEvent
from epf_gcs.earth import distance_m
from epf_gcs.units import M_PER_FT, MPS_PER_KT
from epf_gcs.xplane.datagram import Eight
from epf_gcs.xplane.mapping import in_our_unit, row_meaning

MOTION_ROWS: Final = frozenset({3, 4, 16, 17, 20})
"""Speed, climb, rates, attitude and position: in flight each of them changes from frame to frame."""

_SPEED_ROW: Final = 3
_POSITION_ROW: Final = 20
_PAUSED_AFTER_S: Final = 0.3
# A simulator that falls silent is no longer paused: that has an alarm of its own.
_SILENT_AFTER_S: Final = 1.0
# As on the board: below it the aircraft counts as standing on the ground, where it does hang still.
_FLYING_KT: Final = 20.0
JUMP_M: Final = 100.0
"""A place that is farther away than this and what can be flown meanwhile is a jump."""
FASTEST_RATIO: Final = 2.0
"""Of ground speed or climb to the indicated airspeed, in wind and up high."""
# Of jumps that follow each other at once, one is told in this time.
_QUIET_S: Final = 1.0

# A place this near is no jump, without computing how far it is: less than 50 m in each direction.
_NEAR_DEG: Final = 0.0004
_NEAR_FT: Final = 150.0

_PLACE: Final = ("latitude_deg", "longitude_deg", "altitude_indicated_ft")
_INDEXES: Final = {in_our_unit(value)[0]: value.index for value in XPLANE_ROWS["xp10"][_POSITION_ROW].values}
_pick_place: Final = itemgetter(*(_INDEXES[name] for name in _PLACE))


@dataclass(frozen=True, slots=True)
class Place:
    """Where an aircraft is."""

    latitude_deg: float
    longitude_deg: float
    altitude_ft: float


@dataclass(frozen=True, slots=True)
class Jump:
    """The simulator put the aircraft elsewhere: a reset or a new start. `t_s` is Unix time."""

    t_s: float
    distance_m: float
    to: Place

    def as_event(self) -> SimulatorJumpEvent:
        """What viewers and the recording are told."""
        place = self.to
        return SimulatorJumpEvent(round(self.distance_m), place.latitude_deg, place.longitude_deg, place.altitude_ft)


class MotionState(NamedTuple):
    """What the next rows are judged by; Unix times. `heard`: the newest of each row. `place`: the newest known one, its
    time, latitude, longitude and altitude."""

    heard: dict[int, tuple[float, Eight]]
    moved_s: float
    place: tuple[float, float, float, float] | None
    profile: str
    jumped_s: float


class SimulatorMotion:
    """Told each row as it arrives, with Unix times; `on_jump` hears of jumps."""

    def __init__(self, on_jump: Callable[[Jump], None]) -> None:
        self._on_jump = on_jump
        self.forget()

    def forget(self) -> None:
        """Another simulator."""
        self._heard: dict[int, tuple[float, Eight]] = {}
        self._moved_s = 0.0
        # Unix time of the newest known place, and its latitude, longitude and altitude.
        self._place: tuple[float, float, float, float] | None = None
        self._profile = "xp10"
        self._jumped_s = 0.0

    def take(self, row: int, values: Eight, t_s: float, profile: str) -> None:
        """Take one of the MOTION_ROWS."""
        before = self._heard.get(row)
        self._heard[row] = (t_s, values)
        self._profile = profile
        if before is None or not _is_same(before[1], values):
            self._moved_s = t_s
        if row == _POSITION_ROW:
            self._move(values, t_s)

    def is_paused(self, now_s: float) -> bool:
        """Whether all of the rows have arrived for a while without a change, of an aircraft in flight."""
        heard = self._heard
        if now_s - self._moved_s < _PAUSED_AFTER_S or len(heard) < len(MOTION_ROWS):
            return False
        oldest_s = min(t_s for t_s, _ in heard.values())
        hangs_still = oldest_s - self._moved_s >= _PAUSED_AFTER_S and now_s - oldest_s <= _SILENT_AFTER_S
        return hangs_still and self._speed_kt() >= _FLYING_KT

    def kept(self) -> MotionState:
        """For `restore`."""
        return MotionState(dict(self._heard), self._moved_s, self._place, self._profile, self._jumped_s)

    def restore(self, kept: MotionState) -> None:
        """Go on from what `kept` gave."""
        self._heard = dict(kept.heard)
        self._moved_s, self._place, self._profile, self._jumped_s = kept[1:]

    def _speed_kt(self) -> float:
        """Indicated airspeed, 0 if unknown."""
        heard = self._heard.get(_SPEED_ROW)
        if heard is None:
            return 0.0
        return row_meaning(_SPEED_ROW, heard[1], self._profile).values["indicated_airspeed_kt"] or 0.0

    def _move(self, values: Eight, t_s: float) -> None:
        latitude_deg, longitude_deg, altitude_ft = _pick_place(values)
        before = self._place
        if (
            before is not None
            and abs(latitude_deg - before[1]) < _NEAR_DEG
            and abs(longitude_deg - before[2]) < _NEAR_DEG
            and abs(altitude_ft - before[3]) < _NEAR_FT
        ):
            # Nearly every one, and cheaply.
            self._place = (t_s, latitude_deg, longitude_deg, altitude_ft)
            return
        meaning = row_meaning(_POSITION_ROW, values, self._profile).values
        if any(meaning[name] is None for name in _PLACE):
            return
        now = self._place = (t_s, latitude_deg, longitude_deg, altitude_ft)
        if before is not None:
            self._judge_jump(before, now)

    def _judge_jump(self, before: tuple[float, float, float, float], now: tuple[float, float, float, float]) -> None:
        t_s, to = now[0], Place(*now[1:])
        along_m = distance_m(*before[1:3], *now[1:3])
        way_m = math.hypot(along_m, (now[3] - before[3]) * M_PER_FT)
        flown_m = FASTEST_RATIO * max(self._speed_kt(), 0.0) * MPS_PER_KT * max(0.0, t_s - before[0])
        if way_m > JUMP_M + flown_m and t_s - self._jumped_s >= _QUIET_S:
            self._jumped_s = t_s
            self._on_jump(Jump(t_s, way_m, to))


def _is_same(one: Eight, other: Eight) -> bool:
    """A NaN is equal to itself. In flight the first values differ already, so this ends early."""
    return all(a == b or (math.isnan(a) and math.isnan(b)) for a, b in zip(one, other, strict=True))
