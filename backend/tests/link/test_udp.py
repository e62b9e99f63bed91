"""Datagrams over real sockets on the loopback."""

from __future__ import annotations

import socket
from collections.abc import Iterator

import pytest

from epf_gcs.errors import LinkError
from epf_gcs.link.udp import Found, UdpAddress, UdpCallbacks, UdpLink, open_udp
from tests.support.ports import free_udp_port
from tests.support.waiting import DEADLINE_S, eventually_async

pytestmark = pytest.mark.anyio


@pytest.fixture
def simulator() -> Iterator[socket.socket]:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        sock.bind(("127.0.0.1", 0))
        sock.settimeout(DEADLINE_S)
        yield sock


class Heard:
    """What the link told, and what its tap saw."""

    def __init__(self) -> None:
        self.datagrams: list[bytes] = []
        self.strangers: list[str] = []
        self.stranger_count = 0
        self.recorded: list[bytes] = []
        self.now_s = 0.0

    @property
    def callbacks(self) -> UdpCallbacks:
        return UdpCallbacks(self.datagrams.append, self._on_strangers, self, lambda datagram: datagram[:1] != b"?")

    async def open(self, send_port: int, host: str = "127.0.0.1", *numbers: str) -> UdpLink:
        address = UdpAddress(free_udp_port(), host, send_port)
        if not numbers:
            return await open_udp(address, self.callbacks, now_s=lambda: self.now_s)

        async def look_up(_: str, port: int) -> list[Found]:
            return [entry for one in numbers for entry in socket.getaddrinfo(one, port, type=socket.SOCK_DGRAM)]

        return await open_udp(address, self.callbacks, look_up, lambda: self.now_s)

    def received(self, data: bytes, ago_s: float = 0.0) -> None:
        del ago_s
        self.recorded.append(data)

    def sent(self, data: bytes) -> None:
        pass

    def _on_strangers(self, sender: str, count: int) -> None:
        self.strangers.append(sender)
        self.stranger_count += count


