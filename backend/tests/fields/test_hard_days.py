"""Preparing a field where the disk is really full, where the whole station is killed, and from files of a degree."""

from __future__ import annotations

import gzip
import json
import os
import signal
import sqlite3
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from typing import Any

import httpx
import numpy as np
import pytest
from rasterio.io import MemoryFile
from rasterio.transform import from_origin

from epf_gcs.errors import GatewayError
from epf_gcs.fields.area import Area
from epf_gcs.fields.fetching import Pace
from epf_gcs.fields.order import Order, Part
from epf_gcs.fields.pack import prove
from epf_gcs.fields.worker import ORDER, PACK, prepare
from epf_gcs.maps.outside import Consent
from tests.support import bad_server as bad
from tests.support import fields
from tests.support.bad_server import BadServer, bad_server
from tests.support.maps import decode_mesh
from tests.support.programs import Program, children_of, gateway_process, words_of
from tests.support.waiting import DEADLINE_S, eventually

PACE = Pace(0.002, 0.004, 5.0)
AREA = Area(((fields.LATITUDE_DEG, fields.LONGITUDE_DEG),), 3000.0)

# Its own user and mount namespace: no permission of the system's is needed, and the disk goes with the program.
_MOUNT = 'mount -t tmpfs -o size=1m none "$0" && exec "$@"'
_ON_A_FULL_DISK = """
import json, subprocess, sys
from pathlib import Path
from epf_gcs.errors import GatewayError
from epf_gcs.fields import worker
from epf_gcs.fields.fetching import Pace
from epf_gcs.maps.outside import Consent

folder, order, out = map(Path, sys.argv[1:])

def attempt():
    try:
        worker.prepare(folder, Consent(["127.0.0.1"]), Pace(0.002, 0.004, 5.0), lambda told: None)
    except GatewayError as error:
        return [error.code, error.detail]
    return None

(folder / worker.ORDER).write_bytes(order.read_bytes())
said = [attempt()]
# Without what is kept for recordings: the disk itself refuses.
worker.RESERVE_BYTES = 0
said += [attempt(), attempt()]
left = sorted(path.name for path in folder.iterdir())
# Its present options name the owner as the system knows it, which the user's own namespace does not.
subprocess.run(["mount", "--options-source", "disable", "-o", "remount,size=64m", folder], check=True)
said.append(attempt())
(out / worker.PACK).write_bytes((folder / worker.PACK).read_bytes())
print(json.dumps({"said": said, "left": left}))
"""


@pytest.fixture
def server() -> Iterator[BadServer]:
    with bad_server(fields.tile) as running:
        yield running


@pytest.fixture(autouse=True)
def _no_proxy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NO_PROXY", "127.0.0.1")


def large(path: str) -> bytes:
    """Pictures of 120 kB that no packing makes smaller, the same each time."""
    numbers = [int(number) for number in path.split("/")[2:]]
    return fields.rgb_png(np.random.default_rng(numbers).integers(0, 256, (200, 200, 3), np.uint8))


def degree(path: str) -> bytes | None:
    """`/N27_W016.tif`: a GeoTIFF as GLO-30 has them, 1/400 degree coarse; the sea has no file."""
    if path != "/N27_W016.tif":
        return None
    steps = (np.arange(400) + 0.5) / 400
    heights = fields.height_m(*np.meshgrid(-16 + steps, 28 - steps)).astype(np.float32)
    with MemoryFile() as file:
        with file.open(
            driver="GTiff",
            width=400,
            height=400,
            count=1,
            dtype="float32",
            crs="EPSG:4326",
            transform=from_origin(-16, 28, 1 / 400, 1 / 400),
            tiled=True,
            compress="deflate",
            predictor=3,
        ) as raster:
            raster.write(heights, 1)
        return bytes(file.read())


def ordered(server: BadServer, area: Area, *parts: Part) -> bytes:
    return Order("Gando", area, parts).as_json()


def pictures(server: BadServer) -> Part:
    return Part("imagery", "Test", f"{server.base}/pictures/{{z}}/{{x}}/{{y}}", "© test", *fields.IMAGERY_ZOOMS)


def degrees(server: BadServer) -> Part:
    return Part("heights", "Test", f"{server.base}/{{latitude}}_{{longitude}}.tif", "© test", 0, 0)


def made(folder: Path, order: bytes) -> bytes:
    folder.mkdir()
    (folder / ORDER).write_bytes(order)
    prepare(folder, Consent(["127.0.0.1"]), PACE, lambda _told: None)
    return (folder / PACK).read_bytes()


def highest_m(path: Path) -> float:
    with closing(sqlite3.connect(path)) as file:
        finest = "SELECT tile_data FROM terrain_tiles WHERE zoom_level = (SELECT max(zoom_level) FROM terrain_tiles)"
        return max(decode_mesh(gzip.decompress(data)).highest_m for (data,) in file.execute(finest))


