"""Preparing a field over HTTP: before, under way, paused, killed, done, carried to another station, and removed."""

from __future__ import annotations

import math
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import httpx
import orjson
import pytest

from tests.support import bad_server as bad
from tests.support import fields
from tests.support.bad_server import BadServer, bad_server
from tests.support.gateway import Gateway, running_gateway
from tests.support.programs import words_of
from tests.support.waiting import DEADLINE_S, eventually

AGREED: dict[str, Any] = {"local_maps": ("127.0.0.1",)}


@pytest.fixture
def server() -> Iterator[BadServer]:
    with bad_server(fields.tile) as running:
        yield running


@pytest.fixture(autouse=True)
def _no_proxy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NO_PROXY", "127.0.0.1")


@pytest.fixture
def gateway(tmp_path: Path) -> Iterator[Gateway]:
    with running_gateway(tmp_path / "data", **AGREED) as running:
        yield running


class Hold:
    """Lets so many tiles through, and holds the others back until it is opened."""

    def __init__(self, server: BadServer, first: int) -> None:
        self._open = threading.Event()
        server.plan = lambda number, _path: None if number < first else self._later

    def open(self) -> None:
        """Answer everything from now on."""
        self._open.set()

    def _later(self, connection: Any, data: bytes) -> None:
        self._open.wait(20)
        bad.well(connection, data)


def order(gateway: Gateway, server: BadServer, kinds: str = "imagery", **more: Any) -> httpx.Response:
    return gateway.http.post("/map/fields", json={**fields.order(server.base, kinds=kinds), **more})


def begun(gateway: Gateway, server: BadServer, kinds: str = "imagery") -> str:
    found: str = order(gateway, server, kinds).raise_for_status().json()["id"]
    return found


def field(gateway: Gateway) -> dict[str, Any]:
    (found,) = gateway.http.get("/map/fields").raise_for_status().json()["fields"]
    return dict(found)


def is_done(gateway: Gateway) -> bool:
    found = field(gateway)
    assert found["state"] != "failed", found["problem"]
    return bool(found["state"] == "done")


def wait_until_done(gateway: Gateway) -> None:
    """The worker gives way to everything else: on a busy machine it takes longer than whatever else is waited for."""
    give_up_s = time.monotonic() + 6 * DEADLINE_S
    while not is_done(gateway):
        assert time.monotonic() < give_up_s, f"never done: {field(gateway)}"
        time.sleep(0.05)


def layers(gateway: Gateway) -> dict[str, dict[str, Any]]:
    return {one["format"]: one for one in gateway.http.get("/map/layers").raise_for_status().json()["layers"]}


def folder(gateway: Gateway) -> Path:
    return Path(gateway.http.get("/map/layers").raise_for_status().json()["folder"])


def workers() -> list[int]:
    """Processes of ours that prepare a field."""
    found = []
    for place in Path("/proc").glob("[0-9]*"):
        words = words_of(int(place.name))
        try:
            parent = (place / "stat").read_text().rpartition(")")[2].split()[1]
        except OSError:
            continue
        if "epf_gcs.fields.worker" in words and int(parent) == os.getpid():
            found.append(int(place.name))
    return found


def test_before_it_begins_it_says_what_it_takes_and_nobody_is_asked(gateway: Gateway, server: BadServer) -> None:
    body = fields.order(server.base)
    del body["accepts_terms"]
    found = gateway.http.post("/map/fields/estimate", json=body).raise_for_status().json()
    assert {(one["kind"], one["zoom"]) for one in found["levels"]} == {
        ("heights", 12),
        *(("imagery", zoom) for zoom in range(10, 15)),
    }
    assert found["tiles"] == sum(one["tiles"] for one in found["levels"]) > 10
    assert found["bytes"] == sum(one["bytes"] for one in found["levels"]) + found["made_bytes"]
    assert server.paths == []
    sources = gateway.http.get("/map/fields").json()["sources"]
    assert {one["kind"] for one in sources} == {"heights", "imagery"}
    assert all(one["terms"] and one["terms_url"] for one in sources)


