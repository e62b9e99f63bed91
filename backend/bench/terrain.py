"""Warnings of ground and fence: 1,000 made encounters over real ground, and quiet minutes beside them.

The heights are any raster that GDAL reads, named by `EPF_HEIGHTS` (mountains, with some 50 km of them); without it the
measurement is skipped. The station's heights are its own terrain tiles of the raster; the truth is the raster itself.
"""

from __future__ import annotations

import math
import os
import random
from pathlib import Path

import numpy as np

from bench.table import Row
from epf_gcs.formats.quantized_mesh import CELLS, encode_tile, tile_nodes
from epf_gcs.formats.quantized_mesh_reading import SIDE, read_grid
from epf_gcs.surroundings.aircraft import WatchChoice
from epf_gcs.surroundings.motion import Vector
from tests.surroundings.encounters import (
    Plan,
    Score,
    fence_clearance,
    ground_clearance,
    judge,
    no_heights,
    some_fence,
    some_plan,
)

HEIGHTS = os.environ.get("EPF_HEIGHTS", "")
GROUND, FENCE = 700, 300
QUIET_MINUTES = 1000
_KINDS = ("straight", "climbing", "turning")
_QUIET_KINDS = ("straight", "climbing", "turning", "wandering")
_MARGIN_M = 46.0
_FENCE_MARGIN_M = 30.0
_ZOOM = 11


