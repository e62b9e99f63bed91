"""The folder: names that lead nowhere, what is in it and why not, away and back."""

from __future__ import annotations

import zipfile
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.errors import GatewayError
from epf_gcs.maps.files import id_of, look_at, safe_name
from epf_gcs.maps.folder import MapFolder
from tests.support.maps import png, write_hgt, write_mbtiles, write_pmtiles, write_raster


@pytest.fixture
def reported() -> list[GatewayError]:
    return []


@pytest.fixture
def folder(tmp_path: Path, reported: list[GatewayError]) -> Iterator[MapFolder]:
    (tmp_path / "maps").mkdir()
    made = MapFolder(tmp_path / "maps", reported.append)
    yield made
    made.close()


def codes(folder: MapFolder) -> dict[str, str | None]:
    return {layer.name: None if layer.problem is None else layer.problem.code for layer in folder.layers()}


@given(st.text(max_size=25))
def test_no_name_leads_out_of_the_folder(name: str) -> None:
    cleaned = safe_name(f"x{name}.tif")
    path = Path("/maps") / cleaned
    assert path.parent == path.resolve().parent == Path("/maps")
    assert cleaned.endswith(".tif")


@pytest.mark.parametrize("name", ["", "..", ".tif", "  .mbtiles", "\u0000", "x" * 200 + ".tif", "../../", "a/b.exe"])
def test_a_name_that_says_nothing_is_refused(name: str) -> None:
    with pytest.raises(GatewayError) as caught:
        safe_name(name)
    assert caught.value.code in ("map_name_invalid", "map_kind_unknown")


@pytest.mark.parametrize(
    ("name", "cleaned"),
    [
        ("../../etc/x.tif", "_.._etc_x.tif"),
        ("C:\\maps\\Isla Peña.MBTILES", "C__maps_Isla Peña.MBTILES"),
        (".a.tif", "a.tif"),
    ],
)
def test_a_name_from_another_system_becomes_one_of_ours(name: str, cleaned: str) -> None:
    assert safe_name(name) == cleaned


@given(st.lists(st.text(min_size=1, max_size=60), unique=True, max_size=30))
def test_every_name_has_an_id_of_its_own_that_fits_an_address(names: list[str]) -> None:
    ids = [id_of(name) for name in names]
    assert len(set(ids)) == len(names)
    assert all(set(one) <= set("abcdefghijklmnopqrstuvwxyz0123456789-") and len(one) <= 64 for one in ids)


def test_everything_that_looks_like_a_map_is_listed_by_name(folder: MapFolder, reported: list[GatewayError]) -> None:
    write_mbtiles(folder.path / "b.mbtiles", {(0, 0, 0): png(1)}, name="Gando")
    write_pmtiles(folder.path / "c.pmtiles", {(0, 0, 0): png(1)})
    (folder.path / "a.mbtiles").write_bytes(b"noise")
    (folder.path / "notes.txt").write_text("no map")
    (folder.path / ".hidden.mbtiles").write_text("no map")
    (folder.path / "photos").mkdir()
    assert codes(folder) == {"a.mbtiles": "map_file_damaged", "Gando": None, "Canarias": None}
    assert codes(folder) == {"a.mbtiles": "map_file_damaged", "Gando": None, "Canarias": None}
    assert [error.code for error in reported] == ["map_file_damaged"], "it is told once"
    sizes = {layer.name: layer.size_bytes for layer in folder.layers()}
    assert sizes["Gando"] == (folder.path / "b.mbtiles").stat().st_size


def test_a_file_that_is_mended_is_looked_at_again(folder: MapFolder) -> None:
    path = folder.path / "a.mbtiles"
    path.write_bytes(b"noise")
    assert codes(folder) == {"a.mbtiles": "map_file_damaged"}
    path.unlink()
    write_mbtiles(path, {(0, 0, 0): png(1)})
    assert codes(folder) == {"a": None}
    tile, _, _ = folder.tile(id_of("a.mbtiles"), 0, 0, 0)
    assert tile is not None
    write_mbtiles(folder.path / "new.mbtiles", {(0, 0, 0): png(9)}).replace(path)
    tile, _, _ = folder.tile(id_of("a.mbtiles"), 0, 0, 0)
    assert tile is not None
    assert tile.data == png(9)


def test_heights_wait_for_their_terrain(folder: MapFolder) -> None:
    write_raster(folder.path / "a.tif", lambda x, _: x)
    write_hgt(folder.path / "N27W016.hgt", lambda x, _: x, size=1201)
    assert codes(folder) == {"a.tif": "map_raster_converting", "N27W016.hgt": "map_raster_converting"}
    assert sorted(file.path.name for file in folder.unconverted()) == ["N27W016.hgt", "a.tif"]
    file = look_at(folder.path / "a.tif", lambda *_: None)
    assert file is not None
    terrain = folder.terrain_of(file)
    terrain.parent.mkdir()
    write_mbtiles(terrain, {(0, 0, 0): b"x", (0, 1, 0): b"y"}, format="quantized-mesh-1.0")
    assert codes(folder)["a"] is None
    assert [file.path.name for file in folder.unconverted()] == ["N27W016.hgt"]
    folder.drop_orphans()
    assert terrain.exists()
    folder.remove(file.id)
    folder.drop_orphans()
    assert terrain.exists(), "it may come back"
    (folder.path / "removed" / "a.tif").unlink()
    folder.drop_orphans()
    assert not terrain.exists()


def test_an_archive_with_one_raster_is_heights(folder: MapFolder, tmp_path: Path) -> None:
    raster = write_raster(tmp_path / "a.tif", lambda x, _: x)
    for name, inside in (("one.zip", ["dem/a.tif"]), ("two.zip", ["a.tif", "b.tif"])):
        with zipfile.ZipFile(folder.path / name, "w") as archive:
            for one in inside:
                archive.write(raster, one)
    assert codes(folder) == {"one.zip": "map_raster_converting", "two.zip": "map_file_no_layer_json"}
    (file,) = folder.unconverted()
    assert (file.format, file.inside) == ("geotiff", "dem/a.tif")


def test_what_is_removed_comes_back(folder: MapFolder) -> None:
    path = write_mbtiles(folder.path / "a.mbtiles", {(0, 0, 0): png(1)})
    folder.tile(id_of("a.mbtiles"), 0, 0, 0)
    folder.remove(id_of("a.mbtiles"))
    assert codes(folder) == {}
    assert (folder.path / "removed" / "a.mbtiles").exists()
    with pytest.raises(GatewayError):
        folder.tile(id_of("a.mbtiles"), 0, 0, 0)
    folder.restore(id_of("a.mbtiles"))
    assert codes(folder) == {"a": None}
    assert path.exists()


def test_removing_another_of_the_same_name_loses_neither(folder: MapFolder) -> None:
    for grey in (1, 2):
        write_mbtiles(folder.path / "a.mbtiles", {(0, 0, 0): png(grey)})
        folder.remove(id_of("a.mbtiles"))
    assert sorted(file.name for file in (folder.path / "removed").iterdir()) == ["a-2.mbtiles", "a.mbtiles"]
    write_mbtiles(folder.path / "a.mbtiles", {(0, 0, 0): png(3)})
    with pytest.raises(GatewayError) as caught:
        folder.restore(id_of("a.mbtiles"))
    assert caught.value.code == "map_exists"


def test_what_is_not_there_is_said_so(folder: MapFolder) -> None:
    for act in (folder.remove, folder.restore, folder.description):
        with pytest.raises(GatewayError) as caught:
            act("nothing-00000000")
        assert caught.value.code == "map_layer_unknown"
