"""Who is this computer itself, and who only looks like it."""

from __future__ import annotations

import os
import socket
import sys
from pathlib import Path

import pytest

from epf_gcs.access import caller as caller_module
from epf_gcs.access import socket_owner
from epf_gcs.access.admission import Admission, Policy, bearer_key
from epf_gcs.access.caller import Credentials, Peer, is_in_container, is_loopback
from epf_gcs.access.socket_owner import NOBODY, UNTOLD, Connection, owner_of
from epf_gcs.clock import Clock
from epf_gcs.web.serving.settings import Settings
from tests.support.callers import stranger
from tests.support.gateway import Gateway

HEAD = b"  sl  local_address rem_address   st tx_queue rx_queue tr tm->when retrnsmt   uid  timeout inode\n"


def seen_from(accepted: socket.socket) -> Connection:
    return Connection(*accepted.getpeername()[:2], *accepted.getsockname()[:2])


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux says whose a socket is")
@pytest.mark.parametrize("way", ["asked", "read"])
@pytest.mark.parametrize("host", ["127.0.0.1", "::1"])
def test_the_system_says_whose_the_other_end_is(monkeypatch: pytest.MonkeyPatch, way: str, host: str) -> None:
    other = "_in_table" if way == "asked" else "_asked"
    monkeypatch.setattr(socket_owner, other, lambda _: None if way == "read" else 4711)
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    with socket.create_server((host, 0), family=family) as server:
        client = socket.create_connection(server.getsockname()[:2])
        accepted, _ = server.accept()
        with client, accepted:
            connection = seen_from(accepted)
            assert owner_of(connection) == os.getuid()
            client.close()
            # The system calls what is left of a closed socket root's.
            assert owner_of(connection) == NOBODY


@pytest.mark.parametrize(
    ("rows", "owner"),
    [
        (b"   0: 0100007F:C350 0100007F:1F40 01 00000000:00000000 00:00000000 00000000  1001        0 99\n", 1001),
        # Waiting after its end, to another server, and the server's own end.
        (b"   0: 0100007F:C350 0100007F:1F40 06 00000000:00000000 00:00000000 00000000     0        0 0\n", NOBODY),
        (b"   0: 0100007F:C350 0100007F:0050 01 00000000:00000000 00:00000000 00000000     0        0 99\n", NOBODY),
        (b"   0: 0100007F:1F40 0100007F:C350 01 00000000:00000000 00:00000000 00000000     0        0 99\n", NOBODY),
        (b"", NOBODY),
    ],
)
@pytest.mark.skipif(sys.byteorder != "little", reason="the rows are of such a machine")
def test_a_row_counts_only_if_it_is_the_other_end_and_open(tmp_path: Path, rows: bytes, owner: int) -> None:
    (tmp_path / "tcp").write_bytes(HEAD + rows)
    assert socket_owner._in_table(Connection("127.0.0.1", 50000, "127.0.0.1", 8000), tmp_path) == owner
    no_such_table = Connection("::1", 50000, "::1", 8000)
    assert socket_owner._in_table(no_such_table, tmp_path) == NOBODY, "what cannot be read is no reason to trust"


@pytest.mark.parametrize(
    ("owner", "is_ours"), [(4711, False), (os.getuid(), True), (0, True), (UNTOLD, True), (NOBODY, False)]
)
def test_another_user_of_this_computer_is_a_stranger(
    monkeypatch: pytest.MonkeyPatch, owner: int, *, is_ours: bool
) -> None:
    monkeypatch.setattr(caller_module, "owner_of", lambda _: owner)
    assert Peer(("127.0.0.1", 50000), ("127.0.0.1", 8000)).is_ours is is_ours
    assert not Peer(("192.0.2.1", 50000), ("192.0.2.2", 8000)).is_ours
    assert not Peer(None, ("127.0.0.1", 8000)).is_ours


@pytest.mark.parametrize("header", ["Forwarded", "X-Forwarded-For", "X-Forwarded-Proto", "X-Real-IP", "Via"])
def test_what_comes_through_a_proxy_is_not_this_computer(gateway: Gateway, header: str) -> None:
    with stranger(gateway) as client:
        assert client.get("/access/me").json()["kind"] == "local"
        assert client.get("/status", headers={header: "for=192.0.2.60"}).status_code == 401


def test_this_computer_needs_no_key(gateway: Gateway) -> None:
    with stranger(gateway) as client:
        assert client.get("/access/me").json() == {
            "state": "in",
            "kind": "local",
            "role": "owner",
            "name": "local",
            "anyone_may_fly": False,
        }


@pytest.mark.parametrize(
    ("host", "in_container", "trusted"),
    [("127.0.0.1", True, True), ("::1", True, True), ("0.0.0.0", True, False), ("0.0.0.0", False, True)],  # noqa: S104
)
def test_a_container_that_others_reach_does_not_trust_its_loopback(
    monkeypatch: pytest.MonkeyPatch, host: str, *, in_container: bool, trusted: bool
) -> None:
    monkeypatch.setattr("epf_gcs.web.serving.settings.is_in_container", lambda: in_container)
    assert Settings(host=host).policy.trusts_this_computer is trusted
    assert Settings(host=host, trust_this_computer=True).policy.trusts_this_computer
    assert not Settings(host=host, trust_this_computer=False).policy.trusts_this_computer


def test_a_container_is_known_by_its_marks(tmp_path: Path) -> None:
    mark = tmp_path / "mark"
    assert not is_in_container([mark], {})
    assert is_in_container([mark], {"container": "podman"})
    mark.touch()
    assert is_in_container([mark], {})


@pytest.mark.parametrize(
    ("host", "is_ours"), [("127.0.0.1", True), ("127.8.9.1", True), ("::1", True), ("", False), ("10.0.0.1", False)]
)
def test_the_loopback_is_known(host: str, *, is_ours: bool) -> None:
    assert is_loopback(host) is is_ours


@pytest.mark.parametrize(
    ("header", "key"),
    [
        ("Bearer epf_x", "epf_x"),
        ("bearer  epf_x ", "epf_x"),
        ("Basic ZXBmOmVwZl94", "epf_x"),
        ("Basic %%%", None),
        ("Basic ", None),
        ("Basic /w==", None),
        ("Digest x", None),
        ("Bearer ", None),
        ("", None),
    ],
)
def test_a_key_is_read_from_its_header(header: str, key: str | None) -> None:
    assert bearer_key(header) == key


def test_a_repeated_header_is_no_key() -> None:
    shown = Credentials.of([(b"authorization", b"Bearer a"), (b"authorization", b"Bearer b")], Peer(None, None))
    assert bearer_key(shown.authorization or "") == "a,Bearer b"


def test_nobody_is_in_before_the_lists_were_read(tmp_path: Path) -> None:
    admission = Admission(Policy(True, True, "127.0.0.1"), tmp_path, lambda _: None, Clock())
    assert admission.resolve(Credentials(Peer(("127.0.0.1", 1), ("127.0.0.1", 1)), "", None, False)) is None
