"""The datagram sockets to the flight simulator, and which sender is accepted on them.

The first sender on the simulator's host that sends a simulator's datagram is pinned: its address and port. From then
on it has a socket connected to it alone (the ear), so that the kernel keeps other senders out of that queue. Their
datagrams arrive at the socket that is open to all (the door), where they are counted, a few at a time, and dropped.
"""

from __future__ import annotations

import asyncio
import contextlib
import errno
import ipaddress
import socket
import sys
import time
from collections.abc import Awaitable, Callable, Iterable
from dataclasses import dataclass
from functools import partial
from typing import Any, Final

from epf_gcs.errors import LinkError
from epf_gcs.link.base import Tap
from epf_gcs.link.failures import link_error
from epf_gcs.repeating import Repeating
from epf_gcs.system.sockets import receive_with_notes

# All rows that a simulator has are 5 kB.
_MAX_DATAGRAM_BYTES: Final = 16384
# A datagram longer than this holds a whole frame of the simulator, so no other is expected right behind it.
_LONG_BYTES: Final = 128
# Datagrams taken in one go; a flood must not keep the loop from everything else.
_BURST: Final = 16
# Pause between reads of the door while strangers send and the pinned sender has its own socket: with `_BURST`, at most
# 320 strangers' datagrams are read in a second.
_DOOR_PAUSE_S: Final = 0.05
# Most datagrams read from the door after pinning a sender: those queued there are older than those at its own socket.
_QUEUED: Final = 256
# Another sender may be pinned after the pinned one was silent for this long. Longer than the second after which the
# simulator counts as lost, so that no sender takes over unnoticed; shorter than a simulator's restart on another port.
_PIN_S: Final = 2.0
_ANCILLARY_BYTES: Final = 64
_NO_SUCH_FAMILY: Final = (errno.EAFNOSUPPORT, errno.EADDRNOTAVAIL)
# SO_RXQ_OVFL, which Python does not name: with each datagram Linux reports how many a full queue dropped before it.
_DROP_COUNTER: Final = 40 if sys.platform == "linux" else None

SocketAddress = tuple[Any, ...]
Found = tuple[int, int, int, str, SocketAddress]
Resolve = Callable[[str, int], Awaitable[Iterable[Found]]]


@dataclass(frozen=True, slots=True)
class UdpAddress:
    """Where we listen and where the simulator is."""

    receive_port: int
    send_host: str
    send_port: int


def _anything(_: bytes) -> bool:
    return True


@dataclass(frozen=True, slots=True)
class UdpCallbacks:
    """The callbacks of the sockets, all called on the event loop.

    `on_strangers` gets the number of datagrams dropped and the sender of the newest. `belongs` tells whether a datagram
    is a simulator's; it is asked only to decide whether to pin the sender. The tap does not see strangers' datagrams.
    """

    on_datagram: Callable[[bytes], None]
    on_strangers: Callable[[str, int], None]
    tap: Tap | None = None
    belongs: Callable[[bytes], bool] = _anything


async def _look_up(host: str, port: int) -> Iterable[Found]:
    return await asyncio.get_running_loop().getaddrinfo(host, port, type=socket.SOCK_DGRAM)


async def open_udp(
    address: UdpAddress,
    callbacks: UdpCallbacks,
    look_up: Resolve = _look_up,
    now_s: Callable[[], float] = time.monotonic,
) -> UdpLink:
    """Bind the receive port, on the loopback alone if the simulator's address is one. Raises LinkError.

    If the host's name has IPv4 and IPv6 addresses, as localhost has, both are bound.
    """
    try:
        found = list(await look_up(address.send_host, address.send_port))
    except (socket.gaierror, UnicodeError) as error:
        raise LinkError(
            "simulator_unknown_host",
            f"The simulator's host '{address.send_host}' is not known: correct its name, or write its number.",
            host=address.send_host,
        ) from error
    doors: dict[int, socket.socket] = {}
    missing: OSError | None = None
    try:
        for family, _, _, _, where in found:
            if family not in doors:
                try:
                    doors[family] = _bind(family, str(where[0]), address.receive_port)
                except OSError as error:
                    if error.errno not in _NO_SUCH_FAMILY:
                        raise
                    missing = error
        if not doors:
            raise missing or OSError(errno.EADDRNOTAVAIL, "no address")
    except OSError as error:
        for door in doors.values():
            door.close()
        raise link_error(f"UDP port {address.receive_port}", error) from error
    peers = list(dict.fromkeys((family, where) for family, _, _, _, where in found if family in doors))
    return UdpLink(doors, peers, callbacks, now_s)


