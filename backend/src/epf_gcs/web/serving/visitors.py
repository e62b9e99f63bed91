"""The open connections, and their times and sizes. Places are shared as the table of shares says.

A connection that has shown no key makes room for a new one at any stage, one that has shown a key only between its
requests: nobody can lock others out by holding connections open. A network of IPv6 addresses is one host.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from time import monotonic
from typing import Protocol

from epf_gcs.shares.holder import Holder, Standing
from epf_gcs.shares.known_hosts import KnownHosts
from epf_gcs.shares.places import Holdings
from epf_gcs.shares.rates import Meter
from epf_gcs.shares.table import SHARES, Shares


@dataclass(frozen=True)
class Limits:
    """Limits on the times, sizes and rates of a connection."""

    handshake_s: float = 10.0
    """From the connection to the end of the TLS handshake."""
    head_s: float = 10.0
    head_bytes: int = 65536
    idle_s: int = 15
    least_bytes_per_s: float = 2000.0
    rate_looked_at_s: float = 10.0
    strangers_body_s: float = 2.0
    """From the end of the head to the end of the body of a request that shows no key."""
    unread_s: float = 30.0
    """A connection whose client reads nothing of its answer for this long is closed."""


class Visitor(Protocol):
    """One connection."""

    host: str
    idle_since_s: float | None
    """Loop time since when it waits for a request or the rest of a head; None while it handles one."""
    since_s: float
    """Loop time since when it is at this stage."""
    has_shown_key: bool

    def make_room(self) -> None:
        """Close at once: another connection needs the place."""


def _order(visitor: Visitor) -> tuple[bool, bool, float] | None:
    """Strangers make room first, and among them those that wait, the longest first."""
    is_busy = visitor.idle_since_s is None
    if is_busy and visitor.has_shown_key:
        return None
    return visitor.has_shown_key, is_busy, visitor.since_s


class Visitors:
    """All connections of this server. Owned by the event loop. `now_s`: a steady clock."""

    def __init__(
        self, limits: Limits | None = None, shares: Shares = SHARES, now_s: Callable[[], float] = monotonic
    ) -> None:
        self.limits = limits or Limits()
        self.refused: Counter[str] = Counter()
        self.hosts = KnownHosts()
        self._now_s = now_s
        self.share(shares)

    def share(self, shares: Shares) -> None:
        """Share the places so. Only before anybody comes."""
        self.shares = shares
        self._connections: Holdings[Visitor] = Holdings(shares.connections, _order, lambda one: one.make_room())
        self._sockets: Holdings[Visitor] = Holdings(shares.sockets)
        self._handshakes = Meter(shares.handshakes)

    def __iter__(self) -> Iterator[Visitor]:
        return iter(self._connections)

    def __len__(self) -> int:
        return len(self._connections)

    @property
    def sockets(self) -> int:
        """Number of WebSockets."""
        return len(self._sockets)

    def come_in(self, visitor: Visitor) -> bool:
        """Add a connection; False if there is no place and nobody makes room."""
        return self._take(self._connections, visitor, "connection")

    def become_socket(self, visitor: Visitor) -> bool:
        """Count this connection as a WebSocket; False if there is no place."""
        return self._take(self._sockets, visitor, "socket")

    def begin_handshake(self, host: str) -> bool:
        """Whether this host may begin a TLS handshake. This computer has no limit: who runs programs on it has cheaper
        ways to keep it busy."""
        if self._handshakes.take(self.holder(host), self._now_s()):
            return True
        self.refused["handshake"] += 1
        return False

    def leave(self, visitor: Visitor) -> None:
        """Remove a connection. Idempotent."""
        self._connections.leave(visitor)
        self._sockets.leave(visitor)

    def know(self, host: str, standing: Standing) -> None:
        """Somebody of this standing has shown a key from this host."""
        self.hosts.note(host, standing, self._now_s())

    def holder(self, host: str) -> Holder:
        """This host as a holder of shares."""
        return self.hosts.holder(host, self._now_s())

    def _take(self, places: Holdings[Visitor], visitor: Visitor, what: str) -> bool:
        if places.take(visitor, self.holder(visitor.host)) is None:
            return True
        self.refused[what] += 1
        return False
