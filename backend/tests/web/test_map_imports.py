"""Maps that are sent in: written as they come, whole in the end or not at all, with progress, and to be cancelled."""

from __future__ import annotations

import socket
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import quote, urlsplit

import httpx
import pytest

from epf_gcs.maps.files import id_of
from epf_gcs.maps.imports import RESERVE_BYTES
from tests.support.fake_board import FakeBoard
from tests.support.gateway import Gateway, running_gateway
from tests.support.maps import png, write_mbtiles, write_raster
from tests.support.waiting import DEADLINE_S, eventually


@pytest.fixture
def maps(gateway: Gateway) -> Path:
    folder = Path(gateway.http.get("/map/layers").raise_for_status().json()["folder"])
    eventually(folder.is_dir, "the folder is there")
    return folder


def send(gateway: Gateway, name: str, content: bytes | Iterator[bytes], **headers: str) -> httpx.Response:
    return gateway.http.post(f"/map/imports?name={quote(name)}", content=content, headers=headers)


def kept(maps: Path) -> list[str]:
    """All files that a person would find, and what is left of imports."""
    names = [str(file.relative_to(maps)) for file in maps.rglob("*") if file.is_file()]
    return sorted(name for name in names if not name.startswith(".terrain"))


def test_a_map_is_sent_and_is_in_the_list(gateway: Gateway, maps: Path, tmp_path: Path) -> None:
    noise = {(6, column, 3): png(1) + bytes(50_000) for column in range(60)}
    content = write_mbtiles(tmp_path / "x.mbtiles", noise, name="Gando").read_bytes()
    assert len(content) > 2_000_000, "longer than any other body may be"
    with gateway.stream() as stream:
        operator = {"X-Client": stream.hello["client"]}
        found = send(gateway, "../Isla Peña.mbtiles", content, **operator).raise_for_status().json()
        assert (found["state"], found["bytes"], found["total_bytes"]) == ("done", len(content), len(content))
        assert (found["name"], found["layer"]) == ("_Isla Peña.mbtiles", id_of("_Isla Peña.mbtiles"))
        states = [stream.event("map_import")["state"]]
        while states[-1] != "done":
            states.append(stream.event("map_import")["state"])
        assert set(states) == {"receiving", "done"}
    assert (maps / "_Isla Peña.mbtiles").read_bytes() == content
    assert gateway.http.get(f"/map/imports/{found['id']}").json() == found
    assert [one["name"] for one in gateway.http.get("/map/layers").json()["layers"]] == ["Gando"]
    assert kept(maps) == ["_Isla Peña.mbtiles"]


def test_heights_that_are_sent_become_terrain(gateway: Gateway, maps: Path, tmp_path: Path) -> None:
    content = write_raster(tmp_path / "x.tif", lambda x, _: x, size=60).read_bytes()
    found = send(gateway, "isla.tif", content).raise_for_status().json()
    assert found["state"] == "converting"

    def now() -> dict[str, Any]:
        state: dict[str, Any] = gateway.http.get(f"/map/imports/{found['id']}").json()
        return state

    eventually(lambda: now()["state"] == "done", "it is terrain")
    assert (now()["percent"], now()["layer"], now()["problem"]) == (100, id_of("isla.tif"), None)
    (layer,) = gateway.http.get("/map/layers").json()["layers"]
    assert (layer["kind"], layer["problem"]) == ("terrain", None)


@pytest.mark.parametrize(
    ("name", "content", "code"),
    [
        ("a.mbtiles", b"noise", "map_file_damaged"),
        ("a.pmtiles", b"", "map_file_damaged"),
        ("a.zip", b"PK", "map_file_damaged"),
        ("photo.jpg", b"\xff\xd8\xff", "map_kind_unknown"),
        ("..", b"x", "map_name_invalid"),
    ],
)
def test_what_is_no_map_is_refused_and_nothing_is_left(
    gateway: Gateway, maps: Path, name: str, content: bytes, code: str
) -> None:
    answer = send(gateway, name, content)
    assert (answer.status_code, answer.json()["code"]) == (422, code)
    assert kept(maps) == []


def test_heights_that_cannot_be_turned_into_terrain_leave_nothing(gateway: Gateway, maps: Path) -> None:
    found = send(gateway, "a.tif", b"II*\x00 and no more").raise_for_status().json()
    eventually(lambda: gateway.http.get(f"/map/imports/{found['id']}").json()["state"] == "failed", "it fails")
    state = gateway.http.get(f"/map/imports/{found['id']}").json()
    assert (state["problem_code"], state["problem_params"]["name"]) == ("map_file_damaged", "a.tif")
    assert state["layer"] is None
    assert kept(maps) == []


def test_a_name_that_is_taken_is_not_written_over(gateway: Gateway, maps: Path, tmp_path: Path) -> None:
    write_mbtiles(maps / "a.mbtiles", {(0, 0, 0): png(1)})
    other = write_mbtiles(tmp_path / "x.mbtiles", {(0, 0, 0): png(2)}).read_bytes()
    answer = send(gateway, "a.mbtiles", other)
    assert (answer.status_code, answer.json()["code"]) == (409, "map_exists")
    assert gateway.http.get(f"/map/layers/{id_of('a.mbtiles')}/tiles/0/0/0").content == png(1)


class Sending:
    """A browser that has sent some of a file, and no more for now."""

    def __init__(self, gateway: Gateway, name: str, some: bytes, total: int) -> None:
        address = urlsplit(gateway.base)
        self.socket = socket.create_connection((address.hostname or "", address.port or 0))
        head = f"POST /api/v1/map/imports?name={name} HTTP/1.1\r\nHost: {address.netloc}\r\n"
        self.socket.sendall(f"{head}Content-Length: {total}\r\n\r\n".encode() + some)

    def answer(self) -> bytes:
        """What comes back in the end."""
        self.socket.settimeout(DEADLINE_S)
        return self.socket.recv(65536)