def test_a_disk_that_is_really_full_is_said_keeps_what_came_and_it_goes_on_when_there_is_room(
    tmp_path: Path, server: BadServer
) -> None:
    server.tile = large
    order = ordered(server, AREA, pictures(server))
    good = made(tmp_path / "good", order)
    assert len(good) > 1_000_000, "more than the small disk has"
    asked = len(server.paths)
    small = tmp_path / "small"
    small.mkdir()
    (tmp_path / "order").write_bytes(order)
    command = ["unshare", "--map-root-user", "--mount", "sh", "-c", _MOUNT, str(small)]
    try:
        if subprocess.run([*command, "true"], capture_output=True, check=False).returncode != 0:
            pytest.skip("this system lets no user mount a disk of their own")
    except FileNotFoundError:
        pytest.skip("this system has no namespaces of its own")
    script = [sys.executable, "-c", _ON_A_FULL_DISK, str(small), str(tmp_path / "order"), str(tmp_path)]
    ran = subprocess.run([*command, *script], capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stderr
    found = json.loads(ran.stdout)
    reserved, full, again, done = found["said"]
    assert (reserved[0], full[0], again[0], done) == ("map_disk_full", "map_disk_full", "map_disk_full", None)
    assert "'Gando' does not fit" in full[1]
    assert PACK not in found["left"], "nothing half looks like a field"
    assert (tmp_path / PACK).read_bytes() == good
    # A tile that the disk did not take is asked for again, and one more that came meanwhile; the rest is not.
    assert len(server.paths) - asked <= asked + 4


def test_files_of_a_degree_become_the_same_field_though_they_come_cut_and_a_missing_one_is_the_sea(
    tmp_path: Path, server: BadServer
) -> None:
    server.tile = degree
    area = Area(((27.97, fields.LONGITUDE_DEG),), 6000.0)
    order = ordered(server, area, degrees(server))
    good = made(tmp_path / "good", order)
    assert sorted(server.paths) == ["/N27_W016.tif", "/N28_W016.tif"]
    prove(tmp_path / "good" / PACK, "x")
    assert 850 < highest_m(tmp_path / "good" / PACK) <= 900
    ways = iter([bad.cut_in_body, bad.refuses_for_now, bad.says_too_short, bad.fails, bad.cut_in_head])
    server.plan = lambda _number, path: next(ways, None) if path == "/N27_W016.tif" else None
    assert made(tmp_path / "bad", order) == good


def test_a_page_or_another_tiff_in_place_of_heights_is_refused(tmp_path: Path, server: BadServer) -> None:
    order = ordered(server, AREA, degrees(server))
    server.tile = lambda _path: b"II*\0 no heights at all"
    with pytest.raises(GatewayError) as caught:
        made(tmp_path / "tiff", order)
    assert caught.value.code == "field_source_wrong"
    assert not (tmp_path / "tiff" / PACK).exists()
    server.plan = lambda _number, _path: bad.answers_a_page
    with pytest.raises(GatewayError) as caught:
        made(tmp_path / "page", order)
    assert caught.value.code == "field_source_wrong"


@contextmanager
def station(data: Path) -> Iterator[tuple[Program, httpx.Client]]:
    """The whole station, which may ask servers of this computer for maps."""
    config = data.parent / "station.toml"
    config.write_text('local_maps = ["127.0.0.1"]\n')
    with gateway_process(data, "--config", str(config)) as program:
        url = program.wait_for_words(r"url=(http://\S+)")
        with httpx.Client(base_url=f"{url}/api/v1", timeout=DEADLINE_S) as http:
            yield program, http


def tree(pid: int) -> list[int]:
    return [pid, *(below for child in children_of(pid) for below in tree(child))]


def is_alive(pid: int) -> bool:
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def test_the_whole_station_killed_in_the_middle_leaves_no_worker_and_goes_on_by_itself(
    tmp_path: Path, server: BadServer
) -> None:
    opened = threading.Event()

    def later(connection: Any, data: bytes) -> None:
        opened.wait(20)
        bad.well(connection, data)

    server.plan = lambda number, _path: None if number < 8 else later

    def only(http: httpx.Client) -> dict[str, Any]:
        found: list[dict[str, Any]] = http.get("/map/fields").raise_for_status().json()["fields"]
        return found[0] if found else {"state": "none", "tiles": 0}

    with station(tmp_path / "data") as (program, http):
        begun = http.post("/map/fields", json=fields.order(server.base, kinds="imagery"))
        assert begun.status_code < 300, begun.text
        eventually(lambda: only(http)["tiles"] == 8, "eight tiles are there")
        pids = tree(program.process.pid)
        workers = [pid for pid in pids if "epf_gcs.fields.worker" in words_of(pid)]
        assert len(workers) == 1
        # A power cut for everything but the worker, which has to see it by itself.
        for pid in pids:
            if pid not in workers:
                os.kill(pid, signal.SIGKILL)
        eventually(lambda: not any(map(is_alive, workers)), "the worker ends with its station")
    opened.set()
    with station(tmp_path / "data") as (_, http):
        give_up_s = time.monotonic() + 6 * DEADLINE_S
        while only(http)["state"] != "done":
            assert only(http)["problem"] is None, only(http)
            assert time.monotonic() < give_up_s, f"never done: {only(http)}"
            time.sleep(0.05)
        (layer,) = http.get("/map/layers").raise_for_status().json()["layers"]
        http.post(f"/map/layers/{layer['id']}/proof").raise_for_status()
    assert set(server.good.values()) == {1}, "what had arrived is not fetched again"
