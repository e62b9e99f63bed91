"""A whole station under TLS: redirect, names, certificates of the interface, and what only a brought one gets."""

from __future__ import annotations

import http.client
import os
import re
import signal
import socket
import ssl
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import httpx
import pytest
from cryptography import x509

from epf_gcs.shares.holder import Standing
from epf_gcs.tls import keeper as keeper_module
from epf_gcs.web.interface.tls.routes import MEDIA_TYPE
from tests.support.gateway import Gateway, running_gateway
from tests.support.programs import children_of, gateway_process, words_of
from tests.support.tls import careless, self_signed, trusting
from tests.support.waiting import DEADLINE_S, eventually


@pytest.fixture(scope="module")
def secure(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Gateway]:
    data = tmp_path_factory.mktemp("station") / "data"
    with running_gateway(data, tls=True, allowed_hosts=("müller.example", "fd00::7")) as running:
        yield running


def plain(gateway: Gateway, method: str, target: str, host: str | None = None, body: bytes = b"") -> httpx.Response:
    """A request in plain text, its target as written."""
    made = http.client.HTTPConnection("127.0.0.1", gateway.server.port, timeout=DEADLINE_S)
    with closing(made):
        made.putrequest(method, target, skip_host=True)
        if host != "":
            made.putheader("Host", host or f"127.0.0.1:{gateway.server.port}")
        made.putheader("Content-Length", str(len(body)))
        made.endheaders(body)
        answer = made.getresponse()
        return httpx.Response(answer.status, headers=answer.getheaders(), content=answer.read())


@pytest.mark.parametrize(
    "target", ["/", "/api/v1/status", "/a%20b//c?x=1&y=%2F&z", "/?flight=20260131T120000Z&at=3.5", "//evil.example/x"]
)
def test_plain_text_is_sent_on_with_path_and_query_as_they_were(secure: Gateway, target: str) -> None:
    answer = plain(secure, "GET", target)
    assert answer.status_code == 308
    assert answer.headers["Location"] == f"{secure.base}{target}"
    assert answer.headers["Cache-Control"] == "no-store"
    assert answer.content == b""


@pytest.mark.parametrize("method", ["POST", "PUT", "DELETE", "HEAD"])
def test_whatever_is_asked_nothing_is_done_in_plain_text(secure: Gateway, method: str) -> None:
    answer = plain(secure, method, "/api/v1/track/reset", body=b"{}")
    assert (answer.status_code, answer.headers["Location"]) == (308, f"{secure.base}/api/v1/track/reset")


def test_a_websocket_in_plain_text_is_sent_on_too(secure: Gateway) -> None:
    with closing(socket.create_connection(("127.0.0.1", secure.server.port), timeout=DEADLINE_S)) as made:
        made.sendall(
            b"GET /api/v1/stream HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
            b"Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n"
        )
        assert made.recv(1000).startswith(b"HTTP/1.1 308")


@pytest.mark.parametrize(
    ("host", "status"),
    [
        ("evil.example", 403),
        ("evil.example:443", 403),
        ("127.0.0.1.evil.example", 403),
        ("127.0.0.1@evil.example", 403),
        ("[", 400),
        ("", 403),
    ],
)
def test_a_forged_host_is_sent_nowhere(secure: Gateway, host: str, status: int) -> None:
    answer = plain(secure, "GET", "/", host=host)
    assert answer.status_code == status
    assert "Location" not in answer.headers


@pytest.mark.parametrize(
    ("host", "place"),
    [
        ("localhost:9", "localhost:9"),
        ("LOCALHOST", "localhost"),
        ("evil.example@127.0.0.1:9", "127.0.0.1:9"),
        ("[fd00::7]:8000", "[fd00::7]:8000"),
        ("[fe80::1%25eth0]:8000", "[fe80::1%25eth0]:8000"),
        ("xn--mller-kva.example", "xn--mller-kva.example"),
    ],
)
def test_a_name_of_the_station_is_sent_on_to_itself(secure: Gateway, host: str, place: str) -> None:
    assert plain(secure, "GET", "/x", host=host).headers["Location"] == f"https://{place}/x"


@pytest.mark.parametrize("name", ["127.0.0.1", "localhost", "müller.example", "::1", "fd00::7", "name.local"])
def test_a_phone_that_trusts_the_authority_opens_it_by_name_and_number(secure: Gateway, name: str) -> None:
    if name == "name.local":
        name = next(one for one in secure.http.get("/access/certificates").json()["certificate"]["names"])
    der = secure.http.get("/access/authority").content
    phone = ssl.create_default_context(cadata=der)
    host = f"[{name}]" if ":" in name else name.encode("idna").decode()
    with (
        closing(socket.create_connection(("127.0.0.1", secure.server.port), timeout=DEADLINE_S)) as made,
        phone.wrap_socket(made, server_hostname=name) as encrypted,
    ):
        encrypted.sendall(f"GET /api/v1/status HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n".encode())
        answer = encrypted.recv(1000)
    assert answer.startswith(b"HTTP/1.1 200")


def test_another_name_is_refused_by_the_phone_and_by_the_station(secure: Gateway) -> None:
    phone = ssl.create_default_context(cadata=secure.http.get("/access/authority").content)
    for context in (phone, careless()):
        made = socket.create_connection(("127.0.0.1", secure.server.port), timeout=DEADLINE_S)
        with closing(made):
            try:
                encrypted = context.wrap_socket(made, server_hostname="evil.example")
            except ssl.SSLCertVerificationError:
                assert context is phone
                continue
            with encrypted:
                assert context is not phone
                encrypted.sendall(b"GET / HTTP/1.1\r\nHost: evil.example\r\nConnection: close\r\n\r\n")
                assert encrypted.recv(1000).startswith(b"HTTP/1.1 403")


