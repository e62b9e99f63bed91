"""Requests to the internet only: a map's URL, chosen by a user, must not reach servers in the local network.

A name is resolved here, all its addresses are checked, and the connection goes to a checked address, so that a later
change of the DNS answer has no effect. Redirects are not followed. A tile server in the local network is reached only
if the person who starts the station names it (GCS_LOCAL_MAPS).
"""

from __future__ import annotations

import asyncio
import ipaddress
import socket
import urllib.request
from collections.abc import Collection
from typing import Final

import httpx

_PORTS: Final = {"http": 80, "https": 443}
# NAT64 and the like: the last four bytes of these addresses are an IPv4 address.
_TRANSLATED: Final = tuple(ipaddress.IPv6Network(net) for net in ("64:ff9b::/96", "64:ff9b:1::/48", "::/96"))


class LocalAddressError(OSError):
    """The address is in this computer or its network."""


def is_outside(number: str) -> bool:
    """Whether this IP address is a public one on the internet."""
    address = ipaddress.ip_address(number.partition("%")[0])
    if isinstance(address, ipaddress.IPv6Address):
        if address.is_site_local or address.is_multicast or not address.is_global:
            inner = address.ipv4_mapped
            return inner is not None and is_outside(str(inner))
        if any(address in net for net in _TRANSLATED):
            return is_outside(str(ipaddress.IPv4Address(address.packed[-4:])))
        inside = address.sixtofour or (address.teredo[1] if address.teredo else None)
        return inside is None or is_outside(str(inside))
    return address.is_global and not address.is_multicast


def is_local_as_written(host: str) -> bool:
    """Whether the host is local without a DNS lookup: a local IP address in any notation, or a local name."""
    name = host.lower().rstrip(".")
    if name == "localhost" or name.endswith((".localhost", ".local", ".internal")):
        return True
    try:
        found = socket.getaddrinfo(name, None, flags=socket.AI_NUMERICHOST)
    except (OSError, UnicodeError):
        return False
    return not all(is_outside(str(one[4][0])) for one in found)


class Consent:
    """Servers in the local network that may be requested: `host` for all its ports, or `host:port`."""

    def __init__(self, servers: Collection[str] = ()) -> None:
        self._servers = frozenset(server.lower() for server in servers)

    @property
    def servers(self) -> list[str]:
        """Their names, as they were given."""
        return sorted(self._servers)

    def covers(self, scheme: str, host: str, port: int | None) -> bool:
        """Whether this server may be requested wherever it is."""
        name = f"[{host}]" if ":" in host else host
        port = port or _PORTS.get(scheme, 0)
        return not self._servers.isdisjoint((host.lower(), name.lower(), f"{name}:{port}".lower()))


class OutsideTransport(httpx.AsyncBaseTransport):
    """Sends requests only to checked addresses. Raises LocalAddressError."""

    def __init__(self, consent: Consent) -> None:
        self._consent = consent
        self._direct = httpx.AsyncHTTPTransport()
        self._proxied: dict[str, httpx.AsyncHTTPTransport] = {}
        self._proxies = urllib.request.getproxies()

    async def handle_async_request(self, request: httpx.Request) -> httpx.Response:
        """Check the address, then send the request."""
        url = request.url
        consented = self._consent.covers(url.scheme, url.host, url.port)
        proxy = self._proxies.get(url.scheme)
        if proxy is not None and not urllib.request.proxy_bypass(url.host):
            # The proxy resolves names for us; still refuse what is local by its spelling.
            if not consented and is_local_as_written(url.host):
                raise LocalAddressError(url.host)
            return await self._through(proxy).handle_async_request(request)
        if consented:
            return await self._direct.handle_async_request(request)
        number = await _checked(url.host, url.port or _PORTS[url.scheme])
        request.url = url.copy_with(host=number)
        # TLS must check the certificate of the name, not of the IP address. The Host header already has the name.
        request.extensions = {**request.extensions, "sni_hostname": url.host}
        return await self._direct.handle_async_request(request)

    async def aclose(self) -> None:
        """Close all connections."""
        for transport in (self._direct, *self._proxied.values()):
            await transport.aclose()

    def _through(self, proxy: str) -> httpx.AsyncHTTPTransport:
        if proxy not in self._proxied:
            self._proxied[proxy] = httpx.AsyncHTTPTransport(proxy=proxy if "://" in proxy else f"http://{proxy}")
        return self._proxied[proxy]


async def _checked(host: str, port: int) -> str:
    """An IP address of this host. Raises LocalAddressError if any of its addresses is local, OSError if unknown."""
    try:
        found = await asyncio.get_running_loop().getaddrinfo(host, port, type=socket.SOCK_STREAM)
    except (UnicodeError, socket.gaierror) as error:
        raise OSError(f"{host} is unknown") from error
    numbers = [str(one[4][0]) for one in found]
    if not numbers or not all(map(is_outside, numbers)):
        raise LocalAddressError(host)
    # Prefer IPv4: stations seldom have an IPv6 route to the internet.
    return next((number for number in numbers if ":" not in number), numbers[0])
