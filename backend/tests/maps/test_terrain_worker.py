"""From a raster to terrain: the heights of the raster, whole or not at all, and no crack at any level."""

from __future__ import annotations

import gzip
import sqlite3
import subprocess
import sys
from contextlib import closing
from pathlib import Path
from typing import Any

import numpy as np
import orjson
import pytest

from epf_gcs.errors import GatewayError
from epf_gcs.formats.quantized_mesh import tile_bounds
from epf_gcs.maps.layer import Bounds
from epf_gcs.maps.mbtiles import MbTiles
from epf_gcs.maps.terrain_worker import MOST_TILES, convert, highest_zoom
from tests.support.maps import Mesh, decode_mesh, write_raster
from tests.support.waiting import DEADLINE_S


def hills(x: Any, y: Any) -> Any:
    return 900 + 500 * np.sin((x + 15.5) * 12) * np.cos((y - 27.6) * 9)


@pytest.fixture(scope="module")
def terrain(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("terrain")
    percents: list[int] = []
    convert(write_raster(folder / "a.tif", hills), folder / "a.mbtiles", "a.tif", None, percents.append)
    assert percents[0] == 0
    assert percents == sorted(set(percents))
    assert sorted(file.name for file in folder.iterdir()) == ["a.mbtiles", "a.tif"]
    return folder / "a.mbtiles"


def tiles(path: Path) -> dict[tuple[int, int, int], Mesh]:
    with closing(sqlite3.connect(path)) as file:
        return {
            (zoom, column, row): decode_mesh(gzip.decompress(data))
            for zoom, column, row, data in file.execute("SELECT * FROM tiles")
        }


def test_the_finest_level_has_the_heights_of_the_raster(terrain: Path) -> None:
    found = tiles(terrain)
    finest = max(zoom for zoom, _, _ in found)
    assert finest == 10, "0.0027 degrees between points, for pixels of 0.002"
    checked = 0
    for (zoom, column, row), mesh in found.items():
        bounds = tile_bounds(zoom, column, row)
        longitude = bounds.west_deg + mesh.u * (bounds.east_deg - bounds.west_deg)
        latitude = bounds.south_deg + mesh.v * (bounds.north_deg - bounds.south_deg)
        well_inside = (abs(longitude + 15.3) < 0.19) & (abs(latitude - 27.8) < 0.19)
        error_m = np.abs(mesh.height_m - hills(longitude, latitude))[well_inside]
        if zoom == finest and error_m.size:
            assert error_m.max() < 1.0
            checked += error_m.size
        outside = (abs(longitude + 15.3) > 0.201) | (abs(latitude - 27.8) > 0.201)
        if zoom == finest:
            assert np.abs(mesh.height_m[outside]).max(initial=0.0) < 0.1, "the sea around"
    assert checked > 15_000


def test_a_raster_of_a_projection_that_has_no_poles_becomes_terrain_down_to_the_whole_earth(tmp_path: Path) -> None:
    """The tiles of level 0 reach half around the Earth, where UTM has no answer."""
    raster = write_raster(
        tmp_path / "utm.tif", lambda x, _: 0 * x + 700.0, west=440_000, north=3_100_000, step=200, crs="EPSG:32628"
    )
    convert(raster, tmp_path / "o", "utm.tif", None, lambda _: None)
    found = tiles(tmp_path / "o")
    assert {zoom for zoom, _, _ in found} == set(range(max(found)[0] + 1))
    assert all(mesh.lowest_m == 0.0 for (zoom, _, _), mesh in found.items() if zoom < 5)
    assert max(mesh.highest_m for mesh in found.values()) == pytest.approx(700.0)


def test_there_is_no_crack_between_neighbours_of_any_level(terrain: Path) -> None:
    found = tiles(terrain)
    pairs = 0
    for (zoom, column, row), here in found.items():
        for edge, other in ((2, (zoom, column + 1, row)), (3, (zoom, column, row + 1))):
            there = found.get(other)
            if there is not None:
                ours, theirs = here.height_m[here.edges[edge]], there.height_m[there.edges[edge - 2]]
                assert np.abs(ours - theirs).max() <= max(here.highest_m, there.highest_m) / 32767
                pairs += 1
    assert pairs > 15


def test_both_roots_and_every_parent_are_there(terrain: Path) -> None:
    found = set(tiles(terrain))
    assert {(0, 0, 0), (0, 1, 0)} <= found
    assert all(zoom == 0 or (zoom - 1, column // 2, row // 2) in found for zoom, column, row in found)
    source = MbTiles(terrain, "a")
    about = source.description
    assert (about.kind, about.maximum_zoom) == ("terrain", 10)
    assert about.bounds == pytest.approx((-15.5, 27.6, -15.1, 28.0))
    source.close()


def test_a_raster_that_is_cut_off_leaves_nothing(tmp_path: Path) -> None:
    path = write_raster(tmp_path / "a.tif", hills)
    path.write_bytes(path.read_bytes()[:40_000])
    with pytest.raises(GatewayError) as caught:
        convert(path, tmp_path / "a.mbtiles", "a.tif", None, lambda _: None)
    assert caught.value.code == "map_file_damaged"
    assert [file.name for file in tmp_path.iterdir()] == ["a.tif"]


def test_a_fine_raster_of_a_large_area_is_kept_as_finely_as_there_is_room() -> None:
    assert highest_zoom(Bounds(-16, 27, -15, 28), 1 / 3600) == 13
    assert highest_zoom(Bounds(-15.4, 27.9, -15.3, 28.0), 1e-6) == 18
    europe = highest_zoom(Bounds(-15, 30, 30, 60), 1e-5)
    assert 45 * 30 / (180 / 2**europe) ** 2 < MOST_TILES * 1.05 < 4 * 1.05 * 45 * 30 / (180 / 2**europe) ** 2
    assert highest_zoom(Bounds(-180, -90, 180, 90), 10.0) == 0


def test_the_process_tells_its_percents_or_its_problem(tmp_path: Path) -> None:
    write_raster(tmp_path / "a.tif", hills, size=40)
    (tmp_path / "b.tif").write_bytes(b"no")

    def run(name: str) -> tuple[int, list[dict[str, Any]]]:
        worker = [sys.executable, "-m", "epf_gcs.maps.terrain_worker"]
        done = subprocess.run(
            [*worker, str(tmp_path / name), str(tmp_path / f"{name}.mbtiles"), name, ""],
            capture_output=True,
            timeout=DEADLINE_S,
            check=False,
        )
        return done.returncode, [orjson.loads(line) for line in done.stdout.splitlines()]

    code, messages = run("a.tif")
    assert (code, messages[0]) == (0, {"percent": 0})
    code, messages = run("b.tif")
    fault = messages[-1]["fault"]
    assert (code, fault["code"], fault["params"]["name"]) == (1, "map_file_damaged", "b.tif")
