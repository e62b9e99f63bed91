"""Datagrams over real sockets on the loopback."""

from __future__ import annotations

import socket
from collections.abc import Iterator

import pytest

from epf_gcs.errors import LinkError
from epf_gcs.link.udp import UdpAddress, UdpCallbacks, open_udp
from tests.support.ports import free_udp_port
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio


@pytest.fixture
def simulator() -> Iterator[socket.socket]:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        sock.bind(("127.0.0.1", 0))
        sock.settimeout(20.0)
        yield sock


class Heard:
    def __init__(self) -> None:
        self.datagrams: list[bytes] = []
        self.strangers: list[str] = []

    @property
    def callbacks(self) -> UdpCallbacks:
        return UdpCallbacks(self.datagrams.append, self.strangers.append)


async def test_datagrams_come_in_whole_and_answers_go_to_the_configured_port(simulator: socket.socket) -> None:
    heard = Heard()
    link = await open_udp(UdpAddress(free_udp_port(), "127.0.0.1", simulator.getsockname()[1]), heard.callbacks)
    for index in range(40):
        simulator.sendto(b"row %d" % index, ("127.0.0.1", link.receive_port))
    await eventually_async(lambda: len(heard.datagrams) == 40, "all datagrams arrive")
    assert heard.datagrams == [b"row %d" % index for index in range(40)]
    assert link.send(b"surfaces")
    assert simulator.recv(100) == b"surfaces"
    link.close()


async def test_a_stranger_is_not_heard(simulator: socket.socket) -> None:
    heard = Heard()
    link = await open_udp(UdpAddress(free_udp_port(), "127.0.0.1", simulator.getsockname()[1]), heard.callbacks)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
        stranger.bind(("127.0.0.2", 0))
        stranger.sendto(b"DATA", ("127.0.0.1", link.receive_port))
    await eventually_async(lambda: heard.strangers == ["127.0.0.2"], "the stranger is noticed")
    assert heard.datagrams == []
    link.close()


async def test_a_taken_port_is_named() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.bind(("127.0.0.1", 0))
        port = other.getsockname()[1]
        with pytest.raises(LinkError, match=f"UDP port {port} is taken by another program") as caught:
            await open_udp(UdpAddress(port, "127.0.0.1", 49000), Heard().callbacks)
    assert caught.value.code == "port_taken"


async def test_an_unknown_host_is_named() -> None:
    with pytest.raises(LinkError, match=r"no\.such\.host\.invalid") as caught:
        await open_udp(UdpAddress(free_udp_port(), "no.such.host.invalid", 49000), Heard().callbacks)
    assert caught.value.code == "simulator_unknown_host"


async def test_a_simulator_on_this_machine_opens_no_port_to_others() -> None:
    link = await open_udp(UdpAddress(free_udp_port(), "127.0.0.1", 49000), Heard().callbacks)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.bind(("127.0.0.3", link.receive_port))  # would be taken, had it been bound to every address
    link.close()


async def test_a_datagram_too_large_to_send_is_counted_and_not_kept(simulator: socket.socket) -> None:
    link = await open_udp(UdpAddress(free_udp_port(), "127.0.0.1", simulator.getsockname()[1]), Heard().callbacks)
    assert not link.send(b"x" * 70000)
    assert link.send_failures == 1
    link.close()
    assert not link.send(b"x")
