"""Made flights over made mountains: warned in time, and not when nothing is ahead. `make bench`: over real ones."""

from __future__ import annotations

import random

import numpy as np
import pytest

from epf_gcs.formats.quantized_mesh import CELLS, encode_tile, tile_nodes
from epf_gcs.formats.quantized_mesh_reading import SIDE, read_grid
from epf_gcs.surroundings.aircraft import WatchChoice
from epf_gcs.surroundings.motion import Vector
from tests.surroundings.encounters import (
    Score,
    fence_clearance,
    ground_clearance,
    judge,
    no_heights,
    some_fence,
    some_plan,
)

MARGIN_M = 46.0
ZOOM = 12
MIDDLE = (27.95, -15.3)


def mountains_m(north: Vector, east: Vector) -> Vector:
    """Ridges and summits a few kilometres apart, up to 1,300 m."""
    y, x = (north - MIDDLE[0]) * 111.0, (east - MIDDLE[1]) * 98.0
    ridges = np.sin(x / 1.9 + 0.7 * np.sin(y / 2.3)) * np.cos(y / 2.7 + 0.4 * np.cos(x / 3.1))
    return np.asarray(650.0 + 650.0 * ridges, dtype=np.float64)


def true_m(latitude_deg: float, longitude_deg: float) -> float:
    return float(mountains_m(np.array(latitude_deg), np.array(longitude_deg)))


class Station:
    """The mountains as the station's own tiles of them."""

    def __init__(self) -> None:
        self._grids: dict[tuple[int, int], np.ndarray] = {}

    def heights(self, latitude_deg: Vector, longitude_deg: Vector) -> Vector:
        step_deg = 180.0 / (1 << ZOOM) / CELLS
        x, y = (longitude_deg + 180.0) / step_deg, (latitude_deg + 90.0) / step_deg
        found = np.empty(latitude_deg.shape)
        for index in range(found.size):
            left, low = int(x[index]), int(y[index])
            key = (left // CELLS, low // CELLS)
            if key not in self._grids:
                longitudes_deg, latitudes_deg = tile_nodes(ZOOM, *key)
                heights_m = mountains_m(latitudes_deg[:, None], longitudes_deg[None, :])
                data = read_grid(encode_tile(ZOOM, *key, heights_m))
                self._grids[key] = np.frombuffer(data, "<f4").reshape(SIDE, SIDE)
            grid, i, j = self._grids[key], left % CELLS, low % CELLS
            east, north = x[index] - left, y[index] - low
            lower = grid[j, i] * (1 - east) + grid[j, i + 1] * east
            upper = grid[j + 1, i] * (1 - east) + grid[j + 1, i + 1] * east
            found[index] = lower * (1 - north) + upper * north
        return found


def a_place(seed: int, above_m: tuple[float, float]) -> tuple[tuple[float, float], float]:
    chance = random.Random(seed)
    place = (MIDDLE[0] + chance.uniform(-0.05, 0.05), MIDDLE[1] + chance.uniform(-0.05, 0.05))
    return place, true_m(*place) + chance.uniform(*above_m)


@pytest.mark.uncounted
def test_ground_ahead_is_warned_of_half_a_minute_before_and_quiet_flights_are_not_disturbed() -> None:
    station, score = Station(), Score()
    clearance = ground_clearance(true_m)
    wanted = WatchChoice(terrain=True, margin_m=MARGIN_M)
    seed = 0
    while score.encounters < 16:
        seed += 1
        place, altitude_m = a_place(seed, (70.0, 500.0))
        plan = some_plan(seed, place, altitude_m, ("straight", "climbing", "turning")[seed % 3])
        judge(plan, wanted, station.heights, clearance, MARGIN_M, score, counts="encounters")
    while score.quiet < 16:
        seed += 1
        place, altitude_m = a_place(seed, (70.0, 900.0))
        plan = some_plan(seed, place, altitude_m, ("straight", "turning", "wandering")[seed % 3])
        judge(plan, wanted, station.heights, clearance, MARGIN_M, score, counts="quiet")
    assert score.warned >= 15
    assert score.alarmed <= 1


@pytest.mark.uncounted
def test_the_fence_is_warned_of_half_a_minute_before_and_flights_inside_are_not_disturbed() -> None:
    score = Score()
    seed = 500
    while score.encounters < 10 or score.quiet < 10:
        seed += 1
        counts = "encounters" if score.encounters < 10 else "quiet"
        corners, ceiling_m = some_fence(seed, MIDDLE, 500.0)
        plan = some_plan(seed, MIDDLE, 500.0, ("straight", "climbing", "turning")[seed % 3])
        wanted = WatchChoice(fence=True, corners_deg=corners, ceiling_m=ceiling_m, fence_margin_m=30.0)
        judge(plan, wanted, no_heights, fence_clearance(corners, ceiling_m), 30.0, score, counts=counts)
    assert score.warned >= 9
    assert score.alarmed <= 1