@pytest.mark.parametrize(
    ("change", "code"),
    [
        ({"accepts_terms": False}, "field_terms"),
        ({"radius_m": 190_000, "parts": [{"zooms": (0, 19)}]}, "field_too_large"),
        ({"parts": [{"url": "http://127.0.0.2/{z}/{x}/{y}"}]}, "map_source_local"),
        ({"parts": [{"url": "http://localhost:1/{z}/{x}/{y}"}]}, "map_source_local"),
        ({"parts": [{"url": "https://tile.openstreetmap.org/{z}/{x}/{y}.png"}]}, "field_source_forbids"),
        ({"parts": [{"url": "https://example.org/{z}/{x}"}]}, "map_source_invalid"),
        ({"parts": [{"url": "https://{x}.example.org/{z}/{x}/{y}"}]}, "map_source_invalid"),
        ({"parts": [{}, {}]}, "field_no_parts"),
    ],
)
def test_what_cannot_or_may_not_be_brought_is_refused_with_a_reason(
    gateway: Gateway, server: BadServer, change: dict[str, Any], code: str
) -> None:
    body = fields.order(server.base, kinds="imagery")
    (usual,) = body["parts"]
    if "parts" in change:
        parts = []
        for part in change["parts"]:
            lowest, highest = part.pop("zooms", fields.IMAGERY_ZOOMS)
            parts.append({**usual, "minimum_zoom": lowest, "maximum_zoom": highest, **part})
        change = {**change, "parts": parts}
    answer = gateway.http.post("/map/fields", json={**body, **change})
    assert answer.status_code in (409, 422)
    assert answer.json()["code"] == code
    assert gateway.http.get("/map/fields").json()["fields"] == []
    assert server.paths == []


