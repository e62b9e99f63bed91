"""Connections that hold the station up: each is ended with its reason, and everybody else is answered meanwhile."""

from __future__ import annotations

import socket
from collections.abc import Iterator
from contextlib import ExitStack, closing
from dataclasses import replace
from pathlib import Path

import pytest

from epf_gcs.access.roles import Role
from epf_gcs.shares.table import SHARES, by_host
from epf_gcs.web.serving.visitors import Limits
from tests.support.callers import one_time_key, stranger
from tests.support.gateway import Gateway, running_gateway
from tests.support.listening import everything
from tests.support.maps import png, write_mbtiles
from tests.support.waiting import DEADLINE_S, eventually

STREAM = (
    b"GET /api/v1/stream HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    b"Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n"
)
GET = b"GET /api/v1/status HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n"


@pytest.fixture
def quick(tmp_path: Path) -> Iterator[Gateway]:
    """One with little patience, and little room."""
    limits = Limits(
        head_s=0.3,
        head_bytes=8192,
        idle_s=1,
        least_bytes_per_s=20_000.0,
        rate_looked_at_s=0.3,
        unread_s=0.3,
    )
    shares = replace(
        SHARES,
        connections=by_host(each=200, strangers=800, others=1000, own=12),
        sockets=by_host(each=120, strangers=400, others=400, own=3),
    )
    with running_gateway(tmp_path / "data", limits, shares=shares) as running:
        yield running


def line(gateway: Gateway) -> socket.socket:
    made = socket.create_connection(("127.0.0.1", gateway.server.port))
    made.settimeout(DEADLINE_S)
    return made


