"""Reading in other processes: what one costs too much ends with it, and the next tile comes from a new one."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import cast

import msgspec
import pytest

from epf_gcs.errors import GatewayError
from epf_gcs.maps.layer import Bounds, Description, Range
from epf_gcs.maps.mbtiles import MbTiles
from epf_gcs.maps.reader import Reader
from epf_gcs.maps.reading import TOO_COSTLY
from tests.support.bombs import SLOW, write_view
from tests.support.maps import png, write_mbtiles, write_pmtiles

STAMP = (1,)


@pytest.fixture
def reader() -> Iterator[Reader]:
    # Two processes, of which a slow file may hold one for less than the limit of a single query.
    made = Reader(longest_tile_s=2.0, longest_opening_s=2.0)
    yield made
    made.close()


def why(caught: pytest.ExceptionInfo[GatewayError]) -> str:
    return cast(str, caught.value.params["why"])


def test_what_is_read_there_is_what_is_read_here(reader: Reader, tmp_path: Path) -> None:
    path = write_mbtiles(tmp_path / "a.mbtiles", {(2, 1, 3): png(2)}, name="Gando", format="png")
    source = MbTiles(path, "a")
    assert reader.describe(path, "a", "mbtiles", STAMP) == source.description
    assert reader.tile(path, "a", "mbtiles", STAMP, (2, 1, 0)) == source.tile(2, 1, 0) != None  # noqa: E711
    assert reader.tile(path, "a", "mbtiles", STAMP, (2, 0, 0)) is None
    source.close()


def test_a_description_comes_whole_through_the_pipe() -> None:
    one = Description(
        "t", "terrain", Bounds(1, 2, 3, 4), 0, 1, "©", available=((Range(0, 0, 1, 0),), ()), extensions=("watermask",)
    )
    assert msgspec.json.decode(msgspec.json.encode(one), type=Description) == one


def test_a_fault_comes_with_its_code_and_its_words(reader: Reader, tmp_path: Path) -> None:
    (tmp_path / "a.pmtiles").write_bytes(b"noise")
    with pytest.raises(GatewayError) as caught:
        reader.describe(tmp_path / "a.pmtiles", "a.pmtiles", "pmtiles", STAMP)
    assert (caught.value.code, caught.value.params["name"]) == ("map_file_damaged", "a.pmtiles")


def test_a_file_that_takes_too_long_is_ended_and_not_asked_again(reader: Reader, tmp_path: Path) -> None:
    slow = write_view(tmp_path / "slow.mbtiles", SLOW)
    good = write_pmtiles(tmp_path / "good.pmtiles", {(0, 0, 0): png(7)})
    with ThreadPoolExecutor(3) as viewers:
        held = [viewers.submit(reader.describe, slow, "slow.mbtiles", "mbtiles", STAMP) for _ in range(2)]
        found = viewers.submit(reader.tile, good, "good", "pmtiles", STAMP, (0, 0, 0)).result()
        assert found is not None
        assert found.data == png(7)
        for one in held:
            with pytest.raises(GatewayError) as caught:
                one.result()
            assert why(caught) == TOO_COSTLY
    with pytest.raises(GatewayError) as caught:
        reader.tile(slow, "slow.mbtiles", "mbtiles", STAMP, (0, 0, 0))
    assert why(caught) == TOO_COSTLY
    assert reader.tile(good, "good", "pmtiles", STAMP, (0, 0, 0)) == found, "a new process took its place"


def test_a_process_that_died_is_followed_by_another(reader: Reader, tmp_path: Path) -> None:
    path = write_pmtiles(tmp_path / "a.pmtiles", {(0, 0, 0): png(7)})
    first = reader.tile(path, "a", "pmtiles", STAMP, (0, 0, 0))
    for worker in reader._workers:
        if worker._process is not None:
            worker._process.kill()
            worker._process.wait()
    assert reader.tile(path, "a", "pmtiles", STAMP, (0, 0, 0)) == first != None  # noqa: E711


def test_a_file_is_let_go_before_it_moves(reader: Reader, tmp_path: Path) -> None:
    path = write_pmtiles(tmp_path / "a.pmtiles", {(0, 0, 0): png(1)})
    assert reader.tile(path, "a", "pmtiles", STAMP, (0, 0, 0)) is not None
    reader.forget(path)
    write_pmtiles(path, {(0, 0, 0): png(2)})
    tile = reader.tile(path, "a", "pmtiles", STAMP, (0, 0, 0))
    assert tile is not None
    assert tile.data == png(2)