@pytest.fixture
def other() -> Iterator[socket.socket]:
    """Another program on the simulator's machine."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        sock.bind(("127.0.0.1", 0))
        sock.settimeout(DEADLINE_S)
        yield sock


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


async def test_a_stranger_is_neither_heard_nor_recorded(simulator: socket.socket) -> None:
    heard = Heard()
    link = await heard.open(simulator.getsockname()[1])
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
        stranger.bind(("127.0.0.2", 0))
        port = stranger.getsockname()[1]
        stranger.sendto(b"DATA", ("127.0.0.1", link.receive_port))
    await eventually_async(lambda: heard.strangers == [f"127.0.0.2:{port}"], "the stranger is noticed")
    assert (heard.datagrams, heard.recorded) == ([], [])
    link.close()


async def test_another_program_on_the_simulators_machine_is_a_stranger_once_the_simulator_is_heard(
    simulator: socket.socket, other: socket.socket
) -> None:
    heard = Heard()
    link = await heard.open(simulator.getsockname()[1])
    here = ("127.0.0.1", link.receive_port)
    simulator.sendto(b"row 1", here)
    await eventually_async(lambda: heard.datagrams == [b"row 1"], "the simulator is heard")
    assert link.pinned == f"127.0.0.1:{simulator.getsockname()[1]}"
    other.sendto(b"forged", here)
    await eventually_async(lambda: heard.stranger_count == 1, "the other is noticed")
    simulator.sendto(b"row 2", here)
    await eventually_async(lambda: heard.datagrams == [b"row 1", b"row 2"], "the simulator is still heard")
    assert heard.recorded == heard.datagrams
    link.close()


async def test_what_is_no_datagram_of_a_simulator_pins_nobody(simulator: socket.socket, other: socket.socket) -> None:
    heard = Heard()
    link = await heard.open(simulator.getsockname()[1])
    here = ("127.0.0.1", link.receive_port)
    other.sendto(b"?", here)
    await eventually_async(lambda: heard.datagrams == [b"?"], "it is handed on, to be complained of")
    assert (link.pinned, heard.recorded) == (None, [])
    simulator.sendto(b"row", here)
    await eventually_async(lambda: link.pinned is not None, "the simulator is pinned")
    assert heard.stranger_count == 0
    link.close()


async def test_the_pin_moves_only_when_the_pinned_one_has_been_silent(
    simulator: socket.socket, other: socket.socket
) -> None:
    heard = Heard()
    link = await heard.open(simulator.getsockname()[1])
    here = ("127.0.0.1", link.receive_port)
    simulator.sendto(b"before", here)
    await eventually_async(lambda: heard.datagrams == [b"before"], "the simulator is heard")
    heard.now_s = 1.9
    other.sendto(b"too early", here)
    await eventually_async(lambda: heard.stranger_count == 1, "too early")
    heard.now_s = 2.0
    other.sendto(b"restarted", here)
    await eventually_async(lambda: heard.datagrams == [b"before", b"restarted"], "it is the simulator now")
    simulator.sendto(b"late", here)
    await eventually_async(lambda: heard.stranger_count == 2, "the earlier one is a stranger now")
    other.sendto(b"again", here)
    await eventually_async(lambda: heard.datagrams[-1] == b"again", "the new one is heard")
    assert heard.recorded == [b"before", b"restarted", b"again"]
    link.close()


async def test_a_flood_is_counted_and_takes_nothing_from_the_simulator(
    simulator: socket.socket, other: socket.socket
) -> None:
    heard = Heard()
    link = await heard.open(simulator.getsockname()[1])
    here = ("127.0.0.1", link.receive_port)
    simulator.sendto(b"row 0", here)
    await eventually_async(lambda: heard.datagrams == [b"row 0"], "the simulator is heard")
    for index in range(1, 11):
        # Far more than fit into the queue of a socket, while nobody reads it.
        for _ in range(1000):
            other.sendto(b"DATA@" + bytes(36), here)
        simulator.sendto(b"row %d" % index, here)
    await eventually_async(lambda: len(heard.datagrams) == 11, "every row arrives")
    assert heard.datagrams == [b"row %d" % index for index in range(11)]

    def counted() -> bool:
        other.sendto(b"one more", here)
        return heard.stranger_count >= 10_000

    await eventually_async(counted, "those are counted too that the system dropped")
    assert heard.recorded == heard.datagrams
    assert len(heard.strangers) < heard.stranger_count, "they are told of together"
    link.close()


@pytest.mark.parametrize(("family", "number"), [(socket.AF_INET6, "::1"), (socket.AF_INET, "127.0.0.1")])
async def test_a_name_with_addresses_of_both_kinds_is_heard_and_answered_on_either(
    family: socket.AddressFamily, number: str
) -> None:
    heard = Heard()
    with socket.socket(family, socket.SOCK_DGRAM) as simulator:
        simulator.bind((number, 0))
        simulator.settimeout(DEADLINE_S)
        link = await heard.open(simulator.getsockname()[1], "localhost", "::1", "127.0.0.1")
        assert link.send(b"before it was heard")
        assert simulator.recv(100) == b"before it was heard"
        simulator.sendto(b"row 1", (number, link.receive_port))
        await eventually_async(lambda: heard.datagrams == [b"row 1"], "it is heard")
        assert link.send(b"surfaces")
        assert simulator.recv(100) == b"surfaces"
        simulator.sendto(b"row 2", (number, link.receive_port))
        await eventually_async(lambda: heard.datagrams == [b"row 1", b"row 2"], "it is still heard")
        link.close()


async def test_the_port_stays_ours_while_the_simulator_is_heard(simulator: socket.socket) -> None:
    heard = Heard()
    link = await heard.open(simulator.getsockname()[1])
    simulator.sendto(b"row", ("127.0.0.1", link.receive_port))
    await eventually_async(lambda: heard.datagrams == [b"row"], "the simulator is heard")
    with pytest.raises(LinkError, match="is taken by another program"):
        await open_udp(UdpAddress(link.receive_port, "127.0.0.1", 49000), heard.callbacks)
    port = link.receive_port
    link.close()
    (await open_udp(UdpAddress(port, "127.0.0.1", 49000), heard.callbacks)).close()


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