def test_a_browser_that_goes_away_in_the_middle_leaves_nothing(gateway: Gateway, maps: Path) -> None:
    with gateway.stream() as stream:
        gateway.http.post("/control", json={"client": stream.hello["client"], "action": "release"}).raise_for_status()
        sending = Sending(gateway, "a.mbtiles", bytes(3_000_000), 9_000_000)
        started = stream.event("map_import")
        assert (started["state"], started["name"], started["total_bytes"]) == ("receiving", "a.mbtiles", 9_000_000)
        eventually(lambda: gateway.http.get(f"/map/imports/{started['id']}").json()["bytes"] >= 3_000_000, "it comes")
        assert gateway.http.get("/map/layers").json()["layers"] == [], "half a map is none"
        sending.socket.close()
        state = stream.event("map_import")
        while state["state"] == "receiving":
            state = stream.event("map_import")
        assert (state["state"], state["problem_code"]) == ("failed", "map_import_incomplete")
    eventually(lambda: kept(maps) == [], "nothing is left")


def test_an_import_is_cancelled_while_it_is_received(gateway: Gateway, maps: Path) -> None:
    with gateway.stream() as stream:
        gateway.http.post("/control", json={"client": stream.hello["client"], "action": "release"}).raise_for_status()
        sending = Sending(gateway, "a.mbtiles", bytes(2_000_000), 9_000_000)
        started = stream.event("map_import")
        gateway.http.delete(f"/map/imports/{started['id']}").raise_for_status()
        sending.socket.sendall(bytes(1000))
        assert sending.answer().startswith(b"HTTP/1.1 409")
        sending.socket.close()
    assert gateway.http.get(f"/map/imports/{started['id']}").json()["state"] == "failed"
    assert kept(maps) == []


def test_an_import_is_cancelled_while_it_becomes_terrain(gateway: Gateway, maps: Path, tmp_path: Path) -> None:
    content = write_raster(tmp_path / "x.tif", lambda x, _: x, size=2500, step=0.0001).read_bytes()
    found = send(gateway, "large.tif", content).raise_for_status().json()
    eventually(lambda: list((maps / ".terrain").glob("*.part")) != [], "it is under way")
    cancelled = gateway.http.delete(f"/map/imports/{found['id']}").raise_for_status().json()
    assert (cancelled["state"], cancelled["problem_code"], cancelled["layer"]) == (
        "failed",
        "map_import_incomplete",
        None,
    )
    assert kept(maps) == []
    eventually(lambda: list((maps / ".terrain").iterdir()) == [], "nothing is left of the terrain either")
    again = send(gateway, "large.tif", write_raster(tmp_path / "y.tif", lambda x, _: x, size=30).read_bytes())
    eventually(
        lambda: gateway.http.get(f"/map/imports/{again.json()['id']}").json()["state"] == "done", "the name is free"
    )


def test_a_disk_without_room_is_said_so_before_anything_is_written(gateway: Gateway, maps: Path) -> None:
    gateway.web.maps.imports._free_bytes = lambda _: RESERVE_BYTES + 50
    answer = send(gateway, "a.mbtiles", bytes(51))
    assert (answer.status_code, answer.json()["code"]) == (409, "map_disk_full")
    assert answer.json()["params"]["free_mb"] == 200
    assert kept(maps) == []


def test_what_a_crash_left_is_cleared_away_and_heights_go_on(tmp_path: Path) -> None:
    folder = tmp_path / "data" / "maps"
    (folder / ".incoming" / "abc").mkdir(parents=True)
    (folder / ".incoming" / "abc" / "half.mbtiles").write_bytes(bytes(100))
    (folder / ".terrain").mkdir()
    (folder / ".terrain" / "gone-00000000-1-1.part").write_bytes(bytes(100))
    write_raster(folder / "isla.tif", lambda x, _: x, size=40)
    with running_gateway(tmp_path / "data") as gateway:
        eventually(
            lambda: [one["problem"] for one in gateway.http.get("/map/layers").json()["layers"]] == [None],
            "the heights that were waiting are terrain",
        )
        assert kept(folder) == ["isla.tif"]
        assert [file.suffix for file in (folder / ".terrain").iterdir()] == [".mbtiles"]


def test_the_line_goes_on_while_a_map_is_received(gateway: Gateway, maps: Path, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    before = gateway.status()["board"]["frames_received"]
    go_on = threading.Event()

    def pieces() -> Iterator[bytes]:
        for _ in range(40):
            yield bytes(1_000_000)
        go_on.wait(20)

    results: list[httpx.Response] = []
    thread = threading.Thread(target=lambda: results.append(send(gateway, "a.mbtiles", pieces())))
    thread.start()
    eventually(lambda: gateway.status()["board"]["frames_received"] > before + 10, "frames come")
    go_on.set()
    thread.join()
    assert results[0].json()["code"] == "map_file_damaged"
    assert kept(maps) == []


def test_who_has_no_control_cannot_send(gateway: Gateway, maps: Path) -> None:
    with gateway.stream():
        assert send(gateway, "a.mbtiles", b"x").json()["code"] == "control_held"
        assert gateway.http.delete("/map/imports/000000000000").json()["code"] == "control_held"
    assert gateway.http.get("/map/imports/000000000000").json()["code"] == "map_import_unknown"
