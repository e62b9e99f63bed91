"""Who is connected, and whether one more may come in: shares of connections by host and in total.

A connection between requests gives way to a newcomer, the longest idle one of the host that has most, so that holding
connections open locks nobody out. This computer's own share is kept apart from everybody else's.
"""

from __future__ import annotations

import contextlib
import ipaddress
from collections import Counter
from collections.abc import Callable, Iterator
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
    """Since when it waits for a request; None while it is at one."""

    def make_room(self) -> None:
        """End at once: another needs the place."""


class Visitors:
    """All connections of this server. Owned by the event loop."""

    def __init__(self, limits: Limits) -> None:
        self.limits = limits
        self.refused: Counter[str] = Counter()
        self._all: dict[Visitor, None] = {}
        self._sockets: dict[Visitor, None] = {}

    def __iter__(self) -> Iterator[Visitor]:
        return iter(tuple(self._all))

    def __len__(self) -> int:
        return len(self._all)

    @property
    def sockets(self) -> int:
        """How many of them are WebSockets."""
        return len(self._sockets)

    def come_in(self, visitor: Visitor) -> bool:
        """Take one more; False where there is no place for it and none can be made."""
        own = is_this_computer(visitor.host)
        limits = self.limits
        if own:
            fits = self._place(self._of(is_this_computer), limits.for_this_computer)
        else:
            fits = self._place(self._of(lambda host: host == visitor.host), limits.connections_per_host)
            fits = fits and self._place(self._of(lambda host: not is_this_computer(host)), limits.connections)
        if not fits:
            self.refused["connection"] += 1
            return False
        self._all[visitor] = None
        return True

    def become_socket(self, visitor: Visitor) -> bool:
        """It wants to be a WebSocket; False where there are enough."""
        own = is_this_computer(visitor.host)
        limits = self.limits
        of_host = sum((is_this_computer(one.host) if own else one.host == visitor.host) for one in self._sockets)
        others = sum(not is_this_computer(one.host) for one in self._sockets)
        most = limits.sockets_for_this_computer if own else limits.sockets_per_host
        if of_host >= most or (not own and others >= limits.sockets):
            self.refused["socket"] += 1
            return False
        self._sockets[visitor] = None
        return True

    def leave(self, visitor: Visitor) -> None:
        """Its connection is over. May be said twice."""
        self._all.pop(visitor, None)
        self._sockets.pop(visitor, None)

    def _of(self, counts: Callable[[str], bool]) -> list[Visitor]:
        return [one for one in self._all if counts(one.host)]

    def _place(self, those: list[Visitor], most: int) -> bool:
        """There is a place among those, if need be by ending one that is idle."""
        if len(those) < most:
            return True
        idle = [one for one in those if one.idle_since_s is not None]
        if not idle:
            return False
        by_host = Counter(one.host for one in those)
        goes = min(idle, key=lambda one: (-by_host[one.host], one.idle_since_s or 0.0))
        self.leave(goes)
        goes.make_room()
        return True


@lru_cache(maxsize=4096)
def is_this_computer(host: str) -> bool:
    """The connection comes from this computer itself."""
    try:
        return ipaddress.ip_address(host.partition("%")[0]).is_loopback
    except ValueError:
        return host == ""
