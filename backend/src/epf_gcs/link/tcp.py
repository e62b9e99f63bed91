"""A board behind a TCP port: an adapter on the network, an emulator, the board's firmware on a PC."""

from __future__ import annotations

import asyncio
import errno
import socket
from typing import Final

from epf_gcs.errors import LinkError
from epf_gcs.link.address import LinkAddress
from epf_gcs.link.base import Device
from epf_gcs.link.failures import link_error

_CONNECT_TIMEOUT_S: Final = 3.0
# A peer that vanished without a word is noticed after this long with unanswered data.
_DEAD_PEER_MS: Final = 5000


async def open_tcp(address: LinkAddress) -> Device:
    """Connect, without Nagle's delay. Raises LinkError."""
    name = f"{address.target}:{address.port}"
    loop = asyncio.get_running_loop()
    try:
        found = await loop.getaddrinfo(address.target, address.port, type=socket.SOCK_STREAM)
    except socket.gaierror as error:
        raise LinkError(
            "link_unknown_host",
            f"The host '{address.target}' is not known: correct its name, or write its number.",
            target=name,
        ) from error
    family, kind, protocol, _, where = found[0]
    connection = socket.socket(family, kind, protocol)
    try:
        connection.setblocking(False)
        async with asyncio.timeout(_CONNECT_TIMEOUT_S):
            await loop.sock_connect(connection, where)
        _tune(connection)
    except TimeoutError as error:
        connection.close()
        raise link_error(name, OSError(errno.ETIMEDOUT, "timed out")) from error
    except OSError as error:
        connection.close()
        raise link_error(name, error) from error
    except BaseException:
        connection.close()
        raise
    return Device(name, connection.fileno(), address.baud, connection.close, lambda: 0)


def _tune(connection: socket.socket) -> None:
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    connection.setsockopt(socket.SOL_SOCKET, socket.SO_KEEPALIVE, 1)
    if hasattr(socket, "TCP_USER_TIMEOUT"):
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_USER_TIMEOUT, _DEAD_PEER_MS)
