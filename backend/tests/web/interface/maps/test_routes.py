"""Maps over HTTP: the list, tiles as a browser keeps them, terrain as Cesium reads it, away and back."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import httpx
import pytest

from epf_gcs.maps.files import id_of
from tests.support.gateway import Gateway
from tests.support.maps import decode_mesh, png, write_mbtiles, write_pmtiles, write_raster
from tests.support.waiting import eventually

MBTILES, PMTILES = id_of("a.mbtiles"), id_of("b.pmtiles")


@pytest.fixture
def maps(gateway: Gateway) -> Path:
    folder = Path(gateway.http.get("/map/layers").raise_for_status().json()["folder"])
    eventually(folder.is_dir, "the folder is there for its owner to put files into")
    return folder


def layers(gateway: Gateway) -> dict[str, dict[str, Any]]:
    return {one["id"]: one for one in gateway.http.get("/map/layers").raise_for_status().json()["layers"]}


def get(gateway: Gateway, layer: str, path: str, **headers: str) -> httpx.Response:
    return gateway.http.get(f"/map/layers/{layer}/{path}", headers=headers)


def test_pictures_come_as_they_are_stored_and_nothing_where_there_is_none(gateway: Gateway, maps: Path) -> None:
    write_mbtiles(maps / "a.mbtiles", {(2, 1, 0): png(1)}, attribution="© IGN")
    write_pmtiles(maps / "b.pmtiles", {(1, 1, 0): png(2)})
    found = layers(gateway)
    assert (found[MBTILES]["kind"], found[MBTILES]["format"], found[MBTILES]["attribution"]) == (
        "imagery",
        "mbtiles",
        "© IGN",
    )
    assert (found[PMTILES]["name"], found[PMTILES]["south_deg"], found[PMTILES]["problem"]) == ("Canarias", 27.5, None)
    answer = get(gateway, MBTILES, "tiles/2/1/3")
    assert (answer.status_code, answer.headers["content-type"], answer.content) == (200, "image/png", png(1))
    assert get(gateway, PMTILES, "tiles/1/1/0").content == png(2)
    for path in ("tiles/2/0/0", "tiles/30/5/5", "tiles/2/2147483647/0"):
        assert (get(gateway, MBTILES, path).status_code, get(gateway, MBTILES, path).content) == (204, b"")
    assert get(gateway, MBTILES, "terrain/layer.json").status_code == 404
    assert gateway.status()["errors"] == {}


def test_a_browser_keeps_a_tile_until_the_file_changes(gateway: Gateway, maps: Path) -> None:
    write_mbtiles(maps / "a.mbtiles", {(0, 0, 0): png(1)})
    first = get(gateway, MBTILES, "tiles/0/0/0")
    tag = first.headers["etag"]
    assert "max-age=" in first.headers["cache-control"]
    again = get(gateway, MBTILES, "tiles/0/0/0", **{"If-None-Match": tag})
    assert (again.status_code, again.content, again.headers["etag"]) == (304, b"", tag)
    write_mbtiles(maps / "new.mbtiles", {(0, 0, 0): png(2)}, name="another").replace(maps / "a.mbtiles")
    changed = get(gateway, MBTILES, "tiles/0/0/0", **{"If-None-Match": tag})
    assert (changed.status_code, changed.content) == (200, png(2))


def test_a_file_that_cannot_be_read_is_listed_with_the_reason_and_counted_once(gateway: Gateway, maps: Path) -> None:
    (maps / "a.mbtiles").write_bytes(b"noise")
    for _ in range(3):
        found = layers(gateway)[MBTILES]
        assert found["problem"].startswith("'a.mbtiles' cannot be read")
        assert (found["problem_code"], found["problem_params"]["name"]) == ("map_file_damaged", "a.mbtiles")
    assert gateway.status()["errors"] == {"map_file_damaged": 1}
    assert get(gateway, MBTILES, "tiles/0/0/0").json()["code"] == "map_file_damaged"


@pytest.mark.parametrize("layer", ["nothing-00000000", "..", "a.mbtiles", "%2e%2e%2fstate.json"])
def test_what_is_no_layer_gives_nothing(gateway: Gateway, maps: Path, layer: str) -> None:
    write_mbtiles(maps / "a.mbtiles", {(0, 0, 0): png(1)})
    assert get(gateway, layer, "tiles/0/0/0").status_code in (404, 422)


def test_heights_put_into_the_folder_become_terrain_that_cesium_can_read(gateway: Gateway, maps: Path) -> None:
    write_raster(maps / "isla.tif", lambda x, _: 1000 + 100 * (x + 15.5), size=60)
    layer = id_of("isla.tif")
    assert layers(gateway)[layer]["problem_code"] == "map_raster_converting"
    eventually(lambda: layers(gateway)[layer]["problem"] is None, "it is turned into terrain")
    found = layers(gateway)[layer]
    assert (found["kind"], found["format"], found["name"]) == ("terrain", "geotiff", "isla")
    contents = get(gateway, layer, "terrain/layer.json").raise_for_status().json()
    assert (contents["format"], contents["scheme"], contents["projection"]) == (
        "quantized-mesh-1.0",
        "tms",
        "EPSG:4326",
    )
    assert contents["tiles"] == ["{z}/{x}/{y}.terrain?v={version}"]
    assert contents["available"][0] == [{"startX": 0, "startY": 0, "endX": 1, "endY": 0}]
    assert len(contents["available"]) == contents["maxzoom"] + 1
    (place,) = contents["available"][-1]
    tile = get(gateway, layer, f"terrain/{contents['maxzoom']}/{place['startX']}/{place['startY']}.terrain")
    assert (tile.status_code, tile.headers["content-encoding"]) == (200, "gzip")
    assert tile.headers["content-type"] == "application/vnd.quantized-mesh"
    assert 1000 < decode_mesh(tile.content).highest_m < 1013
    missing = get(gateway, layer, "terrain/9/0/0.terrain")
    assert (missing.status_code, missing.json()["code"]) == (404, "map_tile_missing")
    assert get(gateway, layer, "tiles/0/0/0").status_code == 204
    assert gateway.status()["errors"] == {}, "looking for terrain where there is none is no fault"


def test_a_layer_goes_and_comes_back(gateway: Gateway, maps: Path) -> None:
    write_mbtiles(maps / "a.mbtiles", {(0, 0, 0): png(1)})
    left = gateway.http.delete(f"/map/layers/{MBTILES}").raise_for_status().json()
    assert left["layers"] == []
    assert get(gateway, MBTILES, "tiles/0/0/0").status_code == 404
    assert gateway.http.delete(f"/map/layers/{MBTILES}").json()["code"] == "map_layer_unknown"
    back = gateway.http.post(f"/map/layers/{MBTILES}/restore").raise_for_status().json()
    assert [one["id"] for one in back["layers"]] == [MBTILES]
    assert gateway.http.post(f"/map/layers/{MBTILES}/restore").json()["code"] == "map_layer_unknown"


def test_who_has_no_control_cannot_remove(gateway: Gateway, maps: Path) -> None:
    write_mbtiles(maps / "a.mbtiles", {(0, 0, 0): png(1)})
    with gateway.stream():
        assert gateway.http.delete(f"/map/layers/{MBTILES}").json()["code"] == "control_held"
        assert gateway.http.post(f"/map/layers/{MBTILES}/restore").json()["code"] == "control_held"
    assert list(layers(gateway)) == [MBTILES]