def test_the_interface_tells_what_a_browser_is_shown(secure: Gateway) -> None:
    told = secure.http.get("/access/certificates").json()
    shown = ssl.create_default_context(cadata=secure.http.get("/access/authority").content)
    with (
        closing(socket.create_connection(("127.0.0.1", secure.server.port), timeout=DEADLINE_S)) as made,
        shown.wrap_socket(made, server_hostname="127.0.0.1") as encrypted,
    ):
        certificate = x509.load_der_x509_certificate(encrypted.getpeercert(binary_form=True) or b"")
    assert told["fault"] is None
    assert told["certificate"]["kind"] == "made"
    assert {"localhost", "xn--mller-kva.example"} <= set(told["certificate"]["names"])
    assert {"127.0.0.1", "::1", "fd00::7"} <= set(told["certificate"]["addresses"])
    assert told["certificate"]["until_s"] == certificate.not_valid_after_utc.timestamp()
    assert told["authority"]["name"] == certificate.issuer.rfc4514_string().removeprefix("CN=")


def test_the_authority_comes_as_a_phone_takes_it(secure: Gateway) -> None:
    answer = secure.http.get("/access/authority")
    assert answer.headers["Content-Type"] == MEDIA_TYPE
    authority = x509.load_der_x509_certificate(answer.content)
    file = secure.flight_thread.data_dir / "tls" / "authority.crt"
    assert authority == x509.load_pem_x509_certificate(file.read_bytes())


def test_a_phone_that_only_clicked_past_the_warning_is_not_locked_out_later(secure: Gateway) -> None:
    assert "Strict-Transport-Security" not in secure.http.get("/status").headers


def test_a_brought_certificate_is_insisted_on(tmp_path: Path) -> None:
    certificate, key = self_signed(tmp_path)
    with running_gateway(tmp_path / "data", tls_cert=certificate, tls_key=key) as gateway:
        assert gateway.http.get("/status").headers["Strict-Transport-Security"] == "max-age=86400"
        assert "Strict-Transport-Security" not in plain(gateway, "GET", "/").headers
        told = gateway.http.get("/access/certificates").json()
        assert (told["certificate"]["kind"], told["authority"]) == ("brought", None)
        answer = gateway.http.get("/access/authority")
        assert (answer.status_code, answer.json()["code"]) == (404, "tls_no_authority")
        assert not (tmp_path / "data" / "tls").exists()


def test_everybody_who_looks_is_told_that_the_certificate_cannot_be_renewed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(keeper_module, "LOOK_EVERY_S", 0.05)
    data, folder, file = (tmp_path / name for name in ("data", "folder", "file"))
    data.mkdir()
    folder.mkdir()
    (data / "tls").symlink_to(folder)
    file.write_bytes(b"what is put where the folder was")
    with running_gateway(data, tls=True) as gateway, gateway.stream() as stream:
        file.replace(data / "tls")  # In one step: the keeper never looks in between.
        told = stream.event("error")
        assert (told["code"], told["params"]["folder"]) == ("tls_not_renewed", str(data / "tls"))
        assert gateway.http.get("/access/certificates").json()["fault"]["code"] == "tls_not_renewed"


def test_without_tls_the_interface_says_so(gateway: Gateway) -> None:
    assert gateway.http.get("/access/certificates").json() == {"certificate": None, "authority": None, "fault": None}
    assert gateway.http.get("/access/authority").status_code == 404


def test_connections_that_never_finish_their_handshake_hurt_nobody(secure: Gateway) -> None:
    hello = b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc"
    halves = []
    try:
        with secure.stream() as stream:
            for number in range(500):
                half = socket.create_connection(("127.0.0.1", secure.server.port), timeout=DEADLINE_S)
                half.sendall(hello if number % 2 else b"")
                halves.append(half)
            stream.send({"type": "rate", "rate": 30})
            assert secure.http.get("/status").status_code == 200
            assert len(secure.server.visitors) <= secure.server.visitors.shares.connections.parts[Standing.own].each
            stream.next("status")
    finally:
        for half in halves:
            half.close()
    eventually(lambda: len(secure.server.visitors) < 10, "their places are free")


def test_a_browser_waits_while_the_web_process_starts_again_and_finds_the_same_certificate(tmp_path: Path) -> None:
    data = tmp_path / "data"
    with gateway_process(data, "--tls") as program:
        url = program.wait_for_words(r"url=(https://\S+)")
        trust = trusting(data / "tls" / "authority.crt")

        def web() -> int | None:
            for pid in children_of(program.process.pid):
                if "epf_gcs.web" in words_of(pid):
                    return pid
            return None

        with httpx.Client(base_url=f"{url}/api/v1", verify=trust, timeout=DEADLINE_S) as browser:
            before = browser.get("/access/certificates").json()["certificate"]
            first = web()
            assert first is not None
            os.kill(first, signal.SIGKILL)
            eventually(lambda: web() not in (None, first), "another web process starts")
        with httpx.Client(base_url=f"{url}/api/v1", verify=trust, timeout=DEADLINE_S) as browser:
            assert browser.get("/access/certificates").json()["certificate"] == before


def test_a_station_that_cannot_use_what_it_was_given_says_why_and_ends(tmp_path: Path) -> None:
    with gateway_process(tmp_path / "data", "--tls-cert", str(tmp_path / "missing.crt")) as program:
        program.wait_for_words(r"(missing\.crt cannot be read \(No such file or directory\).*--tls-cert)")
        assert program.process.wait(20) != 0
        assert re.search("Traceback", program.said) is None
