"""A field against a server that cuts, lies and refuses: it ends with the same bytes as against a good one."""

from __future__ import annotations

import gzip
import sqlite3
import zlib
from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest

from epf_gcs.errors import GatewayError
from epf_gcs.fields.area import Area
from epf_gcs.fields.fetching import Pace
from epf_gcs.fields.order import Order, Part
from epf_gcs.fields.pack import prove
from epf_gcs.fields.part_file import PartFile
from epf_gcs.fields.whole import is_whole_vector
from epf_gcs.fields.work import FieldProgress
from epf_gcs.fields.worker import ARRIVED, ORDER, PACK, prepare
from epf_gcs.maps.outside import Consent
from tests.support import bad_server as bad
from tests.support import fields
from tests.support.bad_server import BadServer, bad_server
from tests.support.maps import decode_mesh

PACE = Pace(0.002, 0.004, 5.0)
AREA = Area(((fields.LATITUDE_DEG, fields.LONGITUDE_DEG),), 3000.0)


@pytest.fixture
def server() -> Iterator[BadServer]:
    with bad_server(fields.tile) as running:
        yield running


@pytest.fixture(autouse=True)
def _no_proxy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NO_PROXY", "127.0.0.1")


def ordered(folder: Path, server: BadServer, kinds: str = "imagery") -> None:
    """Put an order into this folder, as the station does."""
    body = fields.order(server.base, kinds=kinds)
    parts = tuple(Part(**part) for part in body["parts"])
    folder.mkdir(exist_ok=True)
    (folder / ORDER).write_bytes(Order("Gando", AREA, parts).as_json())


def made(folder: Path, server: BadServer, kinds: str = "imagery", say: Callable[[Any], None] | None = None) -> bytes:
    """Prepare the field in this folder; the bytes of its file."""
    ordered(folder, server, kinds)
    prepare(folder, Consent(["127.0.0.1"]), PACE, say or (lambda _told: None))
    return (folder / PACK).read_bytes()


@pytest.mark.parametrize("way", [bad.cut_in_head, bad.cut_in_body, bad.says_too_short, bad.refuses_for_now, bad.fails])
def test_a_hundred_failures_in_a_row_end_with_the_bytes_of_a_good_server(
    tmp_path: Path, server: BadServer, way: bad.Answer
) -> None:
    good = made(tmp_path / "good", server)
    asked = len(server.paths)
    server.plan = lambda number, _path: way if asked + 4 <= number < asked + 104 else None
    assert made(tmp_path / "bad", server) == good
    assert len(server.paths) == 2 * asked + 100
    assert max(server.good.values()) == 2, "no whole tile is fetched twice"


@pytest.mark.parametrize("way", [bad.cut_in_body, bad.says_too_short, bad.refuses_for_now])
def test_roads_are_whole_against_a_bad_server_and_byte_equal(
    tmp_path: Path, server: BadServer, way: bad.Answer
) -> None:
    good = made(tmp_path / "good", server, kinds="vector")
    asked = len(server.paths)
    server.plan = lambda number, _path: way if asked + 4 <= number < asked + 104 else None
    assert made(tmp_path / "bad", server, kinds="vector") == good
    assert len(server.paths) == 2 * asked + 100
    with closing(sqlite3.connect(tmp_path / "good" / PACK)) as file:
        found = {tuple(row[:3]): gzip.decompress(row[3]) for row in file.execute("SELECT * FROM vector_tiles")}
    assert found == {
        (zoom, int(column), 2**zoom - 1 - int(row)): fields.roads(zoom, int(column), int(row))
        for zoom in range(fields.VECTOR_ZOOMS[0], fields.VECTOR_ZOOMS[1] + 1)
        for column, row in AREA.tiles(zoom)
    }
    assert prove(tmp_path / "good" / PACK, "x").tiles == len(found)


