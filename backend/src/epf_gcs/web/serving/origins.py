"""Which names and pages this station answers to: Host, Origin and Fetch Metadata of a request."""

from __future__ import annotations

import ipaddress
from collections.abc import Callable, Container, Iterable, Sequence
from typing import Final
from urllib.parse import urlsplit

from epf_gcs.errors import GatewayError, InvalidInputError

# Fetch Metadata, as all browsers send it: another server's page, or one of another port of this computer.
_FOREIGN_SITES: Final = frozenset(("cross-site", "same-site"))


def _only(values: Callable[[str], Sequence[str]], name: str) -> str | None:
    found = values(name)
    if len(found) > 1:
        raise InvalidInputError(
            "invalid_request", f"The header '{name}' came {len(found)} times: send it once.", field=name
        )
    return found[0] if found else None


class Access:
    """Rules for the header Host (the server's name in the URL) and Origin (the page that makes the request).

    The Host check stops DNS rebinding: a page whose own domain resolves to this machine. The Origin check stops
    requests from pages of other servers, Sec-Fetch-Site also those that only read: their answers are kept from them
    anyway, but each costs us something. Programs other than browsers send neither and are accepted.
    """

    def __init__(self, hosts: Iterable[str], origins: Iterable[str], *, secure: bool = False) -> None:
        """`secure`: the station speaks TLS itself."""
        self._hosts = frozenset(host.lower() for host in hosts) | {"localhost"}
        self._origins = frozenset(origins)
        self._scheme = "https" if secure else "http"

    def check(self, values: Callable[[str], Sequence[str]], *, reads: bool) -> None:
        """`values` gives all values of a header; `reads`: nothing is commanded, so that any page may ask.

        Raises GatewayError if Host is not one of this server's names or the page is another server's; InvalidInputError
        if Host is no name at all, or if one of the two comes twice: others on the way may have read the other one.
        """
        host, origin = _only(values, "Host"), _only(values, "Origin")
        self._check_host(host)
        if reads:
            self._check_site(values, origin)
        else:
            # A proxy that speaks TLS in our place says so.
            self._check_origin(origin, host, {self._scheme, *values("X-Forwarded-Proto")})

    def _check_host(self, host: str | None) -> None:
        try:
            parts = urlsplit(f"//{host or ''}")
            name = parts.hostname or ""
            _ = parts.port  # a ValueError if it is no number
        except ValueError as error:
            raise InvalidInputError(
                "invalid_request", "The header 'Host' is no name of a server: correct it.", field="Host"
            ) from error
        if name not in self._hosts and not _is_number(name):
            raise GatewayError(
                "foreign_host",
                f"This station does not answer to the name '{name}': use its number, or allow the name by "
                "GCS_ALLOWED_HOSTS.",
                host=name,
            )

    def _check_site(self, values: Callable[[str], Sequence[str]], origin: str | None) -> None:
        """A page of another server may lead here, as a link does, and no more."""
        if origin in self._origins or not _FOREIGN_SITES.intersection(values("Sec-Fetch-Site")):
            return
        if "navigate" in values("Sec-Fetch-Mode") and "document" in values("Sec-Fetch-Dest"):
            return
        raise GatewayError(
            "foreign_origin",
            "The page of another server may not ask this station: open the station's own page.",
            origin=(origin or "")[:200],
        )

    def _check_origin(self, origin: str | None, host: str | None, schemes: Container[str]) -> None:
        if origin is None or origin in self._origins:
            return
        try:
            parts = urlsplit(origin)
        except ValueError:
            parts = urlsplit("")
        if parts.scheme in schemes and parts.netloc.lower() == (host or "").lower():
            return
        raise GatewayError(
            "foreign_origin",
            f"The page {origin} may not command this station: open the station's own page.",
            origin=origin[:200],
        )


def _is_number(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True
