"""Who may command, and what a browser may do with our answers."""

from __future__ import annotations

import socket
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support.fake_board import FakeBoard
from tests.support.gateway import Gateway, running_gateway
from tests.support.waiting import DEADLINE_S


@pytest.mark.parametrize(
    "origin", ["http://evil.example", "https://127.0.0.1:1", "null", "http://127.0.0.1", "file://", "x"]
)
def test_a_foreign_page_cannot_command(gateway: Gateway, board: FakeBoard, origin: str) -> None:
    gateway.open_board(board.url)
    for method, path in (("POST", "/commands/start"), ("PUT", "/links/board"), ("DELETE", "/links/board")):
        answer = gateway.http.request(method, path, headers={"Origin": origin})
        assert (answer.status_code, answer.json()["code"]) == (403, "foreign_origin")
    assert board.count("start") == 0
    assert gateway.status()["board"]["state"] == "open"
    assert gateway.status()["errors"] == {"foreign_origin": 3}


def test_a_page_of_the_other_scheme_is_another_servers_unless_a_proxy_says_that_it_speaks_tls(gateway: Gateway) -> None:
    origin = {"Origin": gateway.base.replace("http:", "https:")}
    answer = gateway.http.post("/commands/start", headers=origin)
    assert (answer.status_code, answer.json()["code"]) == (403, "foreign_origin")
    answer = gateway.http.post("/commands/start", headers={**origin, "X-Forwarded-Proto": "https"})
    assert answer.json()["code"] != "foreign_origin"


@pytest.mark.parametrize(
    ("site", "mode", "dest", "is_answered"),
    [
        ("same-origin", "cors", "empty", True),
        ("none", "navigate", "document", True),
        ("cross-site", "navigate", "document", True),
        ("cross-site", "navigate", "iframe", False),
        ("cross-site", "no-cors", "image", False),
        ("cross-site", "cors", "empty", False),
        ("same-site", "no-cors", "script", False),
    ],
)
def test_a_page_of_another_server_may_lead_here_and_read_nothing(
    gateway: Gateway, site: str, mode: str, dest: str, *, is_answered: bool
) -> None:
    headers = {"Sec-Fetch-Site": site, "Sec-Fetch-Mode": mode, "Sec-Fetch-Dest": dest}
    answer = gateway.http.get("/status", headers=headers)
    assert answer.status_code == (200 if is_answered else 403)
    assert is_answered or answer.json()["code"] == "foreign_origin"


