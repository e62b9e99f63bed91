"""Who is connected, and whether one more may come in: shares of connections by host and in total.

A connection between requests gives way to a newcomer, the longest idle one of the host that has most, so that holding
connections open locks nobody out. This computer's own share is kept apart from everybody else's.
"""

from __future__ import annotations

import contextlib
import ipaddress
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Final, Protocol

RESERVED_DESCRIPTORS: Final = 200
"""For files, links, recordings and worker processes."""

_LEAST: Final = 50


@dataclass(frozen=True)
class Limits:
    """How many of each, and for how long one may take. Connections include WebSockets."""

    connections: int = 1000
    connections_per_host: int = 200
    for_this_computer: int = 300
    sockets: int = 400
    sockets_per_host: int = 40
    sockets_for_this_computer: int = 250
    head_s: float = 10.0
    head_bytes: int = 65536
    idle_s: int = 15
    least_bytes_per_s: float = 2000.0
    rate_looked_at_s: float = 10.0
    unread_s: float = 30.0
    """A browser that takes nothing of its answer for this long is gone."""


def fitting(limits: Limits, descriptors: int) -> Limits:
    """The same with no more connections than this many descriptors are good for."""
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


def raise_descriptors() -> int:
    """Have as many descriptors as the system lets us; how many that are."""
    with contextlib.suppress(ImportError, ValueError, OSError):
        import resource  # noqa: PLC0415 - not on every system

        soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
        with contextlib.suppress(ValueError, OSError):
            resource.setrlimit(resource.RLIMIT_NOFILE, (hard, hard))
            soft = hard
        return 1 << 20 if soft == resource.RLIM_INFINITY else soft
    return 1024


class Visitor(Protocol):
    """One connection."""

    host: str
    idle_since_s: float | None
    """Since when it waits for a request, or for the rest of a head; None while it is at one."""

    def make_room(self) -> None:
        """End at once: another needs the place."""


class Visitors:
    """All connections of this server. Owned by the event loop."""

    def __init__(self, limits: Limits) -> None:
        self.limits = limits
        self.refused: Counter[str] = Counter()
        # By host; this computer's own are under "".
        self._of: dict[str, dict[Visitor, None]] = {}
        self._sockets: dict[str, set[Visitor]] = {}

    def __iter__(self) -> Iterator[Visitor]:
        return iter([one for those in self._of.values() for one in those])

    def __len__(self) -> int:
        return sum(map(len, self._of.values()))

    @property
    def sockets(self) -> int:
        """How many of them are WebSockets."""
        return sum(map(len, self._sockets.values()))

    def come_in(self, visitor: Visitor) -> bool:
        """Take one more; False where there is no place for it and none can be made."""
        key, limits = _key(visitor.host), self.limits
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
        """It wants to be a WebSocket; False where there are enough."""
        key, limits = _key(visitor.host), self.limits
        most = limits.sockets_per_host if key else limits.sockets_for_this_computer
        others = self.sockets - len(self._sockets.get("", ()))
        if len(self._sockets.get(key, ())) >= most or (key and others >= limits.sockets):
            self.refused["socket"] += 1
            return False
        self._sockets.setdefault(key, set()).add(visitor)
        return True

    def leave(self, visitor: Visitor) -> None:
        """Its connection is over. May be said twice."""
        key = _key(visitor.host)
        if (those := self._of.get(key)) is not None:
            those.pop(visitor, None)
            if not those:
                del self._of[key]
        if (streams := self._sockets.get(key)) is not None:
            streams.discard(visitor)
            if not streams:
                del self._sockets[key]

    def _make_room(self, hosts: Iterable[str]) -> bool:
        """End the connection that has been idle longest of the first of these hosts that has any."""
        for host in hosts:
            idle = [(one.idle_since_s, index, one) for index, one in enumerate(self._of[host]) if one.idle_since_s]
            if idle:
                goes = min(idle)[2]
                self.leave(goes)
                goes.make_room()
                return True
        return False


def _key(host: str) -> str:
    return "" if is_this_computer(host) else host


@lru_cache(maxsize=4096)
def is_this_computer(host: str) -> bool:
    """The connection comes from this computer itself."""
    try:
        return ipaddress.ip_address(host.partition("%")[0]).is_loopback
    except ValueError:
        return host == ""
