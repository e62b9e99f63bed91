"""What the station offers under TLS, tried as a scanner does: every version and every suite, one by one."""

from __future__ import annotations

import ssl
import warnings
from pathlib import Path

import pytest

from epf_gcs.tls.context import make_context
from tests.support.tls import careless, self_signed, shake_hands

AEAD = ("AES128-GCM-SHA256", "AES256-GCM-SHA384", "CHACHA20-POLY1305")


def old_client(version: ssl.TLSVersion) -> ssl.SSLContext:
    """A client that offers this version alone, and whatever OpenSSL can speak in it."""
    client = careless()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)
        client.minimum_version = client.maximum_version = version
    client.set_ciphers("ALL:COMPLEMENTOFALL:@SECLEVEL=0")
    return client


@pytest.fixture(params=["ec", "2048"])
def kind(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture
def server(tmp_path: Path, kind: str) -> ssl.SSLContext:
    return make_context(*self_signed(tmp_path, kind=kind))


@pytest.mark.parametrize("version", [ssl.TLSVersion.TLSv1, ssl.TLSVersion.TLSv1_1])
def test_old_versions_are_refused(server: ssl.SSLContext, version: ssl.TLSVersion) -> None:
    # Said as well as tried: some builds of OpenSSL refuse them by themselves, and others do not.
    assert server.minimum_version == ssl.TLSVersion.TLSv1_2
    with pytest.raises(ssl.SSLError):
        shake_hands(old_client(version), server)


@pytest.mark.parametrize(
    ("version", "name"), [(ssl.TLSVersion.TLSv1_2, "TLSv1.2"), (ssl.TLSVersion.TLSv1_3, "TLSv1.3")]
)
def test_the_present_ones_are_spoken(server: ssl.SSLContext, version: ssl.TLSVersion, name: str) -> None:
    client = careless()
    client.minimum_version = client.maximum_version = version
    client.set_alpn_protocols(["h2", "http/1.1"])
    made = shake_hands(client, server)
    assert (made.version(), made.selected_alpn_protocol(), made.compression()) == (name, "http/1.1", None)


def test_of_all_suites_only_those_with_forward_secrecy_and_authentication_are_taken(
    server: ssl.SSLContext, kind: str
) -> None:
    client = old_client(ssl.TLSVersion.TLSv1_2)
    offered = [suite["name"] for suite in client.get_ciphers() if suite["protocol"] != "TLSv1.3"]
    assert len(offered) > 60
    taken = set()
    for suite in offered:
        client.set_ciphers(f"{suite}:@SECLEVEL=0")
        try:
            shake_hands(client, server)
        except ssl.SSLError:
            continue
        taken.add(suite)
    assert taken == {f"ECDHE-{'ECDSA' if kind == 'ec' else 'RSA'}-{one}" for one in AEAD}


def test_the_suites_of_the_newest_version_all_authenticate(server: ssl.SSLContext) -> None:
    newest = {suite["name"] for suite in server.get_ciphers() if suite["protocol"] == "TLSv1.3"}
    assert newest == {"TLS_AES_256_GCM_SHA384", "TLS_CHACHA20_POLY1305_SHA256", "TLS_AES_128_GCM_SHA256"}


def test_a_client_can_neither_renegotiate_nor_compress(server: ssl.SSLContext) -> None:
    """Renegotiating costs the station a handshake each time, past the limit of new connections."""
    assert server.options & ssl.OP_NO_RENEGOTIATION
    assert server.options & ssl.OP_NO_COMPRESSION