def test_our_own_page_can_command(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    answer = gateway.http.post("/commands/start", headers={"Origin": gateway.base})
    assert answer.json()["state"] == "confirmed"


@pytest.mark.parametrize("host", ["evil.example", "evil.example:80", "127.0.0.1.evil.example", "localhost.evil"])
def test_a_name_that_is_not_ours_is_not_answered(gateway: Gateway, host: str) -> None:
    for method in ("GET", "POST"):
        answer = gateway.http.request(method, "/status", headers={"Host": host})
        assert (answer.status_code, answer.json()["code"]) == (403, "foreign_host")


@pytest.mark.parametrize("host", ["[::1", "[", "[zz]:1", "127.0.0.1:8000.evil"])
def test_a_host_that_is_no_name_is_a_bad_request(gateway: Gateway, host: str) -> None:
    answer = gateway.http.get("/status", headers={"Host": host})
    assert (answer.status_code, answer.json()["code"]) == (400, "invalid_request")


@pytest.mark.parametrize("origin", ["http://[::1", "http://[zz]"])
def test_an_origin_that_is_no_address_cannot_command(gateway: Gateway, origin: str) -> None:
    answer = gateway.http.post("/commands/start", headers={"Origin": origin})
    assert (answer.status_code, answer.json()["code"]) == (403, "foreign_origin")


@pytest.mark.parametrize(
    "host",
    [
        "localhost:8000",
        "127.0.0.1",
        "[::1]:8000",
        "192.168.1.20:8000",
        # With a zone, as curl (RFC 6874) and others write it.
        "[fe80::1]:8000",
        "[fe80::1%25eth0]:8000",
        "[fe80::1%eth0]:8000",
    ],
)
def test_numbers_and_localhost_are_ours(gateway: Gateway, host: str) -> None:
    assert gateway.http.get("/status", headers={"Host": host}).status_code == 200


@pytest.fixture
def open_gateway(tmp_path: Path) -> Iterator[Gateway]:
    with running_gateway(
        tmp_path / "data", allowed_hosts=("station.lan",), allowed_origins=("http://127.0.0.1:5173",)
    ) as running:
        yield running


def test_more_names_and_pages_can_be_allowed(open_gateway: Gateway) -> None:
    assert open_gateway.http.get("/status", headers={"Host": "station.lan:8000"}).status_code == 200
    reads = {"Origin": "http://127.0.0.1:5173", "Sec-Fetch-Site": "same-site", "Sec-Fetch-Mode": "cors"}
    assert open_gateway.http.get("/status", headers=reads).status_code == 200
    answer = open_gateway.http.post("/commands/start", headers={"Origin": "http://127.0.0.1:5173"})
    assert answer.json()["code"] == "board_not_open"


def test_no_answer_is_given_to_other_pages(gateway: Gateway) -> None:
    answer = gateway.http.get("/status", headers={"Origin": "http://evil.example"})
    assert not [name for name in answer.headers if name.startswith("access-control")]
    preflight = gateway.http.options("/commands/start", headers={"Origin": "http://evil.example"})
    assert not [name for name in preflight.headers if name.startswith("access-control")]


@pytest.mark.parametrize("path", ["/status", "/no-such", "/openapi.json"])
def test_every_answer_has_a_strict_policy(gateway: Gateway, path: str) -> None:
    headers = gateway.http.get(path).headers
    policy = headers["content-security-policy"]
    assert "default-src 'self'" in policy
    assert "unsafe-inline" not in policy
    assert "frame-ancestors 'none'" in policy
    assert headers["x-content-type-options"] == "nosniff"
    assert headers["cache-control"] == "no-store"


@pytest.mark.parametrize("chunked", [False, True])
def test_a_body_that_is_too_long_is_refused(gateway: Gateway, *, chunked: bool) -> None:
    content: bytes | Iterator[bytes] = iter([b"x" * 40000] * 2) if chunked else b"x" * 80000
    answer = gateway.http.put("/links/board", content=content)
    assert (answer.status_code, answer.json()["code"]) == (413, "body_too_large")
    assert "65536 bytes" in answer.json()["detail"]


@pytest.mark.parametrize("content", [b"rubbish", b'{"url":', b"\xff\xfe", b"{'url': 1}"])
def test_what_is_no_json_is_said_to_be_none(gateway: Gateway, content: bytes) -> None:
    answer = gateway.http.put("/links/board", content=content, headers={"Content-Type": "application/json"})
    assert (answer.status_code, answer.json()["code"]) == (400, "bad_json")
    assert gateway.status()["errors"] == {"bad_json": 1}


def test_an_address_that_is_none_and_a_method_that_is_wrong_are_said_so(gateway: Gateway) -> None:
    missing = gateway.http.get("/no-such")
    assert (missing.status_code, missing.json()["code"]) == (404, "no_such_address")
    wrong = gateway.http.post("/status")
    assert (wrong.status_code, wrong.json()["code"]) == (405, "method_not_allowed")
    assert wrong.headers["content-type"] == "application/problem+json"
    assert "GET" in wrong.headers["allow"]


@pytest.mark.parametrize("name", ["Host", "Origin"])
def test_a_host_or_an_origin_that_comes_twice_is_a_bad_request_also_on_the_stream(gateway: Gateway, name: str) -> None:
    port = int(gateway.base.rpartition(":")[2])
    head = f"Host: 127.0.0.1:{port}\r\nConnection: close\r\n" + f"{name}: http://127.0.0.1:{port}\r\n" * 2
    upgrade = (
        "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
    )
    for what, more in (
        ("GET /api/v1/status", ""),
        ("POST /api/v1/commands/start", ""),
        ("GET /api/v1/stream", upgrade),
    ):
        with socket.create_connection(("127.0.0.1", port), timeout=DEADLINE_S) as line:
            line.sendall(f"{what} HTTP/1.1\r\n{head}{more}\r\n".encode())
            assert line.recv(4096).split(b" ", 2)[1] == b"400", what