def test_done_it_is_there_without_the_source_and_on_another_station(
    gateway: Gateway, server: BadServer, tmp_path: Path
) -> None:
    begun(gateway, server, "both")
    wait_until_done(gateway)
    asked = len(server.paths)
    found = layers(gateway)
    assert {name: one["kind"] for name, one in found.items()} == {
        "field": "imagery",
        "field_relief": "imagery",
        "field_terrain": "terrain",
    }
    assert all(one["problem"] is None and one["attribution"] == "© test" for one in found.values())
    column, row = _middle(14)
    assert _tile(gateway, found["field"]["id"], 14).content == fields.imagery(14, column, row)
    assert _tile(gateway, found["field_relief"]["id"], 12).headers["content-type"] == "image/png"
    terrain = f"/map/layers/{found['field_terrain']['id']}/terrain"
    assert gateway.http.get(f"{terrain}/layer.json").json()["available"]
    assert gateway.http.get(f"{terrain}/0/0/0.terrain").status_code == 200
    assert gateway.http.post(f"/map/layers/{found['field']['id']}/proof").raise_for_status().json()["tiles"] > asked
    data = gateway.http.get(f"/map/layers/{found['field_relief']['id']}/file").raise_for_status().content
    assert len(server.paths) == asked, "nothing is asked for what is there"
    assert not list((folder(gateway) / ".fields").iterdir())
    with running_gateway(tmp_path / "other") as other:
        assert other.http.post("/map/imports?name=Gando.field", content=data).raise_for_status().json()["layer"]
        assert {name: one["bytes"] for name, one in layers(other).items()} == dict.fromkeys(found, len(data))
        assert _tile(other, found["field"]["id"], 14).content == fields.imagery(14, column, row)
        cut = other.http.post("/map/imports?name=Cut.field", content=data[: len(data) // 2])
        assert cut.json()["code"] == "map_file_damaged"
        other.http.delete(f"/map/layers/{found['field_relief']['id']}?for_good=true").raise_for_status()
        assert layers(other) == {}
        assert [path.name for path in folder(other).iterdir() if not path.name.startswith(".")] == []


def test_paused_it_asks_for_nothing_and_goes_on_where_it_was_after_a_restart(tmp_path: Path, server: BadServer) -> None:
    hold = Hold(server, 8)
    with running_gateway(tmp_path / "data", **AGREED) as gateway:
        field_id = begun(gateway, server)
        eventually(lambda: field(gateway)["tiles"] == 8, "eight tiles are there")
        assert field(gateway)["tiles_total"] > 8
        paused = gateway.http.post(f"/map/fields/{field_id}/pause").raise_for_status().json()
        assert (paused["state"], workers()) == ("paused", [])
        assert gateway.http.post(f"/map/fields/{field_id}/pause").json()["code"] == "field_not_in_state"
        assert layers(gateway) == {}, "half of it looks like nothing"
    asked = len(server.paths)
    with running_gateway(tmp_path / "data", **AGREED) as gateway:
        eventually(lambda: gateway.http.get("/map/fields").json()["fields"] != [], "it is remembered")
        assert (field(gateway)["state"], field(gateway)["tiles"], len(server.paths)) == ("paused", 8, asked)
        hold.open()
        gateway.http.post(f"/map/fields/{field_id}/resume").raise_for_status()
        wait_until_done(gateway)
        assert list(layers(gateway)) == ["field"]
    assert set(server.good.values()) == {1}, "what had arrived is not fetched again"


def test_killed_it_goes_on_by_itself(tmp_path: Path, server: BadServer) -> None:
    hold = Hold(server, 8)
    with running_gateway(tmp_path / "data", **AGREED) as gateway:
        begun(gateway, server)
        eventually(lambda: field(gateway)["tiles"] == 8, "eight tiles are there")
        (worker,) = workers()
        os.kill(worker, signal.SIGKILL)
        eventually(lambda: workers() not in ([], [worker]), "another one goes on")
        assert field(gateway)["state"] == "running"
    # The station ended in the middle, without a word to anybody.
    assert workers() == []
    hold.open()
    with running_gateway(tmp_path / "data", **AGREED) as gateway:
        eventually(lambda: gateway.http.get("/map/fields").json()["fields"] != [], "it is remembered")
        wait_until_done(gateway)
        (layer,) = layers(gateway).values()
        gateway.http.post(f"/map/layers/{layer['id']}/proof").raise_for_status()
    assert set(server.good.values()) == {1}


def test_of_equal_orders_at_once_one_is_taken(gateway: Gateway, server: BadServer) -> None:
    Hold(server, 0)
    with ThreadPoolExecutor(8) as pool:
        answers = list(pool.map(lambda _: order(gateway, server), range(8)))
    assert sorted(answer.is_success for answer in answers) == [False] * 7 + [True]
    assert {answer.json()["code"] for answer in answers if not answer.is_success} == {"map_exists"}
    assert len(gateway.http.get("/map/fields").json()["fields"]) == 1


def test_a_worker_does_not_outlive_its_station(tmp_path: Path, server: BadServer) -> None:
    Hold(server, 3)
    body = fields.order(server.base, kinds="imagery")
    area = {"points": [[fields.LATITUDE_DEG, fields.LONGITUDE_DEG]], "radius_m": 3000.0}
    (tmp_path / "order.json").write_bytes(orjson.dumps({"name": "x", "area": area, "parts": body["parts"]}))
    process = subprocess.Popen(
        [sys.executable, "-m", "epf_gcs.fields.worker"], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL
    )
    assert process.stdin is not None
    process.stdin.write(orjson.dumps({"do": "prepare", "folder": str(tmp_path), "servers": ["127.0.0.1"]}) + b"\n")
    process.stdin.flush()
    eventually(lambda: len(server.paths) > 3, "it works")
    process.stdin.close()
    assert process.wait(20) != 0


def test_removed_in_the_middle_nothing_is_left(gateway: Gateway, server: BadServer) -> None:
    Hold(server, 5)
    field_id = begun(gateway, server)
    assert order(gateway, server).json()["code"] == "map_exists"
    eventually(lambda: field(gateway)["tiles"] == 5, "some tiles are there")
    left = gateway.http.delete(f"/map/fields/{field_id}").raise_for_status().json()
    assert left["fields"] == []
    assert workers() == []
    assert [path for path in folder(gateway).rglob("*") if "fields/" in str(path)] == []
    assert gateway.http.post(f"/map/fields/{field_id}/resume").status_code == 404
    begun(gateway, server)


def test_a_source_that_answers_pages_stops_it_with_a_sentence_and_it_can_go_on(
    gateway: Gateway, server: BadServer
) -> None:
    server.plan = lambda number, _path: None if number < 5 else bad.answers_a_page
    field_id = begun(gateway, server)

    def says_why() -> bool:
        # Both from one answer: a piece that was on its way still takes the sentence away for a moment.
        found = field(gateway)
        return found["problem_code"] is not None and "Test imagery" in found["problem"]

    eventually(says_why, "a sentence says why nothing comes")
    server.plan = lambda _number, _path: None
    if field(gateway)["state"] == "failed":
        gateway.http.post(f"/map/fields/{field_id}/resume").raise_for_status()
    wait_until_done(gateway)


def test_a_folder_that_goes_away_is_a_sentence(gateway: Gateway, server: BadServer) -> None:
    hold = Hold(server, 5)
    begun(gateway, server)
    eventually(lambda: field(gateway)["tiles"] == 5, "some tiles are there")
    (at,) = (folder(gateway) / ".fields").iterdir()
    for path in at.iterdir():
        path.unlink()
    at.rmdir()
    hold.open()
    eventually(lambda: field(gateway)["state"] == "failed", "it is said")
    assert field(gateway)["problem_code"] == "field_not_written"
    assert layers(gateway) == {}


def _middle(zoom: int) -> tuple[int, int]:

    count = 2**zoom
    mercator = math.asinh(math.tan(math.radians(fields.LATITUDE_DEG)))
    return int((fields.LONGITUDE_DEG + 180) / 360 * count), int((1 - mercator / math.pi) / 2 * count)


def _tile(gateway: Gateway, layer: str, zoom: int) -> httpx.Response:
    column, row = _middle(zoom)
    return gateway.http.get(f"/map/layers/{layer}/tiles/{zoom}/{column}/{row}")