def _bind(family: int, host: str, port: int) -> socket.socket:
    sock = socket.socket(family, socket.SOCK_DGRAM)
    try:
        sock.setblocking(False)
        if family == socket.AF_INET6:
            sock.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_V6ONLY, 1)
        if _DROP_COUNTER is not None:
            sock.setsockopt(socket.SOL_SOCKET, _DROP_COUNTER, 1)
        sock.bind((host if ipaddress.ip_address(host.partition("%")[0]).is_loopback else "", port))
    except BaseException:
        sock.close()
        raise
    return sock


class UdpLink:
    """Hands over each datagram of the simulator as it arrives. Made on a running loop."""

    def __init__(
        self,
        doors: dict[int, socket.socket],
        peers: list[tuple[int, SocketAddress]],
        callbacks: UdpCallbacks,
        now_s: Callable[[], float],
    ) -> None:
        self._doors = doors
        self._known_hosts = frozenset(str(where[0]) for _, where in peers)
        # All addresses of the host are sent to until a datagram shows which one the simulator uses.
        self._send_to = peers
        self._send_port = int(peers[0][1][1])
        self._callbacks = callbacks
        self._now_s = now_s
        self._loop = asyncio.get_running_loop()
        self._closed = False
        self._pinned: SocketAddress | None = None
        self._heard_s = 0.0
        self._ear: socket.socket | None = None
        self._ear_heard = False
        self._may_have_ear = True
        self._dropped = dict.fromkeys(doors, 0)
        self._pauses = {
            family: Repeating(self._loop, "a port held back", partial(self._resume, family)) for family in doors
        }
        self.send_failures = 0
        for family, door in doors.items():
            self._loop.add_reader(door.fileno(), self._look_at_door, family)

    @property
    def receive_port(self) -> int:
        """The port that we listen on."""
        return int(next(iter(self._doors.values())).getsockname()[1])

    @property
    def pinned(self) -> str | None:
        """Host and port of the accepted sender, None before its first datagram."""
        return None if self._pinned is None else _spelled(self._pinned)

    @property
    def own_host(self) -> str | None:
        """Our IPv4 address towards the simulator; None without a way there, and where it is reached by IPv6 alone."""
        where = next((where for family, where in self._send_to if family == socket.AF_INET), None)
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe, contextlib.suppress(OSError):
            # Connecting such a socket sends nothing: it asks the system for the way.
            if where is not None:
                probe.connect(where)
                return str(probe.getsockname()[0])
        return None

    def send(self, datagram: bytes) -> bool:
        """Send at once; a datagram that cannot be sent is counted and dropped."""
        if self._closed:
            return False
        sent = False
        for family, where in self._send_to:
            try:
                self._doors[family].sendto(datagram, where)
                sent = True
            except OSError:
                self.send_failures += 1
        if sent and self._callbacks.tap is not None:
            self._callbacks.tap.sent(datagram)
        return sent

    def close(self) -> None:
        """Close the sockets. No callback comes after this."""
        if self._closed:
            return
        self._closed = True
        self._drop_ear()
        for pause in self._pauses.values():
            pause.stop()
        for door in self._doors.values():
            self._loop.remove_reader(door.fileno())
            door.close()

    def _listen(self) -> None:
        """The pinned sender's own socket is readable."""
        ear = self._ear
        for _ in range(_BURST):
            if ear is None or ear is not self._ear:
                return
            try:
                datagram, sender = ear.recvfrom(_MAX_DATAGRAM_BYTES)
            except OSError:
                # Nothing more to read, or an ICMP complaint about something that we sent.
                return
            if sender != self._pinned:
                # It was queued between this socket's bind and its connect.
                self._callbacks.on_strangers(_spelled(sender), 1)
                continue
            self._ear_heard = True
            self._take(datagram)
            if self._closed or len(datagram) > _LONG_BYTES:
                return

    def _look_at_door(self, family: int) -> None:
        """The door is readable: pass on the simulator's datagrams, count and drop the others."""
        door = self._doors[family]
        left, was_pinned_here = _BURST, False
        strangers, last = 0, None
        while left and not self._closed:
            left -= 1
            try:
                datagram, ancillary, _, sender = receive_with_notes(door, _MAX_DATAGRAM_BYTES, _ANCILLARY_BYTES)
            except OSError:
                break
            strangers += self._newly_dropped(family, ancillary)
            if sender == self._pinned:
                self._doubt_ear(is_queued=was_pinned_here)
                self._take(datagram)
            elif sender[0] not in self._known_hosts or self._is_pinned_now():
                strangers, last = strangers + 1, sender
                continue
            elif self._callbacks.belongs(datagram):
                self._pin(family, sender)
                self._take(datagram)
                left, was_pinned_here = _QUEUED, True
            else:
                self._callbacks.on_datagram(datagram)
            if self._ear is None and len(datagram) > _LONG_BYTES:
                break
        if last is not None and not self._closed:
            self._callbacks.on_strangers(_spelled(last), strangers)
            if self._ear is not None and not self._closed:
                self._pause(family)

    def _is_pinned_now(self) -> bool:
        return self._pinned is not None and self._now_s() - self._heard_s < _PIN_S

    def _take(self, datagram: bytes) -> None:
        self._heard_s = self._now_s()
        if self._callbacks.tap is not None:
            self._callbacks.tap.received(datagram)
        self._callbacks.on_datagram(datagram)

    def _doubt_ear(self, *, is_queued: bool) -> None:
        """The pinned sender's data came to the door: it sends to another address of ours than its own socket has.

        Then its own socket is given up, unless the datagram was queued at the door before that socket existed.
        """
        if self._ear is not None and not self._ear_heard and not is_queued:
            self._may_have_ear = False
            self._drop_ear()

    def _newly_dropped(self, family: int, ancillary: list[tuple[int, int, bytes]]) -> int:
        """Strangers' datagrams that a full queue dropped at this door since the last look; 0 while there is no ear."""
        for level, kind, data in ancillary:
            if level == socket.SOL_SOCKET and kind == _DROP_COUNTER:
                dropped = int.from_bytes(data[:4], sys.byteorder)
                before, self._dropped[family] = self._dropped[family], dropped
                return (dropped - before) % 2**32 if self._ear is not None else 0
        return 0

    def _pin(self, family: int, sender: SocketAddress) -> None:
        """Accept this sender as the simulator: receive it on a socket of its own, send to its host alone."""
        self._drop_ear()
        self._ear_heard = False
        self._pinned = sender
        self._send_to = [(family, (sender[0], self._send_port, *sender[2:]))]
        if self._may_have_ear:
            self._ear = _connected(self._doors[family], sender)
        if self._ear is not None:
            self._loop.add_reader(self._ear.fileno(), self._listen)

    def _drop_ear(self) -> None:
        ear, self._ear = self._ear, None
        if ear is not None:
            self._loop.remove_reader(ear.fileno())
            ear.close()

    def _pause(self, family: int) -> None:
        """Stop reading the door for a moment: only strangers send there, the simulator has its own socket."""
        self._loop.remove_reader(self._doors[family].fileno())
        self._pauses[family].arm(_DOOR_PAUSE_S)

    def _resume(self, family: int) -> None:
        self._loop.add_reader(self._doors[family].fileno(), self._look_at_door, family)


def _connected(door: socket.socket, sender: SocketAddress) -> socket.socket | None:
    """A second socket on the door's port that receives from `sender` alone; None if the system does not support it.

    The port may be shared only while this runs, so another program that binds it later is still told that it is taken.
    """
    if sys.platform != "linux":
        return None
    try:
        ear = socket.socket(door.family, socket.SOCK_DGRAM)
    except OSError:
        return None
    try:
        ear.setblocking(False)
        if door.family == socket.AF_INET6:
            ear.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_V6ONLY, 1)
        for sock in (door, ear):
            sock.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        ear.bind(door.getsockname())
        ear.connect(sender)
    except OSError:
        ear.close()
        return None
    finally:
        with contextlib.suppress(OSError):
            door.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 0)
    return ear


def _spelled(sender: SocketAddress) -> str:
    return f"[{sender[0]}]:{sender[1]}" if ":" in str(sender[0]) else f"{sender[0]}:{sender[1]}"
