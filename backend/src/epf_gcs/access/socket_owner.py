"""Whose process is at the other end of a connection of the loopback. Linux alone says it.

The kernel is asked for this one socket (sock_diag, 0.05 ms). Where that is not permitted, its table of all sockets is
read, which takes some milliseconds.
"""

from __future__ import annotations

import contextlib
import ipaddress
import socket
import sys
from pathlib import Path
from struct import Struct
from typing import Final, NamedTuple

UNTOLD: Final = -1
"""This system never tells: macOS and Windows."""
NOBODY: Final = -2
"""Nobody known: no process holds that end any more (the system calls such a socket root's, which must not open the door
to whoever has just closed it), or Linux could not be asked, as where no file descriptor is left."""

_ESTABLISHED: Final = 1
_TABLES: Final = Path("/proc/net")
# linux/netlink.h, linux/inet_diag.h: header, request (family, protocol, extensions, states, ports, addresses,
# interface, any cookie) and what the answer begins with.
# Only Linux has this family of sockets.
_NETLINK: Final = getattr(socket, "AF_NETLINK", 0)
_SOCK_DIAG: Final = 4
_BY_FAMILY: Final = 20
_REQUEST: Final = 1
_HEADER: Final = Struct("=IHHII")
_ASKED: Final = Struct("=BBBxI2s2s16s16sIII")
_TOLD: Final = Struct("=BBBB2s2s16s16sIIIIIII")
_ANY: Final = 0xFFFFFFFF
_PATIENCE_S: Final = 0.2


class Connection(NamedTuple):
    """Addresses as numbers in text."""

    host: str
    port: int
    own_host: str
    own_port: int


def owner_of(connection: Connection) -> int:
    """User id of the process at the other end, UNTOLD or NOBODY."""
    if sys.platform != "linux":
        return UNTOLD
    told = _asked(connection)
    return _in_table(connection) if told is None else told


def _asked(connection: Connection) -> int | None:
    """By sock_diag; None if it does not answer this."""
    host, own_host = (_packed(one) for one in (connection.host, connection.own_host))
    family = socket.AF_INET if len(host) == 4 else socket.AF_INET6
    if len(own_host) != len(host):
        return None
    request = _ASKED.pack(
        family,
        socket.IPPROTO_TCP,
        0,
        _ANY,
        connection.port.to_bytes(2, "big"),
        connection.own_port.to_bytes(2, "big"),
        host.ljust(16, b"\0"),
        own_host.ljust(16, b"\0"),
        0,
        _ANY,
        _ANY,
    )
    with contextlib.suppress(OSError), socket.socket(_NETLINK, socket.SOCK_DGRAM, _SOCK_DIAG) as kernel:
        kernel.settimeout(_PATIENCE_S)
        kernel.send(_HEADER.pack(_HEADER.size + len(request), _BY_FAMILY, _REQUEST, 1, 0) + request)
        answer = kernel.recv(4096)
        kind = _HEADER.unpack_from(answer)[1]
        if kind == _BY_FAMILY and len(answer) >= _HEADER.size + _TOLD.size:
            told = _TOLD.unpack_from(answer, _HEADER.size)
            return int(told[14]) if told[1] == _ESTABLISHED else NOBODY
    return None


def _in_table(connection: Connection, tables: Path = _TABLES) -> int:
    """By the table of all sockets."""
    host = _packed(connection.host)
    wanted, own = _as_in_table(host, connection.port), b":%04X" % connection.own_port
    try:
        rows = (tables / ("tcp" if len(host) == 4 else "tcp6")).read_bytes().splitlines()[1:]
    except OSError:
        return NOBODY
    for row in rows:
        fields = row.split()
        if fields[1] == wanted and fields[2].endswith(own) and int(fields[3], 16) == _ESTABLISHED:
            return int(fields[7])
    return NOBODY


def _packed(host: str) -> bytes:
    """Raises ValueError for what is no address."""
    return ipaddress.ip_address(host.partition("%")[0]).packed


def _as_in_table(packed: bytes, port: int) -> bytes:
    """Addresses stand in the table as 32-bit words in the machine's byte order."""
    words = [packed[start : start + 4] for start in range(0, len(packed), 4)]
    if sys.byteorder == "little":
        words = [word[::-1] for word in words]
    return b"%b:%04X" % (b"".join(words).hex().upper().encode(), port)
