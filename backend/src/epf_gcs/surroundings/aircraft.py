"""One aircraft over the ground and in the fence: its height, and what its present track leads to. Pure."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, Literal

import numpy as np
import numpy.typing as npt

from epf_gcs.earth import M_PER_DEG
from epf_gcs.surroundings.fence import inside_m
from epf_gcs.surroundings.motion import Fix, Motion, MotionEstimate, Vector
from epf_gcs.surroundings.path import Path, path_ahead
from epf_gcs.surroundings.threats import AHEAD_S, Steady, Threat, first_below, limit

Blind = Literal["no_position", "no_heights", "no_heights_here"]
Heights = Callable[[Vector, Vector], Vector]
"""Metres above the sea at these latitudes and longitudes; NaN: not known."""

# An aircraft flies once it was faster than this over the ground; one that flew stands after it was nearly still and
# level for some seconds: in the air against a strong wind it is slow, too.
_FLIES_MPS: Final = 10.0
_STILL_MPS: Final = 1.5
_LEVEL_MPS: Final = 0.5
_STANDS_S: Final = 10.0
# One that never flew stands below this speed.
_STANDS_MPS: Final = 5.0
# A gap of the line for so long changes no warning.
_HICCUP_S: Final = 1.0
# The place of take-off is also the place to land: ground as high as it and so near is not warned of.
_FIELD_M: Final = 800.0
_FIELD_HIGH_M: Final = 15.0


@dataclass(frozen=True, slots=True)
class WatchChoice:
    """What the operator chose. `corners_deg`: latitude and longitude; fewer than three: no border."""

    terrain: bool = False
    margin_m: float = 46.0
    fence: bool = False
    corners_deg: tuple[tuple[float, float], ...] = ()
    ceiling_m: float | None = None
    fence_margin_m: float = 30.0


@dataclass(frozen=True, slots=True)
class SurroundingsView:
    """`blind`: why nothing is known of the ground. `outside`: the aircraft has left the fence, or is over its ceiling.
    `path`: where the present track leads, while there is a warning."""

    blind: Blind | None = "no_position"
    ground_m: float | None = None
    height_m: float | None = None
    terrain: Threat | None = None
    fence: Threat | None = None
    outside: bool = False
    path: Path | None = None


class AircraftSurroundings:
    """Told every fix, asked some times a second."""

    def __init__(self) -> None:
        self._track = MotionEstimate()
        self._terrain = Steady()
        self._fence = Steady()
        # An aircraft first seen in flight is warned at once; one that stood, when it was clear of the ground once.
        self._is_armed = True
        self._is_flying = False
        self._still_since_s: float | None = None
        self._field: tuple[float, float] | None = None
        self._seen_s = -math.inf
        self._outside = False

    @property
    def newest_s(self) -> float | None:
        """Unix time of the newest fix."""
        newest = self._track.newest
        return None if newest is None else newest.t_s

    @property
    def newest(self) -> Fix | None:
        """The newest fix."""
        return self._track.newest

    def add(self, fix: Fix) -> None:
        """Take the newest fix."""
        self._track.add(fix)

    def unseen(self, now_s: float) -> SurroundingsView:
        """The position is not live at `now_s`: nothing is known. After a moment's gap nothing is warned of either."""
        if now_s - self._seen_s > _HICCUP_S:
            self._terrain.end()
            self._fence.end()
            self._outside = False
        return SurroundingsView(terrain=self._terrain.shown, fence=self._fence.shown, outside=self._outside)

    def look(self, now_s: float, wanted: WatchChoice, heights: Heights, *, has_heights: bool) -> SurroundingsView:
        """What is around at Unix time `now_s`."""
        fix = self._track.newest
        if fix is None:
            return self.unseen(now_s)
        self._seen_s = now_s
        ground_m = _number(heights(np.array([fix.latitude_deg]), np.array([fix.longitude_deg])))
        blind: Blind | None = None
        if ground_m is None:
            blind = "no_heights_here" if has_heights else "no_heights"
        height_m = None if ground_m is None else fix.altitude_m - ground_m
        motion = self._track.now()
        if motion is None:
            return SurroundingsView(blind, ground_m, height_m)
        path = path_ahead(motion, now_s, AHEAD_S)
        is_flying = self._stand_or_fly(motion, height_m, wanted.margin_m)
        terrain = fence = None
        self._outside = False
        if wanted.terrain and is_flying and self._is_armed:
            terrain = self._terrain.look(now_s, self._ground_ahead(path, wanted, heights))
        else:
            self._terrain.end()
        if wanted.fence and is_flying:
            found, self._outside = self._fence_ahead(path, wanted)
            fence = self._fence.look(now_s, found)
        else:
            self._fence.end()
        warned = terrain is not None or fence is not None
        return SurroundingsView(blind, ground_m, height_m, terrain, fence, self._outside, path if warned else None)

    def _stand_or_fly(self, motion: Motion, height_m: float | None, margin_m: float) -> bool:
        is_high = height_m is not None and height_m > margin_m
        if motion.speed_mps >= _FLIES_MPS or is_high:
            self._is_flying = True
        if is_high:
            self._is_armed = True
        if is_high or (self._is_flying and not self._has_stood_still(motion)):
            return self._is_flying
        if motion.speed_mps < _STANDS_MPS:
            self._is_flying = self._is_armed = False
            self._field = (motion.latitude_deg, motion.longitude_deg)
        return self._is_flying

    def _has_stood_still(self, motion: Motion) -> bool:
        if motion.speed_mps >= _STILL_MPS or abs(motion.climb_mps) >= _LEVEL_MPS:
            self._still_since_s = None
            return False
        if self._still_since_s is None:
            self._still_since_s = motion.t_s
        return motion.t_s - self._still_since_s >= _STANDS_S

    def _ground_ahead(self, path: Path, wanted: WatchChoice, heights: Heights) -> Threat | None:
        margin_m = limit(wanted.margin_m, is_shown=self._terrain.shown is not None)
        ground_m = heights(path.latitude_deg, path.longitude_deg)
        clearance_m = path.altitude_m - ground_m
        is_field = self._is_field(path, ground_m, heights)
        touches = np.flatnonzero(is_field & (clearance_m < 0.0))
        # A path that ends on the field has landed: behind it nothing is met.
        is_over = np.arange(clearance_m.size) >= (touches[0] if touches.size else clearance_m.size)
        return first_below(path, np.where(is_field | is_over, np.nan, clearance_m), margin_m, "terrain")

    def _is_field(self, path: Path, ground_m: Vector, heights: Heights) -> npt.NDArray[np.bool_]:
        """Which places are the field where the aircraft took off."""
        nowhere = np.zeros(ground_m.shape, dtype=np.bool_)
        if self._field is None:
            return nowhere
        latitude_deg, longitude_deg = self._field
        field_m = _number(heights(np.array([latitude_deg]), np.array([longitude_deg])))
        if field_m is None:
            return nowhere
        across = math.cos(math.radians(latitude_deg))
        east_m = ((path.longitude_deg - longitude_deg + 180.0) % 360.0 - 180.0) * M_PER_DEG * across
        north_m = (path.latitude_deg - latitude_deg) * M_PER_DEG
        near: npt.NDArray[np.bool_] = np.hypot(east_m, north_m) < _FIELD_M
        return near & (np.abs(ground_m - field_m) < _FIELD_HIGH_M)

    def _fence_ahead(self, path: Path, wanted: WatchChoice) -> tuple[Threat | None, bool]:
        """What of the fence is reached first, and whether the aircraft is outside already."""
        margin_m = limit(wanted.fence_margin_m, is_shown=self._fence.shown is not None)
        found: list[Threat | None] = []
        outside = False
        if len(wanted.corners_deg) >= 3:
            within_m = inside_m(wanted.corners_deg, path.latitude_deg, path.longitude_deg)
            outside = bool(within_m[0] < 0.0)
            found.append(first_below(path, within_m, margin_m, "fence"))
        if wanted.ceiling_m is not None:
            below_m = wanted.ceiling_m - path.altitude_m
            outside = outside or bool(below_m[0] < 0.0)
            found.append(first_below(path, below_m, margin_m, "ceiling"))
        threats = [one for one in found if one is not None]
        return min(threats, key=lambda one: one.in_s, default=None), outside


def _number(values: Vector) -> float | None:
    value = float(values[0])
    return None if math.isnan(value) else value
