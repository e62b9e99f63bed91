"""Who asks: this computer itself, a person with a session, or a program with a key."""

from __future__ import annotations

import ipaddress
import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Final, Literal, NamedTuple

from epf_gcs.access.roles import Role
from epf_gcs.access.socket_owner import UNTOLD, Connection, owner_of

CallerKind = Literal["local", "person", "program"]

ANYONE: Final = "anyone"
"""Who asks without a key where anybody may fly."""
LOCAL_SESSION: Final = "local"
"""The session of all pages and programs of this computer."""
_ROOT: Final = 0
# A proxy adds one of these: what comes through it is from somewhere else, although its connection is from here.
_PROXY_HEADERS: Final = frozenset((b"forwarded", b"via", b"x-real-ip"))
_PROXY_PREFIX: Final = b"x-forwarded-"
_CONTAINER_MARKS: Final = (Path("/run/.containerenv"), Path("/.dockerenv"))


@dataclass(frozen=True, slots=True)
class Caller:
    """A caller that is admitted. `session` is what control and streams belong to; it is no secret."""

    kind: CallerKind
    id: str
    name: str
    role: Role
    session: str

    @property
    def has_key(self) -> bool:
        """Whether a key was shown, or none is needed on this computer; False where anybody may fly."""
        return self.id != ANYONE


LOCAL: Final = Caller("local", "local", "local", Role.owner, LOCAL_SESSION)
"""Whoever sits at this computer."""


class Peer:
    """The other end of a connection. Kept as long as the connection, so that the system is asked once."""

    def __init__(self, address: tuple[str, int] | None, own_address: tuple[str, int | None] | None) -> None:
        """None: not known, which is never this computer."""
        self.host, self._port = address or ("", 0)
        self._own_address = own_address

    @cached_property
    def is_ours(self) -> bool:
        """Whether it is a process of this computer and of our own user or root, as far as the system tells."""
        if not is_loopback(self.host) or self._own_address is None:
            return False
        own_host, own_port = self._own_address
        connection = Connection(self.host, self._port, own_host, own_port or 0)
        return owner_of(connection) in (UNTOLD, _ROOT, _own_user())


def _own_user() -> int:
    return os.getuid() if hasattr(os, "getuid") else UNTOLD


class Credentials(NamedTuple):
    """What a request or a handshake shows of its caller."""

    peer: Peer
    cookies: str
    authorization: str | None
    proxied: bool

    @classmethod
    def of(cls, headers: Iterable[tuple[bytes, bytes]], peer: Peer) -> Credentials:
        """From raw headers with names in lower case."""
        cookies: list[str] = []
        keys: list[str] = []
        proxied = False
        for name, value in headers:
            if name == b"cookie":
                cookies.append(value.decode("latin-1"))
            elif name == b"authorization":
                keys.append(value.decode("latin-1"))
            elif name in _PROXY_HEADERS or name.startswith(_PROXY_PREFIX):
                proxied = True
        # A repeated Authorization is joined, which is never a valid one.
        return cls(peer, "; ".join(cookies), ",".join(keys) if keys else None, proxied)


def is_loopback(host: str) -> bool:
    """Whether this is an address of the loopback; False for a name or for nothing."""
    try:
        return ipaddress.ip_address(host.partition("%")[0]).is_loopback
    except ValueError:
        return False


def is_in_container(marks: Iterable[Path] = _CONTAINER_MARKS, variables: Mapping[str, str] = os.environ) -> bool:
    """Whether this process runs in a container: a port of it that is published can make strangers come from the
    loopback."""
    return "container" in variables or any(mark.exists() for mark in marks)
