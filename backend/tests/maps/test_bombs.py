"""Files that are small and want much: they are refused, at a small price, and what else there is goes on."""

from __future__ import annotations

import tracemalloc
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from epf_gcs.errors import GatewayError
from epf_gcs.maps.layer import TileSource
from epf_gcs.maps.mbtiles import MbTiles
from epf_gcs.maps.mesh_files import MeshFiles
from epf_gcs.maps.pmtiles import PmTiles
from tests.support.bombs import ENDLESS, write_directory_bomb, write_lying_zip, write_view
from tests.support.maps import png

# A file may cost this much of the station's memory, whatever it holds.
MOST_BYTES = 40_000_000


@contextmanager
def little_memory() -> Iterator[None]:
    tracemalloc.start()
    try:
        yield
        assert tracemalloc.get_traced_memory()[1] < MOST_BYTES
    finally:
        tracemalloc.stop()


def refused(open_it: Callable[[Path, str], TileSource], path: Path) -> str:
    with pytest.raises(GatewayError) as caught:
        open_it(path, path.name)
    assert caught.value.code in ("map_file_damaged", "map_file_no_layer_json")
    return str(caught.value.params.get("why"))


def test_a_directory_that_unpacks_to_millions_of_entries_is_refused(tmp_path: Path) -> None:
    path = write_directory_bomb(tmp_path / "a.pmtiles", 2_000_000)
    assert path.stat().st_size < 20_000
    with little_memory():
        assert "packed" in refused(PmTiles, path)


def test_a_directory_that_says_more_than_it_holds_is_refused(tmp_path: Path) -> None:
    assert "250000 entries" in refused(PmTiles, write_directory_bomb(tmp_path / "a.pmtiles", 250_000))


def test_an_archive_that_lies_about_a_size_is_unpacked_no_further(tmp_path: Path) -> None:
    path = write_lying_zip(tmp_path / "a.zip", real_bytes=100_000_000, said_bytes=1000)
    with little_memory():
        refused(MeshFiles, path)


def test_metadata_that_is_computed_is_not(tmp_path: Path) -> None:
    plain = "SELECT * FROM kept"
    path = write_view(tmp_path / "a.mbtiles", plain, "SELECT 'name' AS name, hex(zeroblob(50000000)) AS value")
    with little_memory():
        assert "authorized" in refused(MbTiles, path)


def test_a_view_that_never_ends_is_not_begun(tmp_path: Path) -> None:
    assert "authorized" in refused(MbTiles, write_view(tmp_path / "a.mbtiles", ENDLESS))


def test_a_view_over_tables_is_a_map_as_any_other(tmp_path: Path) -> None:
    """Many programs keep each picture once, and join it to its places."""
    source = MbTiles(
        write_view(tmp_path / "a.mbtiles", "SELECT k.* FROM kept k JOIN many m ON m.i = k.zoom_level"), "a"
    )
    tile = source.tile(0, 0, 0)
    assert tile is not None
    assert tile.data == png(1)
    source.close()
