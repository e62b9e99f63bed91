"""Online sources: silence while they are off, two requests at a time, what was seen kept, and no flood of errors."""

from __future__ import annotations

import re
import socket
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import httpx
import pytest

from tests.support.gateway import Gateway, running_gateway
from tests.support.maps import png
from tests.support.ports import free_port
from tests.support.tiles import TileServer, tile_server
from tests.support.waiting import eventually

LAYER = "online-test"
# The tests' server is in the station's own network: somebody must have agreed.
AGREED: dict[str, Any] = {"local_maps": ("127.0.0.1",)}


@pytest.fixture
def server() -> Iterator[TileServer]:
    with tile_server() as running:
        yield running


@pytest.fixture(autouse=True)
def _no_proxy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NO_PROXY", "127.0.0.1")


@pytest.fixture
def gateway(tmp_path: Path) -> Iterator[Gateway]:
    with running_gateway(tmp_path / "data", **AGREED) as running:
        yield running


def source(url: str, **more: Any) -> dict[str, Any]:
    return {"id": "test", "name": "Test", "url": url, "attribution": "© test", "maximum_zoom": 18, **more}


def choose(gateway: Gateway, url: str, *, enabled: bool = True, limit_bytes: int = 10_000_000) -> dict[str, Any]:
    body = {"enabled": enabled, "limit_bytes": limit_bytes, "sources": [source(url)]}
    found: dict[str, Any] = gateway.http.put("/map/online", json=body).raise_for_status().json()
    return found


def tile(gateway: Gateway, zoom: int, column: int, row: int) -> httpx.Response:
    return gateway.http.get(f"/map/layers/{LAYER}/tiles/{zoom}/{column}/{row}")


def test_by_default_openstreetmap_is_known_and_nobody_is_asked(gateway: Gateway) -> None:
    found = gateway.http.get("/map/online").raise_for_status().json()
    assert (found["enabled"], found["cached_bytes"]) == (False, 0)
    (osm,) = found["sources"]
    assert (osm["id"], osm["attribution"], osm["problem"]) == ("openstreetmap", "© OpenStreetMap contributors", None)
    assert gateway.http.get("/map/layers").json()["layers"] == []
    assert gateway.http.get("/map/layers/online-openstreetmap/tiles/0/0/0").status_code == 204
    assert gateway.status()["errors"] == {}


def test_switched_off_nothing_is_asked_and_on_each_tile_once(gateway: Gateway, server: TileServer) -> None:
    choose(gateway, server.url, enabled=False)
    assert tile(gateway, 3, 1, 2).status_code == 204
    assert server.paths == []
    choose(gateway, server.url)
    (layer,) = gateway.http.get("/map/layers").json()["layers"]
    assert (layer["id"], layer["kind"], layer["format"], layer["maximum_zoom"]) == (LAYER, "imagery", "online", 18)
    assert layer["attribution"] == "© test"
    for _ in range(3):
        answer = tile(gateway, 3, 1, 2)
        assert (answer.status_code, answer.headers["content-type"], answer.content) == (200, "image/png", png(7))
    assert server.paths == ["/3/1/2.png"]
    assert all(re.match(r"EPF-GCS/\d", agent) for agent in server.agents)
    assert gateway.http.get("/map/online").json()["cached_bytes"] == len(png(7))
    assert [tile(gateway, *place).status_code for place in ((19, 0, 0), (2, 4, 0), (2, 0, 4))] == [204, 204, 204]
    assert len(server.paths) == 1, "what cannot be is not asked for"


def test_what_was_seen_is_there_without_the_internet_and_after_a_restart(tmp_path: Path) -> None:
    with tile_server() as server:
        url = server.url
        with running_gateway(tmp_path / "data", **AGREED) as gateway:
            choose(gateway, url)
            assert tile(gateway, 3, 1, 2).status_code == 200
    with running_gateway(tmp_path / "data", **AGREED) as gateway:
        assert gateway.http.get("/map/online").json()["enabled"] is True
        assert tile(gateway, 3, 1, 2).content == png(7)
        assert tile(gateway, 3, 2, 2).status_code == 204