def test_packed_roads_are_unpacked_also_where_nobody_says_so_and_a_cut_one_is_fetched_again(
    tmp_path: Path, server: BadServer
) -> None:
    good = made(tmp_path / "good", server, kinds="vector")
    whole = server.tile
    server.tile = lambda path: gzip.compress(whole(path) or b"")
    server.plan = lambda number, _path: bad.says_too_short if number % 3 == 0 else None
    assert made(tmp_path / "packed", server, kinds="vector") == good


@pytest.mark.parametrize("way", [bad.says_huge, bad.answers_a_page])
def test_what_is_no_vector_tile_is_refused(tmp_path: Path, server: BadServer, way: bad.Answer) -> None:
    server.plan = lambda _number, _path: way
    with pytest.raises(GatewayError) as caught:
        made(tmp_path, server, kinds="vector")
    assert caught.value.code == "field_source_wrong"
    assert len(server.paths) < 10


def test_a_vector_tile_cut_anywhere_is_not_whole() -> None:
    data = fields.roads(13, 1, 2)
    ends = [at for at in range(len(data) + 1) if is_whole_vector(data[:at])]
    # At the end of a layer nothing is seen to be missing: gzip's checksum, which is asked for, shows that.
    assert len(ends) == 5
    assert ends[-1] == len(data)
    for bomb in (b"\x1a\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff\x01", b"\x1a\x00", b"\x08\x01", b"\xff" * 40):
        assert not is_whole_vector(bomb)


def test_heights_become_terrain_and_relief_the_same_each_time(tmp_path: Path, server: BadServer) -> None:
    good = made(tmp_path / "good", server, kinds="both")
    asked = len(server.paths)
    server.plan = lambda number, _path: bad.cut_in_body if (number - asked) % 3 else None
    assert made(tmp_path / "bad", server, kinds="both") == good
    with closing(sqlite3.connect(tmp_path / "good" / PACK)) as file:
        counts = [
            file.execute(f"SELECT count(*) FROM {name}").fetchone()[0]  # noqa: S608 - names of ours
            for name in ("tiles", "relief_tiles", "terrain_tiles")
        ]
        assert all(count > 0 for count in counts)
        assert file.execute("SELECT count(*) FROM manifest").fetchone()[0] == sum(counts)
        finest = "SELECT tile_data FROM terrain_tiles WHERE zoom_level = (SELECT max(zoom_level) FROM terrain_tiles)"
        peaks = [decode_mesh(gzip.decompress(data)).highest_m for (data,) in file.execute(finest)]
    assert 850 < max(peaks) <= 900, "the hill has its height"


def test_every_tile_of_the_area_is_there_and_as_its_source_had_it(tmp_path: Path, server: BadServer) -> None:
    made(tmp_path, server)
    expected = {
        (zoom, int(column), 2**zoom - 1 - int(row)): fields.imagery(zoom, int(column), int(row))
        for zoom in range(fields.IMAGERY_ZOOMS[0], fields.IMAGERY_ZOOMS[1] + 1)
        for column, row in AREA.tiles(zoom)
    }
    with closing(sqlite3.connect(tmp_path / PACK)) as file:
        found = {tuple(row[:3]): row[3] for row in file.execute("SELECT * FROM tiles")}
    assert found == expected


def test_where_a_source_has_nothing_the_rest_is_brought_and_where_it_has_nothing_at_all_it_says_so(
    tmp_path: Path, server: BadServer
) -> None:
    whole = server.tile
    server.tile = lambda path: None if path.split("/")[2] == "14" else whole(path)
    told: list[FieldProgress] = []
    made(tmp_path / "some", server, say=told.append)
    last = next(one for one in reversed(told) if one.doing == "fetching")
    assert 0 < last.tiles_missing < last.tiles == last.tiles_total
    server.tile = lambda _path: None
    with pytest.raises(GatewayError) as caught:
        made(tmp_path / "none", server)
    assert caught.value.code == "field_source_empty"
    assert not (tmp_path / "none" / PACK).exists()