@pytest.mark.parametrize("head", [b"", b"GET /api", b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nX: "])
def test_a_head_that_does_not_come_is_not_waited_for(quick: Gateway, head: bytes) -> None:
    with closing(line(quick)) as made:
        made.sendall(head)
        assert everything(made).startswith(b"HTTP/1.1 408")
    eventually(lambda: len(quick.server.visitors) <= 1, "its place is free")


def test_the_second_head_is_not_waited_for_either(quick: Gateway) -> None:
    with closing(line(quick)) as made:
        made.sendall(GET)
        assert made.recv(65536).startswith(b"HTTP/1.1 200")
        made.sendall(b"GET /api")
        assert b"HTTP/1.1 408" in everything(made)


def test_a_head_that_begins_behind_another_request_is_ended_too(quick: Gateway) -> None:
    with closing(line(quick)) as made:
        made.sendall(GET + b"GET /api")
        assert everything(made).startswith(b"HTTP/1.1 200")


@pytest.mark.parametrize("between", [b"", b"\r\n"])
def test_a_connection_that_asks_nothing_more_is_ended(quick: Gateway, between: bytes) -> None:
    with closing(line(quick)) as made:
        made.sendall(GET)
        assert made.recv(12) == b"HTTP/1.1 200"
        made.sendall(between)
        everything(made)


def test_a_head_without_end_is_refused(quick: Gateway) -> None:
    with closing(line(quick)) as made:
        made.sendall(b"GET / HTTP/1.1\r\n")
        try:
            for _ in range(100):
                made.sendall(b"X: " + b"x" * 1000 + b"\r\n")
        except OSError:
            return
        assert everything(made).startswith(b"HTTP/1.1 431")


def test_slow_uploads_end_and_another_one_comes_through(quick: Gateway, tmp_path: Path) -> None:
    folder = Path(quick.http.get("/map/layers").json()["folder"])
    good = write_mbtiles(tmp_path / "x.mbtiles", {(0, 0, 0): png(1)}).read_bytes()
    with ExitStack() as opened:
        slow = [opened.enter_context(closing(line(quick))) for _ in range(3)]
        for number, made in enumerate(slow):
            head = f"POST /api/v1/map/imports?name=s{number}.mbtiles HTTP/1.1\r\nHost: 127.0.0.1\r\n"
            made.sendall(f"{head}Content-Length: 9000000\r\n\r\n".encode() + bytes(100))
        for made in slow:
            assert everything(made)[:12] in (b"HTTP/1.1 408", b"")

        def sent() -> bool:
            return quick.http.post("/map/imports?name=good.mbtiles", content=good).status_code == 200

        eventually(sent, "their places are free")
    eventually(lambda: not list((folder / ".incoming").glob("*")), "nothing of the others is left")


def test_an_answer_that_nobody_reads_is_given_up(quick: Gateway, tmp_path: Path) -> None:
    with closing(socket.socket()) as made:
        made.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        made.connect(("127.0.0.1", quick.server.port))
        made.sendall(b"GET /api/v1/openapi.json HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n" * 200)
        eventually(lambda: len(quick.server.visitors) == 0, "its place is free")


def test_idle_connections_make_room_and_lock_nobody_out(quick: Gateway) -> None:
    with ExitStack() as opened:
        for _ in range(60):
            opened.enter_context(closing(line(quick)))
        with closing(line(quick)) as made:
            made.sendall(GET)
            assert made.recv(12) == b"HTTP/1.1 200"
        assert len(quick.server.visitors) <= 12


def test_there_are_so_many_streams_and_their_places_come_back(quick: Gateway) -> None:
    with ExitStack() as opened:
        for _ in range(3):
            made = opened.enter_context(closing(line(quick)))
            made.sendall(STREAM)
            answer = made.recv(1000)
            assert answer.startswith(b"HTTP/1.1 101"), answer
        with closing(line(quick)) as refused:
            refused.sendall(STREAM)
            assert everything(refused).startswith(b"HTTP/1.1 503")
        assert quick.http.get("/status").status_code == 200
    eventually(lambda: quick.server.visitors.sockets == 0, "they are gone")
    with quick.stream() as stream:
        assert stream.hello["type"] == "hello"


def test_a_body_that_is_refused_before_it_is_whole_leaves_the_connection_in_order(quick: Gateway) -> None:
    with closing(line(quick)) as made:
        head = b"PUT /api/v1/links/board HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 100000\r\n\r\n"
        made.sendall(head + bytes(100_000))
        assert made.recv(12) == b"HTTP/1.1 413"
        everything(made)
    eventually(lambda: len(quick.server.visitors) <= 1, "its place is free")


def test_an_ordinary_body_is_taken_however_it_is_cut(quick: Gateway) -> None:
    with closing(line(quick)) as made:
        body = b'{"enabled":false,"limit_bytes":0,"sources":[]}'
        made.sendall(b"PUT /api/v1/map/online HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Type: application/json\r\n")
        made.sendall(b"Content-Length: %d\r\n\r\n" % len(body))
        for byte in body:
            made.send(bytes((byte,)))
        assert made.recv(12) == b"HTTP/1.1 200"


ENTER = b"POST /api/v1/access/enter HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Type: application/json\r\n"


@pytest.fixture
def strict(tmp_path: Path) -> Iterator[Gateway]:
    """One that takes this computer for a stranger, with little room and, for strangers' bodies, little patience."""
    limits = Limits(strangers_body_s=0.3)
    shares = replace(SHARES, connections=by_host(each=200, strangers=800, others=1000, own=12))
    with running_gateway(tmp_path / "data", limits, shares=shares, trust_this_computer=False) as running:
        yield running


def test_bodies_of_strangers_that_come_slowly_lock_nobody_out(tmp_path: Path) -> None:
    shares = replace(SHARES, connections=by_host(each=200, strangers=800, others=1000, own=12))
    with running_gateway(tmp_path, shares=shares, trust_this_computer=False) as station, ExitStack() as opened:
        for _ in range(40):
            made = opened.enter_context(closing(line(station)))
            made.sendall(ENTER + b"Content-Length: 1000\r\n\r\n{")
        guest = opened.enter_context(stranger(station))
        body = {"key": one_time_key(station, Role.viewer), "name": "Ana"}
        guest.post("/access/enter", json=body).raise_for_status()
        assert len(station.server.visitors) <= 12


def test_answers_that_strangers_do_not_read_lock_nobody_out(strict: Gateway) -> None:
    with ExitStack() as opened:
        for _ in range(40):
            made = opened.enter_context(closing(socket.socket()))
            made.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
            made.connect(("127.0.0.1", strict.server.port))
            made.setblocking(False)
            made.send(b"GET /api/v1/access/me HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n" * 2000)
        with stranger(strict) as guest:
            body = {"key": one_time_key(strict, Role.viewer), "name": "Ana"}
            guest.post("/access/enter", json=body).raise_for_status()


def test_a_strangers_body_has_little_time_and_one_with_a_key_has_more(strict: Gateway) -> None:
    with closing(line(strict)) as made, closing(line(strict)) as known:
        with stranger(strict) as guest:
            body = {"key": one_time_key(strict, Role.operator), "name": "Ana"}
            guest.post("/access/enter", json=body).raise_for_status()
            cookie = "; ".join(f"{name}={value}" for name, value in guest.cookies.items())
        upload = f"POST /api/v1/map/imports?name=a.mbtiles HTTP/1.1\r\nHost: 127.0.0.1\r\nCookie: {cookie}\r\n"
        known.sendall(upload.encode() + b"Connection: close\r\nContent-Length: 3\r\n\r\nx")
        made.sendall(ENTER + b"Content-Length: 100\r\n\r\n{")
        assert everything(made).startswith(b"HTTP/1.1 408")
        known.sendall(b"yz")
        assert b"map_" in everything(known), "it was read to its end, and is no map"


@pytest.mark.parametrize(("size", "status"), [(1024, b"400"), (1025, b"413")])
def test_a_strangers_body_is_short(strict: Gateway, size: int, status: bytes) -> None:
    with closing(line(strict)) as made:
        made.sendall(ENTER + b"Content-Length: %d\r\n\r\n" % size + b" " * size)
        assert made.recv(12) == b"HTTP/1.1 " + status
