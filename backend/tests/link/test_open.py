"""Each kind of link opens; and where it cannot, one sentence says which, why and what to do."""

from __future__ import annotations

import contextlib
import os
import pty
import socket
import tty
from collections.abc import Iterator
from pathlib import Path

import pytest

from epf_gcs.errors import LinkError
from epf_gcs.link.address import parse_address
from epf_gcs.link.base import LinkCallbacks
from epf_gcs.link.open import open_link
from epf_gcs.link.tcp import Found, Resolve, open_tcp
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio


async def _failure(url: str) -> LinkError:
    with pytest.raises(LinkError) as caught:
        (await open_link(parse_address(url))).close()
    assert caught.value.detail.endswith(".")
    return caught.value


@pytest.fixture
def terminal() -> Iterator[tuple[int, str]]:
    master, slave = pty.openpty()
    tty.setraw(slave)
    yield master, os.ttyname(slave)
    for fd in (master, slave):
        with contextlib.suppress(OSError):
            os.close(fd)


@pytest.mark.parametrize("scheme", ["serial", "pty"])
async def test_a_terminal_opens_raw(terminal: tuple[int, str], scheme: str) -> None:
    master, path = terminal
    link = await open_link(parse_address(f"{scheme}://{path}"))
    got: list[bytes] = []
    link.start(LinkCallbacks(got.append, lambda _: None))
    os.write(master, b"\x03\r\n\x11\xff")
    await eventually_async(lambda: b"".join(got) == b"\x03\r\n\x11\xff", "every byte arrives as it is")
    assert link.write(b"\r\n\x04\xff")
    assert os.read(master, 100) == b"\r\n\x04\xff"
    link.close()


@pytest.mark.parametrize("scheme", ["serial", "pty"])
async def test_a_terminal_is_ours_alone(terminal: tuple[int, str], scheme: str) -> None:
    _, path = terminal
    link = await open_link(parse_address(f"{scheme}://{path}"))
    error = await _failure(f"{scheme}://{path}")
    assert error.code == "link_busy"
    assert "in use by another program" in error.detail
    link.close()
    (await open_link(parse_address(f"{scheme}://{path}"))).close()


@pytest.mark.parametrize("scheme", ["serial", "pty"])
async def test_a_missing_device_is_named(tmp_path: Path, scheme: str) -> None:
    error = await _failure(f"{scheme}://{tmp_path}/nothing")
    assert error.code == "link_no_device"
    assert f"{tmp_path}/nothing does not exist" in error.detail


@pytest.mark.parametrize("scheme", ["serial", "pty"])
async def test_a_file_is_no_serial_port(tmp_path: Path, scheme: str) -> None:
    (tmp_path / "file").write_text("text")
    assert (await _failure(f"{scheme}://{tmp_path}/file")).code == "link_not_serial"
    assert (await _failure(f"{scheme}://{tmp_path}")).code == "link_not_serial"


async def test_tcp_carries_bytes_both_ways() -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        link = await open_link(parse_address(f"tcp://127.0.0.1:{server.getsockname()[1]}"))
        peer, _ = server.accept()
        got: list[bytes] = []
        lost: list[LinkError] = []
        link.start(LinkCallbacks(got.append, lost.append))
        with peer:
            peer.sendall(b"from the board")
            await eventually_async(lambda: b"".join(got) == b"from the board", "the bytes arrive")
            link.write(b"to the board")
            assert peer.recv(100) == b"to the board"
        await eventually_async(lambda: bool(lost), "the hang-up is noticed")
        assert lost[0].code == "link_lost"


async def test_a_refused_connection_is_said_to_be_refused() -> None:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    error = await _failure(f"tcp://127.0.0.1:{port}")
    assert error.code == "link_refused"
    assert f"127.0.0.1:{port} refuses connections" in error.detail


async def test_an_unknown_host_is_named() -> None:
    error = await _failure("tcp://no.such.host.invalid:4000")
    assert error.code == "link_unknown_host"
    assert "no.such.host.invalid" in error.detail


async def test_a_name_that_no_network_can_have_is_an_unknown_host() -> None:
    assert (await _failure("tcp://a..b:5")).code == "link_unknown_host"


def _addresses(*numbers: str) -> Resolve:
    async def look_up(_: str, port: int) -> list[Found]:
        return [entry for one in numbers for entry in socket.getaddrinfo(one, port, type=socket.SOCK_STREAM)]

    return look_up


@pytest.mark.parametrize("number", ["127.0.0.1", "::1"])
async def test_all_addresses_of_a_host_are_tried(number: str) -> None:
    family = socket.AF_INET6 if ":" in number else socket.AF_INET
    with socket.create_server((number, 0), family=family) as server:
        address = parse_address(f"tcp://localhost:{server.getsockname()[1]}")
        device = await open_tcp(address, _addresses("::1", "127.0.0.2", "127.0.0.1"))
        peer, _ = server.accept()
        with peer:
            os.write(device.fd, b"to the board")
            assert peer.recv(100) == b"to the board"
        device.close()


async def test_a_host_none_of_whose_addresses_answers_is_told_once() -> None:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    with pytest.raises(LinkError) as caught:
        await open_tcp(parse_address(f"tcp://localhost:{port}"), _addresses("::1", "127.0.0.1"))
    assert caught.value.code == "link_refused"
    assert f"localhost:{port} refuses connections" in caught.value.detail
