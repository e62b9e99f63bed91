"""The datagram socket to the flight simulator."""

from __future__ import annotations

import asyncio
import ipaddress
import socket
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from epf_gcs.errors import LinkError
from epf_gcs.link.base import Tap
from epf_gcs.link.failures import link_error

# All rows that a simulator has are 5 kB.
_MAX_DATAGRAM_BYTES: Final = 16384
# A datagram longer than this holds a whole frame of the simulator: nothing else is waiting behind it.
_LONG_BYTES: Final = 128
# Datagrams taken in one go; a flood must not keep the loop from everything else.
_BURST: Final = 16

SocketAddress = tuple[str, int] | tuple[str, int, int, int] | tuple[int, bytes]


@dataclass(frozen=True, slots=True)
class UdpAddress:
    """Where we listen and where the simulator is."""

    receive_port: int
    send_host: str
    send_port: int


@dataclass(frozen=True, slots=True)
class UdpCallbacks:
    """Whom the socket tells, on the event loop. A stranger is any host but the configured one."""

    on_datagram: Callable[[bytes], None]
    on_stranger: Callable[[str], None]
    tap: Tap | None = None


async def open_udp(address: UdpAddress, callbacks: UdpCallbacks) -> UdpLink:
    """Bind the receive port: on the loopback alone where the simulator is there. Raises LinkError."""
    loop = asyncio.get_running_loop()
    try:
        found = await loop.getaddrinfo(address.send_host, address.send_port, type=socket.SOCK_DGRAM)
    except (socket.gaierror, UnicodeError) as error:
        raise LinkError(
            "simulator_unknown_host",
            f"The simulator's host '{address.send_host}' is not known: correct its name, or write its number.",
            host=address.send_host,
        ) from error
    family, _, _, _, where = found[0]
    known = frozenset(str(entry[4][0]) for entry in found)
    sock = socket.socket(family, socket.SOCK_DGRAM)
    try:
        sock.setblocking(False)
        host = str(where[0])
        local = host if ipaddress.ip_address(host).is_loopback else ""
        sock.bind((local, address.receive_port))
    except OSError as error:
        sock.close()
        raise link_error(f"UDP port {address.receive_port}", error) from error
    return UdpLink(sock, where, known, callbacks)


class UdpLink:
    """Hands over each datagram as it arrives. Made on a running loop."""

    def __init__(
        self, sock: socket.socket, send_to: SocketAddress, known_hosts: frozenset[str], callbacks: UdpCallbacks
    ) -> None:
        self._sock = sock
        self._send_to = send_to
        self._known_hosts = known_hosts
        self._callbacks = callbacks
        self._loop = asyncio.get_running_loop()
        self._closed = False
        self.send_failures = 0
        self._loop.add_reader(sock.fileno(), self._readable)

    @property
    def receive_port(self) -> int:
        """The port that we listen on."""
        return int(self._sock.getsockname()[1])

    def send(self, datagram: bytes) -> bool:
        """Send now or not at all; a datagram that cannot leave is counted, not kept."""
        if self._closed:
            return False
        try:
            self._sock.sendto(datagram, self._send_to)
        except OSError:
            self.send_failures += 1
            return False
        if self._callbacks.tap is not None:
            self._callbacks.tap.sent(datagram)
        return True

    def close(self) -> None:
        """Let the port go. No callback comes after this."""
        if self._closed:
            return
        self._closed = True
        self._loop.remove_reader(self._sock.fileno())
        self._sock.close()

    def _readable(self) -> None:
        for _ in range(_BURST):
            try:
                datagram, sender = self._sock.recvfrom(_MAX_DATAGRAM_BYTES)
            except OSError:
                # Nothing more to read, or an ICMP complaint about something that we sent.
                return
            if self._callbacks.tap is not None:
                self._callbacks.tap.received(datagram)
            if sender[0] in self._known_hosts:
                self._callbacks.on_datagram(datagram)
            else:
                self._callbacks.on_stranger(str(sender[0]))
            if self._closed or len(datagram) > _LONG_BYTES:
                return
