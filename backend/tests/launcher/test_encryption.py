"""The launcher under TLS: what it hands on, and whom its own requests trust."""

from __future__ import annotations

import ssl
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest

from epf_gcs.launcher.encryption import tls_arguments
from epf_gcs.launcher.gateway_client import GatewayClient, UnreachableError
from epf_gcs.launcher.options import Options
from tests.support.tls import self_signed


def test_the_options_go_on_to_the_gateway_and_the_address_says_https() -> None:
    made = Options(data=Path("/data"), tls=True)
    assert made.url == "https://127.0.0.1:8000"
    assert made.trusted == Path("/data/tls/authority.crt")
    assert "--tls" in made.gateway_command(first=False)
    brought = Options(tls_cert=Path("/a.crt"), tls_key=Path("/a.key"))
    assert brought.url.startswith("https:")
    assert brought.trusted == Path("/a.crt")
    assert tls_arguments(brought.tls_cert, brought.tls_key, tls=False) == [
        "--tls-cert",
        "/a.crt",
        "--tls-key",
        "/a.key",
    ]
    plain = Options()
    assert (plain.scheme, plain.trusted, tls_arguments(None, None, tls=False)) == ("http", None, [])


@contextmanager
def server(certificate: Path, key: Path) -> Iterator[str]:
    """Answers `{}` to everything, as a gateway with this certificate."""

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            self.send_response(200)
            self.end_headers()
            self.wfile.write(b"{}")

        def log_message(self, *_: object) -> None:
            """Quietly."""

    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.load_cert_chain(certificate, key)
    with ThreadingHTTPServer(("127.0.0.1", 0), Handler) as running:
        running.socket = context.wrap_socket(running.socket, server_side=True)
        thread = threading.Thread(target=running.serve_forever, kwargs={"poll_interval": 0.01})
        thread.start()
        try:
            yield f"https://127.0.0.1:{running.server_port}"
        finally:
            running.shutdown()
            thread.join()


def test_the_launcher_trusts_the_certificate_on_its_own_disk_whatever_its_name(tmp_path: Path) -> None:
    certificate, key = self_signed(tmp_path)
    with server(certificate, key) as address:
        assert GatewayClient(address, trusted=certificate).status() == {}


def test_and_no_other(tmp_path: Path) -> None:
    certificate, key = self_signed(tmp_path)
    other, _ = self_signed(tmp_path, name="other")
    with server(certificate, key) as address, pytest.raises(UnreachableError, match="CERTIFICATE_VERIFY_FAILED"):
        GatewayClient(address, trusted=other).status()


def test_a_gateway_that_has_not_made_its_certificate_yet_is_waited_for(tmp_path: Path) -> None:
    with pytest.raises(UnreachableError, match="No such file"):
        GatewayClient("https://127.0.0.1:9", trusted=tmp_path / "authority.crt").status()
