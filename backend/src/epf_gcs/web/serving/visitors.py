"""The open connections, and their limits for each host and in total.

At a limit a new connection replaces an idle one, the longest idle of the host with the most connections, so that nobody
can lock others out by holding connections open. This computer has limits of its own, apart from all other hosts. A
network of IPv6 addresses is one host: any of its computers may use all of them.
"""

from __future__ import annotations

import ipaddress
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Final, Protocol

from epf_gcs.access.guessing import group_of

RESERVED_DESCRIPTORS: Final = 200
"""Descriptors kept for files, links, recordings and worker processes."""

_LEAST: Final = 50


@dataclass(frozen=True)
class Limits:
    """Limits on the number of connections (WebSockets included) and on their times, sizes and rates."""

    connections: int = 1000
    connections_per_host: int = 200
    for_this_computer: int = 300
    sockets: int = 400
    sockets_per_host: int = 120
    """A class behind one address, with a second page each. Who opens more than a few is somebody that was let in."""
    sockets_for_this_computer: int = 250
    handshake_s: float = 10.0
    """From the connection to the end of the TLS handshake."""
    head_s: float = 10.0
    head_bytes: int = 65536
    idle_s: int = 15
    least_bytes_per_s: float = 2000.0
    rate_looked_at_s: float = 10.0
    unread_s: float = 30.0
    """A connection whose client reads nothing of its answer for this long is closed."""


def fitting(limits: Limits, descriptors: int) -> Limits:
    """The limits, lowered if necessary to what this many file descriptors allow."""
    most = max(_LEAST, descriptors - RESERVED_DESCRIPTORS)
    if limits.connections + limits.for_this_computer <= most:
        return limits
    own = most // 3
    return replace(
        limits,
        connections=most - own,
        connections_per_host=min(limits.connections_per_host, (most - own) // 2),
        for_this_computer=own,
    )


class Visitor(Protocol):
    """One connection."""

    host: str
    idle_since_s: float | None
    """Loop time since when it waits for a request or the rest of a head; None while it handles one."""

    def make_room(self) -> None:
        """Close at once: another connection needs the place."""


class Visitors:
    """All connections of this server. Owned by the event loop."""

    def __init__(self, limits: Limits) -> None:
        self.limits = limits
        self.refused: Counter[str] = Counter()
        # By host; those of this computer under "".
        self._of: dict[str, dict[Visitor, None]] = {}
        self._sockets: dict[str, set[Visitor]] = {}

    def __iter__(self) -> Iterator[Visitor]:
        return iter([one for those in self._of.values() for one in those])

    def __len__(self) -> int:
        return sum(map(len, self._of.values()))

    @property
    def sockets(self) -> int:
        """Number of WebSockets."""
        return sum(map(len, self._sockets.values()))

    def come_in(self, visitor: Visitor) -> bool:
        """Add a connection; False if the limit is reached and no idle connection can be closed."""
        key, limits = host_of(visitor.host), self.limits
        most = limits.connections_per_host if key else limits.for_this_computer
        fits = len(self._of.get(key, ())) < most or self._make_room([key])
        if fits and key and len(self) - len(self._of.get("", ())) >= limits.connections:
            others = [host for host in self._of if host]
            fits = self._make_room(sorted(others, key=lambda host: -len(self._of[host])))
        if not fits:
            self.refused["connection"] += 1
            return False
        self._of.setdefault(key, {})[visitor] = None
        return True

    def become_socket(self, visitor: Visitor) -> bool:
        """Count this connection as a WebSocket; False if the limit is reached."""
        key, limits = host_of(visitor.host), self.limits
        most = limits.sockets_per_host if key else limits.sockets_for_this_computer
        others = self.sockets - len(self._sockets.get("", ()))
        if len(self._sockets.get(key, ())) >= most or (key and others >= limits.sockets):
            self.refused["socket"] += 1
            return False
        self._sockets.setdefault(key, set()).add(visitor)
        return True

    def leave(self, visitor: Visitor) -> None:
        """Remove a connection. Idempotent."""
        key = host_of(visitor.host)
        if (those := self._of.get(key)) is not None:
            those.pop(visitor, None)
            if not those:
                del self._of[key]
        if (streams := self._sockets.get(key)) is not None:
            streams.discard(visitor)
            if not streams:
                del self._sockets[key]

    def _make_room(self, hosts: Iterable[str]) -> bool:
        """Close the longest idle connection of the first of these hosts that has an idle one."""
        for host in hosts:
            idle = [(one.idle_since_s, index, one) for index, one in enumerate(self._of[host]) if one.idle_since_s]
            if idle:
                goes = min(idle)[2]
                self.leave(goes)
                goes.make_room()
                return True
        return False


@lru_cache(maxsize=4096)
def host_of(host: str) -> str:
    """What counts as one host: the same text for all of its addresses, "" for this computer."""
    return "" if is_this_computer(host) else group_of(host)


@lru_cache(maxsize=4096)
def is_this_computer(host: str) -> bool:
    """Whether this host is this computer itself."""
    try:
        return ipaddress.ip_address(host.partition("%")[0]).is_loopback
    except ValueError:
        return host == ""
