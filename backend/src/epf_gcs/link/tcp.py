"""A board behind a TCP port: an adapter on the network, an emulator, the board's firmware on a PC."""

from __future__ import annotations

import asyncio
import errno
import socket
from collections.abc import Awaitable, Callable, Iterable
from itertools import zip_longest
from typing import Any, Final

from epf_gcs.errors import LinkError
from epf_gcs.link.address import LinkAddress
from epf_gcs.link.base import Device
from epf_gcs.link.failures import link_error

# Shared by all addresses of a host, but each gets at least `_LEAST_TIMEOUT_S`.
_CONNECT_TIMEOUT_S: Final = 3.0
_LEAST_TIMEOUT_S: Final = 1.0
_NO_WAY: Final = (errno.EADDRNOTAVAIL, errno.EAFNOSUPPORT, errno.ENETUNREACH)
# The connection counts as lost when sent data was not acknowledged by TCP for this long.
_DEAD_PEER_MS: Final = 5000

SocketAddress = tuple[Any, ...]
Found = tuple[int, int, int, str, SocketAddress]
Resolve = Callable[[str, int], Awaitable[Iterable[Found]]]


async def _look_up(host: str, port: int) -> Iterable[Found]:
    return await asyncio.get_running_loop().getaddrinfo(host, port, type=socket.SOCK_STREAM)


async def open_tcp(address: LinkAddress, look_up: Resolve = _look_up) -> Device:
    """Connect to the first of the host's addresses that answers, without Nagle's delay. Raises LinkError."""
    try:
        found = _in_turn(list(await look_up(address.target, address.port)))
    except (socket.gaierror, UnicodeError) as error:
        raise LinkError(
            "link_unknown_host",
            f"The host '{address.target}' is not known: correct its name, or write its number.",
            target=address.name,
        ) from error
    failures: list[OSError] = []
    for family, where in found:
        try:
            connection = await _connect(family, where, max(_LEAST_TIMEOUT_S, _CONNECT_TIMEOUT_S / len(found)))
        except OSError as error:
            failures.append(error)
        else:
            return Device(
                address.name,
                connection.fileno(),
                address.baud,
                connection.close,
                lambda: 0,
                connection.recv,
                connection.send,
            )
    # That this machine has no route to an address says nothing about the host: prefer another address's error.
    telling = [error for error in failures if error.errno not in _NO_WAY]
    cause = (telling or failures or [OSError(errno.EADDRNOTAVAIL, "no address")])[0]
    raise link_error(address.name, cause) from cause


async def _connect(family: int, where: SocketAddress, timeout_s: float) -> socket.socket:
    connection = socket.socket(family, socket.SOCK_STREAM)
    try:
        connection.setblocking(False)
        async with asyncio.timeout(timeout_s):
            await asyncio.get_running_loop().sock_connect(connection, where)
        _tune(connection)
    except TimeoutError as error:
        connection.close()
        raise OSError(errno.ETIMEDOUT, "timed out") from error
    except BaseException:
        connection.close()
        raise
    return connection


def _in_turn(found: list[Found]) -> list[tuple[int, SocketAddress]]:
    """The system's order, but IPv4 and IPv6 alternate: if one of them does not work, only one timeout is lost first."""
    waiting: dict[int, list[SocketAddress]] = {}
    for family, _, _, _, where in found:
        if where not in waiting.setdefault(family, []):
            waiting[family].append(where)
    ranks = zip_longest(*([(family, where) for where in some] for family, some in waiting.items()))
    return [one for rank in ranks for one in rank if one is not None]


def _tune(connection: socket.socket) -> None:
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    connection.setsockopt(socket.SOL_SOCKET, socket.SO_KEEPALIVE, 1)
    if hasattr(socket, "TCP_USER_TIMEOUT"):
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_USER_TIMEOUT, _DEAD_PEER_MS)
