"""Who asks: this computer itself, a person with a session, or a program with a key."""

from __future__ import annotations

import ipaddress
import os
import sys
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Final, Literal, NamedTuple

from epf_gcs.web.access.roles import Role

CallerKind = Literal["local", "person", "program"]

LOCAL_SESSION: Final = "local"
"""The session of all pages and programs of this computer."""
_ROOT: Final = 0
_ESTABLISHED: Final = b"01"
UNTOLD: Final = -1
NOBODY: Final = -2
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


LOCAL: Final = Caller("local", "local", "local", Role.owner, LOCAL_SESSION)
"""Whoever sits at this computer."""


class Peer:
    """The other end of a connection. Kept as long as the connection, so that the system is asked once."""

    def __init__(self, host: str, port: int, own_port: int) -> None:
        """`own_port`: our end of the connection."""
        self.host = host
        self._port = port
        self._own_port = own_port

    @cached_property
    def is_ours(self) -> bool:
        """Whether it is a process of this computer and of our own user or root, as far as the system tells."""
        if not is_loopback(self.host):
            return False
        if sys.platform != "linux":
            return True
        return socket_owner(self.host, self._port, self._own_port) in (UNTOLD, _ROOT, os.getuid())


class Shown(NamedTuple):
    """What a request or a handshake shows of its caller."""

    peer: Peer
    cookies: str
    authorization: str | None
    proxied: bool

    @classmethod
    def of(cls, headers: Iterable[tuple[bytes, bytes]], peer: Peer) -> Shown:
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


def socket_owner(host: str, port: int, own_port: int, tables: Path = Path("/proc/net")) -> int:
    """User id of the process at the other end of a connection of the loopback.

    UNTOLD: this system does not tell of connections. NOBODY: it does, and no process holds that end any more; the
    system calls such a socket root's, which must not open the door to whoever has just closed it.
    """
    address = ipaddress.ip_address(host.partition("%")[0])
    wanted, own = _as_in_table(address.packed, port), b":%04X" % own_port
    try:
        rows = (tables / ("tcp" if address.version == 4 else "tcp6")).read_bytes().splitlines()[1:]
    except OSError:
        return UNTOLD
    is_told = False
    for row in rows:
        fields = row.split()
        is_told = is_told or fields[1].endswith(own)
        if fields[1] == wanted and fields[2].endswith(own) and fields[3] == _ESTABLISHED:
            return int(fields[7])
    return NOBODY if is_told else UNTOLD


def _as_in_table(packed: bytes, port: int) -> bytes:
    """Addresses stand in the table as 32-bit words in the machine's byte order."""
    words = [packed[start : start + 4] for start in range(0, len(packed), 4)]
    if sys.byteorder == "little":
        words = [word[::-1] for word in words]
    return b"%b:%04X" % (b"".join(words).hex().upper().encode(), port)
