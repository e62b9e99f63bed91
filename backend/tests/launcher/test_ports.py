"""Ports that are free, and the sentence about one that is not."""

import socket
from collections.abc import Iterator

import pytest

from epf_gcs.launcher.errors import LaunchError
from epf_gcs.launcher.ports import LOOPBACK, free_udp_port, listener_of, require_tcp_port


@pytest.fixture
def listening_port() -> Iterator[int]:
    with socket.create_server((LOOPBACK, 0)) as server:
        yield server.getsockname()[1]


def test_a_taken_port_is_told_with_who_has_it_and_what_to_do(listening_port: int) -> None:
    with pytest.raises(LaunchError) as caught:
        require_tcp_port(LOOPBACK, listening_port)
    sentence = str(caught.value)
    assert f"Port {listening_port} is taken by another program (" in sentence
    assert "process " in sentence
    assert "--port 8001" in sentence
    assert "make run PORT=8001" in sentence


def test_a_port_that_no_browser_opens_is_told_before_anything_starts() -> None:
    with pytest.raises(LaunchError, match=r"^Port 10080 is one that browsers refuse to open; choose .*PORT=8001"):
        require_tcp_port(LOOPBACK, 10080)


def test_a_free_port_is_left_free(listening_port: int) -> None:
    with socket.create_server((LOOPBACK, 0)) as server:
        port = server.getsockname()[1]
    require_tcp_port(LOOPBACK, port)
    require_tcp_port(LOOPBACK, port)
    assert listener_of(port) is None


def test_a_port_that_was_closed_a_moment_ago_is_free() -> None:
    server = socket.create_server((LOOPBACK, 0))
    port = server.getsockname()[1]
    client = socket.create_connection((LOOPBACK, port))
    accepted, _ = server.accept()
    accepted.close()
    server.close()
    client.close()
    require_tcp_port(LOOPBACK, port)


def test_a_free_udp_port_is_taken_as_wanted_and_a_taken_one_replaced() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.bind((LOOPBACK, 0))
        taken = other.getsockname()[1]
        replacement = free_udp_port(taken)
        assert replacement != taken
    assert free_udp_port(taken) == taken
    assert free_udp_port(replacement) == replacement