@pytest.mark.parametrize("way", [bad.says_huge, bad.answers_a_page])
def test_what_is_no_map_is_refused_with_a_sentence_and_nothing_looks_whole(
    tmp_path: Path, server: BadServer, way: bad.Answer
) -> None:
    server.plan = lambda _number, _path: way
    with pytest.raises(GatewayError) as caught:
        made(tmp_path, server)
    assert caught.value.code == "field_source_wrong"
    assert len(server.paths) < 10, "it is not asked again and again"
    assert not (tmp_path / PACK).exists()


def test_a_bomb_is_not_unpacked(tmp_path: Path, server: BadServer) -> None:
    packing = zlib.compressobj(9, wbits=31)
    bomb = packing.compress(bytes(200_000_000)) + packing.flush()

    def explode(connection: Any, _data: bytes) -> None:
        head = f"HTTP/1.1 200 OK\r\nContent-Encoding: gzip\r\nContent-Length: {len(bomb)}\r\n\r\n"
        connection.sendall(head.encode() + bomb)

    server.plan = lambda _number, _path: explode
    with pytest.raises(GatewayError) as caught:
        made(tmp_path, server)
    assert "bytes" in caught.value.detail


def test_a_server_of_this_network_is_not_asked_without_consent(tmp_path: Path, server: BadServer) -> None:
    ordered(tmp_path, server)
    with pytest.raises(GatewayError) as caught:
        prepare(tmp_path, Consent(), PACE, lambda _told: None)
    assert caught.value.code == "map_source_local"
    assert server.paths == []


def test_what_had_arrived_is_not_fetched_again(tmp_path: Path, server: BadServer) -> None:
    good = made(tmp_path / "good", server)
    asked = len(server.paths)
    server.plan = lambda number, _path: bad.answers_a_page if number >= asked + 10 else None
    with pytest.raises(GatewayError):
        made(tmp_path / "bad", server)
    server.plan = lambda _number, _path: None
    with closing(PartFile(tmp_path / "bad" / ARRIVED)) as arrived:
        assert arrived.arrived("imagery").pieces == 10
    asked_before = len(server.paths)
    assert made(tmp_path / "bad", server) == good
    # By name, not by number: on a slow machine one may be asked for twice.
    assert len(set(server.paths[asked_before:])) == len(set(server.paths[:asked])) - 10


def test_a_changed_or_missing_tile_or_a_cut_file_is_seen(tmp_path: Path, server: BadServer) -> None:
    data = made(tmp_path, server)
    path = tmp_path / PACK
    tiles = prove(path, "x").tiles
    assert tiles > 10

    def refused(change: str) -> str:
        path.write_bytes(data)
        with closing(sqlite3.connect(path)) as file:
            file.execute(change)
            file.commit()
        with pytest.raises(GatewayError) as caught:
            prove(path, "x")
        assert caught.value.code == "field_not_whole"
        return caught.value.detail

    refused("UPDATE tiles SET tile_data = x'00' WHERE rowid = 7")
    assert "missing" in refused("DELETE FROM tiles WHERE rowid = 7")
    refused("DELETE FROM manifest WHERE rowid = 7")
    refused("INSERT INTO tiles SELECT zoom_level, tile_column, tile_row + 500, tile_data FROM tiles WHERE rowid = 7")
    path.write_bytes(data[: len(data) // 2])
    with pytest.raises(GatewayError):
        prove(path, "x")


def test_a_server_that_says_when_to_come_again_is_left_alone_till_then(tmp_path: Path, server: BadServer) -> None:
    told: list[FieldProgress] = []
    server.plan = lambda number, _path: bad.refuses_for_a_second if number == 0 else None
    made(tmp_path, server, say=told.append)
    waits = [one.waits_s for one in told if one.waits_s is not None]
    assert 0.5 < max(waits) <= 1.0, "a thousand times what the pace would wait"
    assert any(one.waits_for and one.waits_for.code == "field_source_silent" for one in told)
