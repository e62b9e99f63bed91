"""What goes wrong in a flown plan: on which leg, and by how much."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final, Literal, NamedTuple

import numpy as np
import numpy.typing as npt

from epf_gcs.codec.tables import Waypoint
from epf_gcs.rehearsal.flown_plan import FlownLeg, FlownPlan, Left, capture_m, metres
from epf_gcs.surroundings.fence import inside_m
from epf_gcs.surroundings.motion import Vector

FindingCode = Literal[
    "above_ceiling",
    "battery_ends",
    "leaves_fence",
    "low_ground",
    "meets_ground",
    "misses_altitude",
    "short_leg",
    "too_long",
    "unfinished_turn",
    "unreached",
    "wide_turn",
]

# The board holds its altitude within this, and its lines within that, also in gusts.
_ALTITUDE_BAND_FT: Final = 30.0
_FENCE_BAND_M: Final = 5.0
# An altitude that is further off when its waypoint is reached was not flown.
_MISSED_FT: Final = 100.0
# A turn that swings further from its legs than this many capture radii, or that is so far from done at its waypoint.
# The sharpest turn of the built-in routes swings 1.2 radii in still air and 1.9 in 20 kt.
_WIDE_RADII: Final = 2.0
_UNFINISHED_DEG: Final = 40.0
# A waypoint that is reached so soon after the one before was not flown to.
_SHORT_S: Final = 2.0
_LEAST_CORNERS: Final = 3

Places = npt.NDArray[np.float64]
"""Rows of latitude and longitude, degrees."""


class Finding(NamedTuple):
    """What is wrong on the leg to waypoint `row`, with the numbers for its sentence, in the units of their names."""

    code: FindingCode
    row: int
    params: dict[str, float]


@dataclass(frozen=True, slots=True)
class Bounds:
    """What a flight must stay within. `corners_deg`: the fence's border, latitude and longitude, or nothing; ceiling
    above the sea; `margin_ft`: least height over the ground; `endurance_s`: time that the battery lasts."""

    corners_deg: tuple[tuple[float, float], ...] = ()
    ceiling_ft: float | None = None
    margin_ft: float = 0.0
    endurance_s: float | None = None


def findings(
    waypoints: Sequence[Waypoint], flown: FlownPlan, ground_ft: Sequence[float | None], bounds: Bounds
) -> list[Finding]:
    """All of them, by row. `ground_ft`: of each sample, above the sea; None where it is not known."""
    rows = np.array([sample.row for sample in flown.samples], dtype=np.int64)
    places_deg = np.array([sample[1:3] for sample in flown.samples], dtype=np.float64).reshape(-1, 2)
    altitude_ft = np.array([sample.altitude_ft for sample in flown.samples], dtype=np.float64)
    known_ft = np.array([np.nan if height_ft is None else height_ft for height_ft in ground_ft], dtype=np.float64)
    first = flown.legs[0].row
    found = [*_battery(flown, bounds.endurance_s)]
    line: _Line | None = None
    for leg in flown.legs:
        here = rows == leg.row
        before, line = line, _line(waypoints, leg)
        found += _end(waypoints[leg.row], leg, flown.left, is_first=leg.row == first)
        if here.any():
            found += _turn(waypoints[leg.row], leg, places_deg[here], [line] if before is None else [before, line])
            found += _fence(bounds, leg.row, places_deg[here], altitude_ft[here])
            found += _ground(leg.row, altitude_ft[here] - known_ft[here], bounds.margin_ft, is_first=leg.row == first)
    return sorted(found, key=lambda one: one.row)


_Line = tuple[tuple[float, float], tuple[float, float]]


def _line(waypoints: Sequence[Waypoint], leg: FlownLeg) -> _Line:
    return leg.begin_deg, (waypoints[leg.row].latitude_deg, waypoints[leg.row].longitude_deg)


def _end(waypoint: Waypoint, leg: FlownLeg, left: Left | None, *, is_first: bool) -> Iterator[Finding]:
    """How the leg ended: not at all, at once, in a turn, or at another altitude."""
    if leg.end is None:
        yield Finding(left or "unreached", leg.row, {})
        return
    is_at_once = leg.end.time_s - leg.begin_s < _SHORT_S
    if is_first and is_at_once:
        # The flight begins there: nothing was flown.
        return
    off_ft = leg.end.altitude_ft - waypoint.altitude_ft
    radius_m = capture_m(waypoint.speed_kt)
    length_m = math.hypot(*metres(leg.begin_deg, (waypoint.latitude_deg, waypoint.longitude_deg)))
    if is_at_once or length_m <= radius_m:
        yield Finding("short_leg", leg.row, {"distance_m": length_m, "radius_m": radius_m})
    elif leg.end.off_track_deg > _UNFINISHED_DEG:
        yield Finding("unfinished_turn", leg.row, {"off_deg": leg.end.off_track_deg})
    if abs(off_ft) > _MISSED_FT:
        yield Finding("misses_altitude", leg.row, {"off_ft": abs(off_ft), "flown_ft": leg.end.altitude_ft})


def _turn(waypoint: Waypoint, leg: FlownLeg, places_deg: Places, lines: Sequence[_Line]) -> Iterator[Finding]:
    """How far the way to the waypoint swings from its own leg and the one before."""
    on_way = places_deg[: leg.samples]
    if len(on_way) == 0:
        return
    distance_m = np.min([_distances_m(on_way, line) for line in lines], axis=0)
    if distance_m.max() > _WIDE_RADII * capture_m(waypoint.speed_kt):
        yield Finding("wide_turn", leg.row, {"distance_m": float(distance_m.max())})


def _distances_m(places_deg: Places, line: _Line) -> Vector:
    """Of each place from a line between two others."""
    places_m = np.array([metres(line[0], (place[0], place[1])) for place in places_deg.tolist()])
    end_m = np.array(metres(*line))
    share = np.clip(places_m @ end_m / max(1.0, float(end_m @ end_m)), 0.0, 1.0)
    off_m = places_m - share[:, None] * end_m
    distances: Vector = np.hypot(off_m[:, 0], off_m[:, 1])
    return distances


def _fence(bounds: Bounds, row: int, places_deg: Places, altitude_ft: Vector) -> Iterator[Finding]:
    if len(bounds.corners_deg) >= _LEAST_CORNERS:
        outside_m = -float(inside_m(bounds.corners_deg, places_deg[:, 0], places_deg[:, 1]).min())
        if outside_m > _FENCE_BAND_M:
            yield Finding("leaves_fence", row, {"distance_m": outside_m})
    if bounds.ceiling_ft is not None:
        above_ft = float(altitude_ft.max()) - bounds.ceiling_ft
        if above_ft > _ALTITUDE_BAND_FT:
            yield Finding("above_ceiling", row, {"above_ft": above_ft, "ceiling_ft": bounds.ceiling_ft})


def _ground(row: int, clearance_ft: Vector, margin_ft: float, *, is_first: bool) -> Iterator[Finding]:
    known_ft = clearance_ft[~np.isnan(clearance_ft)]
    if is_first:
        # An aircraft that stands, or has just taken off, is near the ground until it has climbed away from it.
        known_ft = known_ft[int(np.argmax(known_ft > margin_ft)) :] if (known_ft > margin_ft).any() else known_ft[-1:]
    if known_ft.size == 0:
        return
    least_ft = float(known_ft.min())
    if least_ft <= 0.0:
        yield Finding("meets_ground", row, {"below_ft": -least_ft})
    elif least_ft < margin_ft:
        yield Finding("low_ground", row, {"height_ft": least_ft, "margin_ft": margin_ft})


def _battery(flown: FlownPlan, endurance_s: float | None) -> Iterator[Finding]:
    """The leg on which the battery ends."""
    if endurance_s is None:
        return
    for leg in flown.legs:
        end_s = flown.time_s if leg.end is None else leg.end.time_s
        if end_s > endurance_s:
            params = {"lasts_min": endurance_s / 60.0, "takes_min": flown.time_s / 60.0}
            yield Finding("battery_ends", leg.row, params)
            return