def test_two_requests_at_a_time_and_one_for_many_viewers(gateway: Gateway, server: TileServer) -> None:
    choose(gateway, server.url)
    server.hold.clear()
    with ThreadPoolExecutor(12) as viewers:
        places = [(5, column, 0) for column in range(5)] + [(5, 0, 0)] * 5
        answers = [viewers.submit(tile, gateway, *place) for place in places]
        eventually(lambda: server.at_once == 2, "two are asked for")
        assert tile(gateway, 6, 99, 0).status_code == 204, "the station answers meanwhile"
        server.hold.set()
        assert {answer.result().status_code for answer in answers} == {200}
    assert server.most_at_once == 2
    assert sorted(server.paths) == [f"/5/{column}/0.png" for column in range(5)]


def test_an_old_tile_is_asked_for_again_and_not_sent_again(gateway: Gateway, server: TileServer) -> None:
    choose(gateway, server.url)
    server.headers["Cache-Control"] = "max-age=0"
    assert tile(gateway, 3, 1, 2).status_code == 200
    server.status = 304
    assert tile(gateway, 3, 1, 2).content == png(7)
    assert server.conditions == [None, '"one"']
    server.status, server.body = 200, png(8)
    assert tile(gateway, 3, 1, 2).content == png(8)
    server.headers["Cache-Control"] = "no-store"
    server.body = png(9)
    assert tile(gateway, 4, 0, 0).content == png(9)
    assert tile(gateway, 4, 0, 0).content == png(9)
    assert server.paths.count("/4/0/0.png") == 2, "what may not be kept is not"


def test_where_nobody_answers_it_is_told_once_and_shown_at_the_source(gateway: Gateway) -> None:
    choose(gateway, f"http://127.0.0.1:{free_port(socket.SOCK_STREAM)}/{{z}}/{{x}}/{{y}}.png")
    assert [tile(gateway, 3, column, 0).status_code for column in range(6)] == [204] * 6
    assert gateway.status()["errors"] == {"map_source_silent": 1}
    (found,) = gateway.http.get("/map/online").json()["sources"]
    assert (found["problem_code"], found["problem_params"]) == ("map_source_silent", {"name": "Test"})
    assert gateway.http.get("/map/layers").json()["layers"][0]["problem_code"] == "map_source_silent"


@pytest.mark.parametrize(
    ("status", "body", "headers"),
    [
        (403, b"no", {}),
        (302, b"", {"Location": "http://127.0.0.1:1/x.png"}),
        (200, b"<html>login</html>", {}),
        (500, b"", {}),
    ],
)
def test_an_answer_that_is_no_map_is_not_kept_nor_followed(
    gateway: Gateway, server: TileServer, status: int, body: bytes, headers: dict[str, str]
) -> None:
    choose(gateway, server.url)
    server.status, server.body = status, body
    server.headers |= headers
    assert [tile(gateway, 3, column, 0).status_code for column in range(3)] == [204] * 3
    assert server.paths == ["/3/0/0.png"], "and there is a pause"
    assert gateway.status()["errors"] == {"map_source_refused": 1}
    (found,) = gateway.http.get("/map/online").json()["sources"]
    assert found["problem_params"] == {"name": "Test", "status": status}
    assert gateway.http.get("/map/online").json()["cached_bytes"] == 0


def test_a_tile_that_the_source_does_not_have_is_no_fault_and_is_not_asked_for_again(
    gateway: Gateway, server: TileServer
) -> None:
    choose(gateway, server.url)
    server.status = 404
    assert [tile(gateway, 3, 0, 0).status_code for _ in range(3)] == [204] * 3
    assert server.paths == ["/3/0/0.png"]
    assert gateway.status()["errors"] == {}
    server.status = 200
    assert tile(gateway, 3, 1, 0).status_code == 200


def test_what_is_kept_is_bounded_and_can_be_forgotten(gateway: Gateway, server: TileServer) -> None:
    size = len(png(7))
    choose(gateway, server.url, limit_bytes=5 * size)
    for column in range(9):
        assert tile(gateway, 5, column, 0).status_code == 200
    assert 0 < gateway.http.get("/map/online").json()["cached_bytes"] <= 5 * size
    assert choose(gateway, server.url, limit_bytes=2 * size)["cached_bytes"] <= 2 * size
    cleared = gateway.http.delete("/map/online/cache").raise_for_status().json()
    assert cleared["cached_bytes"] == 0
    assert tile(gateway, 5, 8, 0).status_code == 200
    assert server.paths[-1] == "/5/8/0.png"


