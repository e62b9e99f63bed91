"""How fast the simulator's time runs: the way that its aircraft makes over ground against its ground speed."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from statistics import median
from typing import Any, Final

from epf_gcs.earth import distance_m
from epf_gcs.units import mps_from_kt
from epf_gcs.vehicle.judges import Finding
from epf_gcs.xplane.mapping import row_meaning

SPEED_ROW: Final = 3
POSITION_ROW: Final = 20

# A stretch lasts at least a second, so that the jitter of the datagrams' times is a few percent of it, and ten metres,
# for a position far from Greenwich moves in steps of almost one.
_SHORTEST_S: Final = 1.0
_LONGEST_S: Final = 2.0
_LEAST_M: Final = 10.0
# A pause of the datagrams, and a way that no aircraft makes within one frame: another start.
_PAUSE_S: Final = 0.5
_JUMP_M: Final = 500.0
# Below the first the simulator stands still rather than being slow. Between normal and the others nothing is said.
_STANDS: Final = 0.2
_SLOW: Final = 0.7
_NORMAL: Final = (0.75, 1.35)
_FAST: Final = 1.5
_AGREEING: Final = 3
# Without a stretch that says anything (it stands, it is paused, it is silent) the pace is not known any more.
_FORGOTTEN_S: Final = 10.0
# What was said stands while the pace differs from it by less than this share.
_SAME: Final = 0.2


class PaceJudge:
    """Told rows 3 and 20 as they come. A simulator that sends no ground speed is not judged."""

    def __init__(self) -> None:
        self._speed: Sequence[float] | None = None
        self._place: Sequence[float] | None = None
        self._before: tuple[float, float, float, float] | None = None
        self._began: tuple[float, float, float] | None = None
        self._expected_m = 0.0
        self._paces: deque[float] = deque(maxlen=_AGREEING)
        self._judged_s: float | None = None
        self._is_off = False
        self._said = 1.0

    def take(self, row: int, values: Sequence[float], t_s: float) -> None:
        """One of the two rows came at Unix time `t_s`."""
        if row == SPEED_ROW:
            self._speed = values
        else:
            self._place = values
        if self._speed is None or self._place is None:
            return
        speed_kt = row_meaning(SPEED_ROW, tuple(self._speed), "xp10").values["ground_speed_kt"]
        place = row_meaning(POSITION_ROW, tuple(self._place), "xp10").values
        self._speed = self._place = None
        latitude_deg, longitude_deg = place["latitude_deg"], place["longitude_deg"]
        if speed_kt is None or latitude_deg is None or longitude_deg is None:
            self._before = None
            return
        self._go_on(t_s, latitude_deg, longitude_deg, mps_from_kt(speed_kt))

    def look(self, now_s: float) -> Finding | None:
        """Whether the simulator's time runs otherwise than the clock at Unix time `now_s`."""
        if not self._is_off or self._judged_s is None or now_s - self._judged_s > _FORGOTTEN_S:
            return None
        pace = median(self._paces)
        if abs(pace / self._said - 1.0) > _SAME:
            self._said = round(2.0 * pace) / 2.0 if pace > 1.0 else round(pace, 1)
        text = (
            f"The simulator's time runs at x{self._said:g} of the clock: the board flies by the clock, and its gains "
            "do not fit. Set the simulation's speed to x1, or its frame rate above 20 a second."
        )
        return Finding("simulator_pace", "warning", text, {"pace": self._said})

    def kept(self) -> list[Any]:
        """Plain values for `restore`."""
        return [
            *(self._speed, self._place, self._before, self._began, self._expected_m),
            *(list(self._paces), self._judged_s, self._is_off, self._said),
        ]

    def restore(self, kept: Sequence[Any]) -> None:
        """Go on from what `kept` gave."""
        self._speed, self._place, before, began, self._expected_m = kept[:5]
        self._before = None if before is None else tuple(before)
        self._began = None if began is None else tuple(began)
        paces, self._judged_s, self._is_off, self._said = kept[5:]
        self._paces = deque(paces, maxlen=_AGREEING)

    def _go_on(self, t_s: float, latitude_deg: float, longitude_deg: float, speed_m_s: float) -> None:
        before, self._before = self._before, (t_s, latitude_deg, longitude_deg, speed_m_s)
        here = (t_s, latitude_deg, longitude_deg)
        if (
            self._began is None
            or before is None
            or not 0.0 <= t_s - before[0] < _PAUSE_S
            or distance_m(*before[1:3], *here[1:]) > _JUMP_M
        ):
            self._begin(here)
            return
        self._expected_m += 0.5 * (before[3] + speed_m_s) * (t_s - before[0])
        lasted_s = t_s - self._began[0]
        if lasted_s >= _SHORTEST_S and self._expected_m >= _LEAST_M:
            self._decide(distance_m(*self._began[1:], *here[1:]) / self._expected_m, t_s)
            self._begin(here)
        elif lasted_s >= _LONGEST_S:
            self._begin(here)

    def _begin(self, here: tuple[float, float, float]) -> None:
        self._began = here
        self._expected_m = 0.0

    def _decide(self, pace: float, t_s: float) -> None:
        if pace < _STANDS:
            self._paces.clear()
            return
        if self._judged_s is not None and t_s - self._judged_s > _FORGOTTEN_S:
            self._is_off = False
            self._paces.clear()
        self._judged_s = t_s
        self._paces.append(pace)
        if len(self._paces) < _AGREEING:
            return
        slowest, fastest = min(self._paces), max(self._paces)
        if slowest > _FAST or fastest < _SLOW:
            self._is_off = True
        elif slowest > _NORMAL[0] and fastest < _NORMAL[1]:
            self._is_off, self._said = False, 1.0
