"""MBTiles: rows from the other end, what is in it counts and not what it says, and no file can hang the station."""

from __future__ import annotations

import os
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest

from epf_gcs.errors import GatewayError
from epf_gcs.maps.layer import Bounds, Range
from epf_gcs.maps.mbtiles import MbTiles
from tests.support.maps import png, write_mbtiles

JPEG = b"\xff\xd8\xff\xe0rest"
WEBP = b"RIFF\x08\x00\x00\x00WEBPVP8 "


def fault(path: Path) -> str:
    with pytest.raises(GatewayError) as caught:
        MbTiles(path, path.name)
    assert path.name in caught.value.detail
    return caught.value.code


def test_rows_are_asked_for_from_the_north_and_lie_from_the_south(tmp_path: Path) -> None:
    source = MbTiles(write_mbtiles(tmp_path / "a.mbtiles", {(2, 1, 0): png(1), (2, 1, 3): png(2)}), "a")
    south, north = source.tile(2, 1, 3), source.tile(2, 1, 0)
    assert south is not None
    assert north is not None
    assert (south.data, north.data) == (png(1), png(2))
    assert (source.tile(2, 0, 0), source.tile(9, 1, 0)) == (None, None)
    source.close()


@pytest.mark.parametrize(("data", "media_type"), [(png(3), "image/png"), (JPEG, "image/jpeg"), (WEBP, "image/webp")])
def test_the_kind_of_a_picture_is_what_it_is(tmp_path: Path, data: bytes, media_type: str) -> None:
    source = MbTiles(write_mbtiles(tmp_path / "a.mbtiles", {(0, 0, 0): data}, format="pbf"), "a")
    tile = source.tile(0, 0, 0)
    assert tile is not None
    assert (tile.media_type, tile.encoding) == (media_type, None)
    source.close()


def test_whose_work_it_is_is_told_in_words_and_not_in_markup(tmp_path: Path) -> None:
    said = '&copy; <a href="https://osm.org/" target=_blank>OpenStreetMap\n contributors</a>'
    source = MbTiles(write_mbtiles(tmp_path / "a.mbtiles", {(0, 0, 0): png(1)}, attribution=said), "a")
    assert source.description.attribution == "© OpenStreetMap contributors"
    source.close()


def test_what_the_file_says_of_itself_is_told(tmp_path: Path) -> None:
    path = write_mbtiles(
        tmp_path / "a.mbtiles",
        {(10, 470, 590): png(1)},
        name="Gando",
        bounds="-15.5,27.8,-15.3,28.0",
        minzoom="8",
        maxzoom="14",
        attribution="© IGN",
    )
    source = MbTiles(path, "a")
    found = source.description
    assert (found.title, found.kind, found.attribution) == ("Gando", "imagery", "© IGN")
    assert (found.bounds, found.minimum_zoom, found.maximum_zoom) == (Bounds(-15.5, 27.8, -15.3, 28.0), 8, 14)
    source.close()


@pytest.mark.parametrize(
    "said", [{}, {"bounds": "1,2", "minzoom": "x"}, {"bounds": "10,0,-10,5", "minzoom": "9", "maxzoom": "3"}]
)
def test_what_it_does_not_say_is_found_in_its_tiles(tmp_path: Path, said: dict[str, str]) -> None:
    tiles = {(4, 7, 9): png(1), (4, 7, 10): png(2), (2, 1, 2): png(3)}
    source = MbTiles(write_mbtiles(tmp_path / "a.mbtiles", tiles, **said), "a")
    found = source.description
    assert (found.minimum_zoom, found.maximum_zoom) == (2, 4)
    assert found.bounds == pytest.approx((-22.5, 21.943, 0.0, 55.776), abs=1e-3)
    source.close()


def test_terrain_is_known_by_its_format_and_keeps_its_rows(tmp_path: Path) -> None:
    tiles = {(0, 0, 0): b"\x1f\x8bpacked", (0, 1, 0): b"plain", (3, 2, 5): b"x"}
    source = MbTiles(write_mbtiles(tmp_path / "a.mbtiles", tiles, format="quantized-mesh-1.0"), "a")
    found = source.description
    assert (found.kind, found.bounds) == ("terrain", Bounds(-135.0, 22.5, -112.5, 45.0))
    assert found.available == ((Range(0, 0, 1, 0),), (), (), (Range(2, 5, 2, 5),))
    packed, plain = source.tile(0, 0, 0), source.tile(0, 1, 0)
    assert packed is not None
    assert plain is not None
    assert (packed.encoding, plain.encoding) == ("gzip", None)
    assert source.tile(3, 2, 2) is None
    source.close()


def test_vector_tiles_are_refused_in_words(tmp_path: Path) -> None:
    path = write_mbtiles(tmp_path / "streets.mbtiles", {(0, 0, 0): b"\x1f\x8b\x08pbf"}, format="pbf")
    assert fault(path) == "map_file_vector"


def test_a_file_without_tiles_or_of_another_kind_is_refused(tmp_path: Path) -> None:
    assert fault(write_mbtiles(tmp_path / "none.mbtiles", {})) == "map_file_empty"
    for name, content in (("empty.mbtiles", b""), ("noise.mbtiles", os.urandom(5000))):
        (tmp_path / name).write_bytes(content)
        assert fault(tmp_path / name) == "map_file_damaged"
    whole = write_mbtiles(tmp_path / "cut.mbtiles", {(5, x, 0): png(x) * 300 for x in range(30)})
    whole.write_bytes(whole.read_bytes()[:9000])
    assert fault(whole) == "map_file_damaged"


def test_nothing_is_left_beside_the_file_and_it_is_not_written(tmp_path: Path) -> None:
    path = write_mbtiles(tmp_path / "a.mbtiles", {(0, 0, 0): png(1)})
    before = path.read_bytes()
    path.chmod(0o400)
    source = MbTiles(path, "a")
    assert source.tile(0, 0, 0) is not None
    assert [file.name for file in tmp_path.iterdir()] == ["a.mbtiles"]
    source.close()
    assert path.read_bytes() == before


def test_a_table_that_never_ends_is_given_up(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("epf_gcs.maps.mbtiles._LONGEST_LISTING_S", 0.05)
    with closing(sqlite3.connect(tmp_path / "loop.mbtiles")) as file:
        file.executescript(
            "CREATE TABLE metadata (name TEXT, value TEXT);"
            "CREATE VIEW tiles AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n)"
            " SELECT 0 AS zoom_level, 0 AS tile_column, 0 AS tile_row, x'00' AS tile_data FROM n WHERE i < 0;"
        )
    assert fault(tmp_path / "loop.mbtiles") == "map_file_damaged"