@pytest.mark.parametrize(
    "url",
    [
        "ftp://127.0.0.1/{z}/{x}/{y}.png",
        "file:///etc/{z}/{x}/{y}",
        "https:///{z}/{x}/{y}.png",
        "http://127.0.0.1/{z}/{x}.png",
        "http://127.0.0.1/{z}/{x}/{y}/{y}.png",
        "http://[::1/{z}/{x}/{y}.png",
    ],
)
def test_an_address_that_is_none_is_refused_and_changes_nothing(gateway: Gateway, url: str) -> None:
    body = {"enabled": True, "limit_bytes": 0, "sources": [source(url)]}
    answer = gateway.http.put("/map/online", json=body)
    assert (answer.status_code, answer.json()["code"]) == (422, "map_source_invalid")
    assert gateway.http.get("/map/online").json()["enabled"] is False


def test_two_sources_of_one_id_are_refused(gateway: Gateway) -> None:
    body = {"enabled": True, "limit_bytes": 0, "sources": [source("https://a/{z}/{x}/{y}")] * 2}
    assert gateway.http.put("/map/online", json=body).status_code == 422


def test_who_has_no_control_cannot_choose(gateway: Gateway, server: TileServer) -> None:
    with gateway.stream():
        body = {"enabled": True, "limit_bytes": 0, "sources": [source(server.url)]}
        assert gateway.http.put("/map/online", json=body).json()["code"] == "control_held"
        assert gateway.http.delete("/map/online/cache").json()["code"] == "control_held"


INSIDE = [
    "127.0.0.1:PORT",
    "localhost:PORT",
    "2130706433:PORT",
    "127.1:PORT",
    "0x7f000001:PORT",
    "[::1]:PORT",
    "[::ffff:127.0.0.1]:PORT",
    "0.0.0.0:PORT",
    "10.0.0.1",
    "192.168.1.1",
    "169.254.169.254",
    "100.64.0.1",
    "[fe80::1]",
    "[fd00::1]",
    "224.0.0.1",
    "router.local",
]


@pytest.mark.parametrize("host", INSIDE)
def test_a_server_in_the_own_network_is_not_chosen_without_consent(
    tmp_path: Path, server: TileServer, host: str
) -> None:
    port = str(server.server.server_address[1])
    url = f"http://{host.replace('PORT', port)}/{{z}}/{{x}}/{{y}}.png"
    with running_gateway(tmp_path / "data") as gateway:
        body = {"enabled": True, "limit_bytes": 0, "sources": [source(url)]}
        answer = gateway.http.put("/map/online", json=body)
        assert (answer.status_code, answer.json()["code"]) == (422, "map_source_local")
        assert "GCS_LOCAL_MAPS" in answer.json()["detail"]
        assert gateway.http.get("/map/online").json()["enabled"] is False
    assert server.paths == []


def test_a_name_that_leads_inside_is_found_out_when_it_is_asked(
    tmp_path: Path, server: TileServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def inside(_loop: object, _host: str, port: int, **_: object) -> list[tuple[object, ...]]:
        return [(socket.AF_INET, socket.SOCK_STREAM, 6, "", (number, port)) for number in ("1.1.1.1", "127.0.0.1")]

    monkeypatch.setenv("NO_PROXY", "tiles.example")
    monkeypatch.setattr("uvloop.Loop.getaddrinfo", inside, raising=False)
    url = server.url.replace("127.0.0.1", "tiles.example")
    with running_gateway(tmp_path / "data") as gateway:
        choose(gateway, url)
        assert tile(gateway, 3, 1, 2).status_code == 204
        (found,) = gateway.http.get("/map/online").json()["sources"]
        assert found["problem_code"] == "map_source_local"
    assert server.paths == []


def test_a_server_that_was_chosen_before_consent_was_asked_for_is_not_asked(tmp_path: Path, server: TileServer) -> None:
    with running_gateway(tmp_path / "data", **AGREED) as gateway:
        choose(gateway, server.url)
    with running_gateway(tmp_path / "data") as gateway:
        assert tile(gateway, 3, 1, 2).status_code == 204
        assert gateway.status()["errors"] == {"map_source_local": 1}
    assert server.paths == []
