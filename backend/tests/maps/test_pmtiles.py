"""PMTiles: every tile of a file with leaves, and damage of any kind is words."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pmtiles.tile import TileType

from epf_gcs.errors import GatewayError
from epf_gcs.maps.layer import Bounds
from epf_gcs.maps.pmtiles import PmTiles
from tests.support.maps import png, write_pmtiles

TILES = {(z, x, y): png((z * 50 + x * 7 + y) % 250) for z in range(5) for x in range(1 << z) for y in range(1 << z)}


def test_every_tile_is_found_and_no_other(tmp_path: Path) -> None:
    source = PmTiles(write_pmtiles(tmp_path / "a.pmtiles", TILES), "a")
    for key, data in TILES.items():
        tile = source.tile(*key)
        assert tile is not None
        assert (tile.data, tile.media_type) == (data, "image/png")
    assert source.tile(6, 0, 0) is None
    source.close()


def test_it_says_what_it_is(tmp_path: Path) -> None:
    source = PmTiles(write_pmtiles(tmp_path / "a.pmtiles", TILES), "a")
    found = source.description
    assert (found.title, found.attribution, found.kind) == ("Canarias", "© someone", "imagery")
    assert found.bounds == pytest.approx((-18.0, 27.5, -13.0, 29.0))
    assert (found.minimum_zoom, found.maximum_zoom) == (0, 4)
    source.close()


def test_vector_tiles_are_refused_in_words(tmp_path: Path) -> None:
    path = write_pmtiles(tmp_path / "a.pmtiles", {(0, 0, 0): b"pbf"}, TileType.MVT)
    with pytest.raises(GatewayError) as caught:
        PmTiles(path, "streets.pmtiles")
    assert (caught.value.code, caught.value.params["found"]) == ("map_file_vector", "mvt")
    assert "streets.pmtiles" in caught.value.detail


def test_a_copy_that_was_broken_off_is_refused_when_it_is_listed(tmp_path: Path) -> None:
    """Its directory comes first and is whole."""
    path = write_pmtiles(tmp_path / "a.pmtiles", TILES)
    path.write_bytes(path.read_bytes()[:-1])
    with pytest.raises(GatewayError) as caught:
        PmTiles(path, "a.pmtiles")
    assert (caught.value.code, caught.value.params["why"]) == ("map_file_damaged", "cut off")


def test_a_file_that_does_not_say_what_it_covers_may_cover_everything(tmp_path: Path) -> None:
    path = write_pmtiles(tmp_path / "a.pmtiles", TILES)
    with path.open("r+b") as file:
        file.seek(102)  # of the header: west, south, east, north
        file.write(bytes(16))
    source = PmTiles(path, "a")
    assert source.description.bounds == Bounds()
    source.close()


@settings(max_examples=60)
@given(st.data())
def test_damage_never_does_more_than_refuse(tmp_path_factory: pytest.TempPathFactory, data: st.DataObject) -> None:
    folder = tmp_path_factory.mktemp("damage")
    whole = bytearray(write_pmtiles(folder / "a.pmtiles", {(1, 0, 0): png(1), (1, 1, 1): png(2)}).read_bytes())
    for _ in range(data.draw(st.integers(1, 6))):
        whole[data.draw(st.integers(0, len(whole) - 1))] = data.draw(st.integers(0, 255))
    (folder / "b.pmtiles").write_bytes(whole[: data.draw(st.integers(0, len(whole)))])
    assert asked(folder / "b.pmtiles") <= {"map_file_damaged", "map_file_vector"}


def asked(path: Path) -> set[str]:
    """The codes of all faults on the way through the file."""
    codes: set[str] = set()
    try:
        source = PmTiles(path, "b")
    except GatewayError as error:
        return {error.code}
    for x, y in ((0, 0), (1, 1), (1, 0)):
        try:
            source.tile(1, x, y)
        except GatewayError as error:
            codes.add(error.code)
    source.close()
    return codes


def test_a_file_that_is_gone_is_an_error_and_no_crash(tmp_path: Path) -> None:
    path = write_pmtiles(tmp_path / "a.pmtiles", TILES)
    source = PmTiles(path, "a")
    path.write_bytes(b"")
    with pytest.raises(GatewayError) as caught:
        source.tile(4, 3, 3)
    assert caught.value.code == "map_file_damaged"
    source.close()
    with pytest.raises(GatewayError):
        source.tile(3, 3, 3)
