"""Whether the simulated aircraft moves as an aircraft does: it hangs still in the air, or is suddenly elsewhere.

A paused simulator goes on sending its rows, all equal. They arrive, but they are not live.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from struct import Struct
from typing import Any, Final

from epf_gcs.codec.messages_gen import VALUES_PER_ROW
from epf_gcs.xplane.datagram import Eight
from epf_gcs.xplane.mapping import row_meaning

MOTION_ROWS: Final = frozenset({3, 4, 16, 17, 20})
"""Speed, climb, rates, attitude and position: in flight each of them changes from frame to frame."""

JUMPED: Final = "simulator_jumped"
"""The event that viewers are told of a jump by, and that a recording notes."""

_SPEED_ROW: Final = 3
_POSITION_ROW: Final = 20
_PAUSED_AFTER_S: Final = 0.3
# A simulator that falls silent is no longer paused: that has an alarm of its own.
_SILENT_AFTER_S: Final = 1.0
# As on the board: below it the aircraft counts as standing on the ground, where it does hang still.
_FLYING_KT: Final = 20.0
_JUMP_M: Final = 500.0
# Of ground speed or climb to the indicated airspeed, in wind and up high.
_FASTEST_RATIO: Final = 2.0
_M_S_PER_KT: Final = 0.514444
_M_PER_FT: Final = 0.3048
_EARTH_RADIUS_M: Final = 6_371_008.8
# A simulator that throws the aircraft about is told of once in this time.
_QUIET_S: Final = 1.0

_BITS: Final = Struct(f"<{VALUES_PER_ROW}f")


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

    def as_event(self) -> dict[str, Any]:
        """The data of the event JUMPED."""
        place = self.to
        return {
            "distance_m": round(self.distance_m),
            "latitude_deg": place.latitude_deg,
            "longitude_deg": place.longitude_deg,
            "altitude_ft": place.altitude_ft,
        }


class SimulatorMotion:
    """Told each row as it arrives, with Unix times; `on_jump` is set by who tells of jumps."""

    def __init__(self) -> None:
        self.on_jump: Callable[[Jump], None] | None = None
        self.forget()

    def forget(self) -> None:
        """Another simulator."""
        self._heard: dict[int, tuple[float, Eight]] = {}
        self._moved_s = 0.0
        self._place: tuple[float, Place] | None = None
        self._speed_kt: float | None = None
        self._jumped_s = -math.inf

    def take(self, row: int, values: Eight, t_s: float, profile: str) -> None:
        """Take one of the MOTION_ROWS."""
        before = self._heard.get(row)
        self._heard[row] = (t_s, values)
        if before is not None and _is_same(before[1], values):
            if row == _POSITION_ROW and self._place is not None:
                self._place = (t_s, self._place[1])
            return
        self._moved_s = t_s
        if row == _SPEED_ROW:
            self._speed_kt = row_meaning(row, values, profile).values["indicated_airspeed_kt"]
        elif row == _POSITION_ROW:
            self._move(values, t_s, profile)

    def is_paused(self, now_s: float) -> bool:
        """Whether all of the rows have arrived for a while without a change, of an aircraft in flight."""
        heard = self._heard
        if self._speed_kt is None or self._speed_kt < _FLYING_KT or len(heard) < len(MOTION_ROWS):
            return False
        oldest_s = min(t_s for t_s, _ in heard.values())
        return oldest_s - self._moved_s >= _PAUSED_AFTER_S and now_s - oldest_s <= _SILENT_AFTER_S

    def kept(self) -> dict[str, Any]:
        """Plain values for `restore`."""
        place = self._place
        return {
            "heard": [[row, t_s, list(values)] for row, (t_s, values) in self._heard.items()],
            "moved_s": self._moved_s,
            "speed_kt": self._speed_kt,
            "place": None
            if place is None
            else [place[0], place[1].latitude_deg, place[1].longitude_deg, place[1].altitude_ft],
        }

    def restore(self, kept: Mapping[str, Any]) -> None:
        """Go on from what `kept` gave."""
        self.forget()
        self._heard = {row: (t_s, tuple(values)) for row, t_s, values in kept["heard"]}
        self._moved_s = kept["moved_s"]
        self._speed_kt = kept["speed_kt"]
        if kept["place"] is not None:
            t_s, *place = kept["place"]
            self._place = (t_s, Place(*place))

    def _move(self, values: Eight, t_s: float, profile: str) -> None:
        said = row_meaning(_POSITION_ROW, values, profile).values
        latitude_deg, longitude_deg = said["latitude_deg"], said["longitude_deg"]
        altitude_ft = said["altitude_indicated_ft"]
        if latitude_deg is None or longitude_deg is None or altitude_ft is None:
            return
        before, place = self._place, Place(latitude_deg, longitude_deg, altitude_ft)
        self._place = (t_s, place)
        if before is None:
            return
        way_m = _distance_m(before[1], place)
        flown_m = _FASTEST_RATIO * max(self._speed_kt or 0.0, 0.0) * _M_S_PER_KT * max(0.0, t_s - before[0])
        if way_m > _JUMP_M + flown_m and t_s - self._jumped_s >= _QUIET_S:
            self._jumped_s = t_s
            if self.on_jump is not None:
                self.on_jump(Jump(t_s, way_m, place))


def _is_same(one: Eight, other: Eight) -> bool:
    """Bit for bit: a NaN is equal to itself."""
    return one == other or _BITS.pack(*one) == _BITS.pack(*other)


def _distance_m(one: Place, other: Place) -> float:
    """By the great circle and by height."""
    phi, other_phi = math.radians(one.latitude_deg), math.radians(other.latitude_deg)
    half_turn = math.radians(other.longitude_deg - one.longitude_deg) / 2.0
    haversine = math.sin((other_phi - phi) / 2.0) ** 2 + math.cos(phi) * math.cos(other_phi) * math.sin(half_turn) ** 2
    along_m = 2.0 * _EARTH_RADIUS_M * math.asin(math.sqrt(min(1.0, haversine)))
    return math.hypot(along_m, (other.altitude_ft - one.altitude_ft) * _M_PER_FT)