class RealGround:
    """A raster as truth, and as the station's tiles of it."""

    def __init__(self, path: Path) -> None:
        from epf_gcs.maps.heights import Heights  # noqa: PLC0415 - GDAL, which is not everywhere

        self._raster = Heights(path, path.name)
        self.bounds = self._raster.bounds
        self._tiles: dict[tuple[int, int], np.ndarray] = {}
        self._true: dict[tuple[int, int], np.ndarray] = {}

    def station(self, latitude_deg: Vector, longitude_deg: Vector) -> Vector:
        """As the station reads its tiles; NaN: not known."""
        step_deg = 180.0 / (1 << _ZOOM) / CELLS
        x, y = (longitude_deg + 180.0) / step_deg, (latitude_deg + 90.0) / step_deg
        left, low = np.floor(x).astype(int), np.floor(y).astype(int)
        east, north = x - left, y - low
        columns, rows = left // CELLS, low // CELLS
        found = np.empty(latitude_deg.shape)
        for column, row in set(zip(columns.tolist(), rows.tolist(), strict=True)):
            here = (columns == column) & (rows == row)
            grid = self._tile(column, row)
            i, j = left[here] - column * CELLS, low[here] - row * CELLS
            lower = grid[j, i] * (1 - east[here]) + grid[j, i + 1] * east[here]
            upper = grid[j + 1, i] * (1 - east[here]) + grid[j + 1, i + 1] * east[here]
            found[here] = lower * (1 - north[here]) + upper * north[here]
        return found

    def true(self, latitude_deg: float, longitude_deg: float) -> float:
        """The raster, on a grid four times as fine as the tiles'; NaN where it has no data."""
        fine = 4 * (1 << _ZOOM) * CELLS / 180.0
        x, y = (longitude_deg + 180.0) * fine, (latitude_deg + 90.0) * fine
        left, low = math.floor(x), math.floor(y)
        key = (left // CELLS, low // CELLS)
        if key not in self._true:
            east_deg = (key[0] * CELLS + np.arange(SIDE)) / fine - 180.0
            north_deg = (key[1] * CELLS + np.arange(SIDE)) / fine - 90.0
            found = self._raster.at(east_deg, north_deg, 1.0 / fine)
            self._true[key] = np.where(self._raster.known(east_deg, north_deg, 1.0 / fine), found, np.nan)
        grid = self._true[key]
        i, j, east, north = left % CELLS, low % CELLS, x - left, y - low
        lower = grid[j, i] * (1 - east) + grid[j, i + 1] * east
        upper = grid[j + 1, i] * (1 - east) + grid[j + 1, i + 1] * east
        return float(lower * (1 - north) + upper * north)

    def _tile(self, column: int, row: int) -> np.ndarray:
        key = (column, row)
        if key not in self._tiles:
            longitudes_deg, latitudes_deg = tile_nodes(_ZOOM, column, row)
            step_deg = 180.0 / (1 << _ZOOM) / CELLS
            found = self._raster.at(longitudes_deg, latitudes_deg, step_deg)
            known = self._raster.known(longitudes_deg, latitudes_deg, step_deg)
            data = read_grid(encode_tile(_ZOOM, column, row, found, known))
            self._tiles[key] = np.frombuffer(data, "<f4").reshape(SIDE, SIDE)
        return self._tiles[key]


def run() -> list[Row]:
    """Encounters warned 30 s before, and quiet minutes warned."""
    if not HEIGHTS or not Path(HEIGHTS).is_file():
        return [Row("warnings of ground and fence: skipped, EPF_HEIGHTS names no raster of heights", 0.0, "")]
    ground = RealGround(Path(HEIGHTS))
    over_ground = measure_ground(ground, GROUND, QUIET_MINUTES)
    at_fence = measure_fence(FENCE, QUIET_MINUTES // 2)
    together = Score(
        over_ground.encounters + at_fence.encounters,
        over_ground.warned + at_fence.warned,
        over_ground.quiet + at_fence.quiet,
        over_ground.alarmed + at_fence.alarmed,
    )
    rows = [*_rows("ground", over_ground), *_rows("fence", at_fence)]
    return [
        Row(
            f"{together.encounters} made encounters with ground and fence warned 30 s before",
            together.warned_percent,
            "%",
            ">= 99",
            together.warned_percent >= 99.0,
        ),
        Row(
            f"{together.quiet} quiet minutes warned",
            together.alarmed_percent,
            "%",
            "<= 1",
            together.alarmed_percent <= 1.0,
        ),
        *rows,
    ]


def measure_ground(ground: RealGround, encounters: int, quiet: int) -> Score:
    """Flights over the raster's land."""
    wanted = WatchChoice(terrain=True, margin_m=_MARGIN_M)
    score = Score()
    clearance = ground_clearance(ground.true)
    seed = 0
    while score.encounters < encounters:
        seed += 1
        plan = _over_land(ground, seed, _KINDS[seed % len(_KINDS)], (70.0, 500.0))
        judge(plan, wanted, ground.station, clearance, _MARGIN_M, score, counts="encounters")
    seed = 1_000_000
    while score.quiet < quiet:
        seed += 1
        plan = _over_land(ground, seed, _QUIET_KINDS[seed % len(_QUIET_KINDS)], (70.0, 900.0))
        judge(plan, wanted, ground.station, clearance, _MARGIN_M, score, counts="quiet")
    return score


def measure_fence(encounters: int, quiet: int) -> Score:
    """Flights in fences of any shape."""
    score = Score()
    seed = 2_000_000
    while score.encounters < encounters or score.quiet < quiet:
        seed += 1
        counts = "encounters" if score.encounters < encounters else "quiet"
        place_deg, altitude_m = (28.0, -15.6), 500.0
        corners_deg, ceiling_m = some_fence(seed, place_deg, altitude_m)
        kinds = _KINDS if counts == "encounters" else _QUIET_KINDS
        plan = some_plan(seed, place_deg, altitude_m, kinds[seed % len(kinds)])
        wanted = WatchChoice(fence=True, corners_deg=corners_deg, ceiling_m=ceiling_m, fence_margin_m=_FENCE_MARGIN_M)
        clearance = fence_clearance(corners_deg, ceiling_m)
        judge(plan, wanted, no_heights, clearance, _FENCE_MARGIN_M, score, counts=counts)
    return score


def _over_land(ground: RealGround, seed: int, kind: str, above_m: tuple[float, float]) -> Plan:
    chance = random.Random(seed)
    bounds = ground.bounds
    while True:
        place_deg = (
            chance.uniform(bounds.south_deg, bounds.north_deg),
            chance.uniform(bounds.west_deg, bounds.east_deg),
        )
        height_m = ground.true(*place_deg)
        if height_m > 1.0:
            return some_plan(seed, place_deg, height_m + chance.uniform(*above_m), kind)


def _rows(what: str, score: Score) -> list[Row]:
    return [
        Row(f"{what}: {score.encounters} encounters warned 30 s before", score.warned_percent, "%"),
        Row(
            f"{what}: {score.quiet} quiet minutes warned, {score.alarmed} of them ({score.near_alarmed} of the "
            f"{score.near} near the margin); {score.avoided} more minutes in which the pilot turned away in time",
            score.alarmed_percent,
            "%",
        ),
    ]
