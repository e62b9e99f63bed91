"""What heights count from: read from the set, else as chosen; the same ground is the same above either datum."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from epf_gcs.contract.surroundings import HeightSet
from epf_gcs.errors import GatewayError, NotFoundError
from epf_gcs.formats.quantized_mesh import encode_tile, tile_nodes
from epf_gcs.geoid import geoid_m
from epf_gcs.maps.datum import stated_datum
from epf_gcs.maps.folder import MapFolder
from epf_gcs.maps.heights import Heights
from epf_gcs.maps.layer import Layer
from epf_gcs.surroundings.ground import Ground
from tests.support.maps import write_hgt, write_mbtiles, write_raster

ZOOM, COLUMN, ROW = 8, 234, 167
SIZE_DEG = 180.0 / (1 << ZOOM)
NORTH = np.array([ROW * SIZE_DEG - 90.0 + SIZE_DEG * share for share in (0.1, 0.45, 0.9)])
EAST = np.array([COLUMN * SIZE_DEG - 180.0 + SIZE_DEG * share for share in (0.7, 0.3, 0.2)])


def ground_m(latitude_deg: Any, longitude_deg: Any) -> Any:
    """Metres above the sea."""
    return 700 + 500 * (latitude_deg - NORTH[0]) + 300 * (longitude_deg - EAST[0])


def tile(*, ellipsoidal: bool) -> bytes:
    longitude_deg, latitude_deg = np.meshgrid(*tile_nodes(ZOOM, COLUMN, ROW))
    above_m = geoid_m(latitude_deg, longitude_deg) if ellipsoidal else 0.0
    return encode_tile(ZOOM, COLUMN, ROW, ground_m(latitude_deg, longitude_deg) + above_m)


def write_set(path: Path, *, ellipsoidal: bool, **metadata: str) -> Path:
    data = {(ZOOM, COLUMN, ROW): tile(ellipsoidal=ellipsoidal)}
    return write_mbtiles(path, data, format="quantized-mesh-1.0", minzoom="0", maxzoom=str(ZOOM), **metadata)


class FolderTiles:
    """The folder as the maps give it; waits where they use a thread."""

    def __init__(self, folder: MapFolder) -> None:
        self._folder = folder

    async def terrain_layers(self) -> list[Layer]:
        return [one for one in self._folder.layers() if one.problem is None]

    async def grid(self, layer_id: str, zoom: int, column: int, row: int) -> bytes | None:
        return self._folder.grid(layer_id, zoom, column, row)


@pytest.fixture
def folder(tmp_path: Path) -> Iterator[MapFolder]:
    made = MapFolder(tmp_path, lambda _: None)
    yield made
    made.close()


def heights(folder: MapFolder) -> tuple[Any, HeightSet]:
    """The ground at NORTH, EAST, and the set that it is of."""

    async def read() -> tuple[Any, HeightSet]:
        ground = Ground(FolderTiles(folder))
        found_m = await ground.read(NORTH, EAST)
        (one,) = ground.sets(NORTH, EAST)
        return found_m, one

    return asyncio.run(read())


@pytest.mark.parametrize("datum", ["orthometric", "ellipsoidal"])
def test_the_same_ground_is_as_high_from_a_set_of_either_datum(tmp_path: Path, folder: MapFolder, datum: str) -> None:
    write_set(tmp_path / "a.mbtiles", ellipsoidal=datum == "ellipsoidal", vertical_datum=datum)
    found_m, judged_by = heights(folder)
    np.testing.assert_allclose(found_m, ground_m(NORTH, EAST), atol=2.0)
    assert (judged_by.name, judged_by.datum) == ("a", datum)
    assert judged_by.geoid_m == pytest.approx(max(geoid_m(NORTH, EAST)), abs=0.06)


def test_a_set_that_says_nothing_is_asked_for_once_and_then_right(tmp_path: Path, folder: MapFolder) -> None:
    write_set(tmp_path / "a.mbtiles", ellipsoidal=True)
    (layer,) = folder.layers()
    assert (layer.datum, layer.description.datum) == (None, None)
    assert heights(folder)[1].datum is None, "and until then it is said to be unknown"
    _, _, stamp = folder.tile(layer.id, ZOOM, COLUMN, ROW)
    folder.choose_datum(layer.id, "ellipsoidal")
    # Kept with the set, also over a restart of the station.
    again = MapFolder(tmp_path, lambda _: None)
    assert [one.datum for one in again.layers()] == ["ellipsoidal"]
    again.close()
    found_m, judged_by = heights(folder)
    np.testing.assert_allclose(found_m, ground_m(NORTH, EAST), atol=2.0)
    assert judged_by.datum == "ellipsoidal"
    # A browser that keeps the tile as it was asks for the other one.
    assert folder.tile(layer.id, ZOOM, COLUMN, ROW)[2] != stamp


def test_another_file_of_the_same_name_is_asked_for_again(tmp_path: Path, folder: MapFolder) -> None:
    path = write_set(tmp_path / "a.mbtiles", ellipsoidal=True)
    (layer,) = folder.layers()
    folder.choose_datum(layer.id, "ellipsoidal")
    path.unlink()
    write_set(path, ellipsoidal=False, name="another one")
    assert [one.datum for one in folder.layers()] == [None]


def test_a_damaged_choice_is_asked_for_again(tmp_path: Path) -> None:
    write_set(tmp_path / "a.mbtiles", ellipsoidal=True)
    (tmp_path / ".heights.json").write_text('{"a": [[1], "sideways"]}')
    folder = MapFolder(tmp_path, lambda _: None)
    assert [one.datum for one in folder.layers()] == [None]
    folder.close()


def test_no_datum_is_chosen_for_a_set_that_is_not_there(folder: MapFolder) -> None:
    with pytest.raises(NotFoundError):
        folder.choose_datum("a-mbtiles-00000000", "ellipsoidal")


def test_a_choice_that_the_disk_refuses_is_none(tmp_path: Path, folder: MapFolder) -> None:
    write_set(tmp_path / "a.mbtiles", ellipsoidal=True)
    (layer,) = folder.layers()
    (tmp_path / ".heights.json").mkdir()
    with pytest.raises(GatewayError) as caught:
        folder.choose_datum(layer.id, "ellipsoidal")
    assert caught.value.code == "map_not_written"
    assert [one.datum for one in folder.layers()] == [None]


@pytest.mark.parametrize(
    ("metadata", "datum"),
    [
        ({"vertical_datum": "ellipsoidal"}, "ellipsoidal"),
        ({"verticalDatum": "EGM96"}, "orthometric"),
        ({"heightReference": "WGS84 ellipsoid"}, "ellipsoidal"),
        ({"verticalDatum": "EPSG:3855"}, "orthometric"),
        ({"verticalDatum": "the roof of our house"}, None),
        ({"name": "ellipsoid"}, None),
        ({}, None),
    ],
)
def test_what_a_set_states_is_read(metadata: dict[str, str], datum: str | None) -> None:
    assert stated_datum(metadata) == datum


def test_a_layer_json_that_states_it_is_read(tmp_path: Path, folder: MapFolder) -> None:
    top = tmp_path / "mesh"
    (top / str(ZOOM) / str(COLUMN)).mkdir(parents=True)
    (top / str(ZOOM) / str(COLUMN) / f"{ROW}.terrain").write_bytes(tile(ellipsoidal=True))
    contents = {"format": "quantized-mesh-1.0", "scheme": "tms", "maxzoom": ZOOM, "heightReference": "ellipsoid"}
    (top / "layer.json").write_text(json.dumps(contents))
    assert [one.datum for one in folder.layers()] == ["ellipsoidal"]
    np.testing.assert_allclose(heights(folder)[0], ground_m(NORTH, EAST), atol=2.0)


@pytest.mark.parametrize(
    ("crs", "datum"),
    [
        ("EPSG:4326", None),
        ("EPSG:4326+5773", "orthometric"),
        ("EPSG:4326+3855", "orthometric"),
        ("EPSG:32628+5773", "orthometric"),
        ("EPSG:4979", "ellipsoidal"),
    ],
)
def test_the_vertical_system_of_a_geotiff_is_read(tmp_path: Path, crs: str, datum: str | None) -> None:
    def level(x: Any, _y: Any) -> Any:
        return x * 0 + 5.0

    place: dict[str, Any] = (
        {"west": 440_000.0, "north": 3_090_000.0, "step": 30.0} if crs.startswith("EPSG:326") else {}
    )
    opened = Heights(write_raster(tmp_path / "a.tif", level, crs=crs, **place), "a.tif")
    assert opened.datum == datum
    opened.close()


def test_a_file_of_srtm_counts_from_the_sea(tmp_path: Path) -> None:
    flat: Callable[[Any, Any], Any] = lambda x, _y: x * 0 + 5.0  # noqa: E731
    opened = Heights(write_hgt(tmp_path / "N28W016.hgt", flat), "N28W016.hgt")
    assert opened.datum == "orthometric"
    opened.close()
