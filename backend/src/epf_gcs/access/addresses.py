"""Where browsers of other machines reach this station, and the address that a QR code shows."""

from __future__ import annotations

import io
import ipaddress
import re
import socket
import sys
from functools import lru_cache
from pathlib import Path
from typing import Final
from urllib.parse import urlencode, urlsplit

import segno

from epf_gcs.tls.identity import addresses_by_interface

_ANY: Final = frozenset(("0.0.0.0", "::"))  # noqa: S104 - compared, not listened on

# Containers, virtual machines and private networks: who stands beside the aircraft does not reach the station there.
_VIRTUAL: Final = re.compile(
    r"docker|podman|br-|veth|virbr|vmnet|vboxnet|vethernet|lxc|lxd|cni|flannel|cali|tun|tap|utun|wg|ppp|tailscale|zt|nebula",
    re.IGNORECASE,
)
# Of the program that announces names on Linux; the other systems announce theirs themselves.
_AVAHI: Final = Path("/run/avahi-daemon/socket")
# Addresses of documentation (RFC 5737, 3849): everybody's default route leads to them, and nobody is there.
_DOCUMENTATION: Final = {4: (socket.AF_INET, "192.0.2.1"), 6: (socket.AF_INET6, "2001:db8::1")}


def addresses(host: str, port: int, *, secure: bool, reached_at: str | None = None) -> list[str]:
    """Base URLs, those that most likely work first; `host` is what the station listens on, `reached_at` what its user
    said.

    Empty where it listens on the loopback alone.
    """
    if host in _ANY:
        hosts = [*_own_addresses(6 if host == "::" else 4), *(own_names()[-1:] if is_name_announced() else [])]
    else:
        hosts = own_names()[-1:] if _is_link_local(host) else [host]
    scheme = "https" if secure else "http"
    reached = [_in_url(one) for one in hosts if not _is_loopback(one)]
    own = [f"{scheme}://{one}:{port}" for one in reached]
    return list(dict.fromkeys([*([] if reached_at is None else [reached_at]), *own]))


def is_of_this_computer_alone(address: str) -> bool:
    """Whether this base URL names the computer it is opened on: others would look for the station in themselves."""
    host = (urlsplit(address).hostname or "").rstrip(".")
    return host == "localhost" or host.endswith(".localhost") or _is_loopback(host)


def with_key(address: str, key: str, tab: str | None) -> str:
    """The address that enters with this key. It stands behind the number sign, which no browser sends or logs."""
    return f"{address}/#{urlencode({'key': key} if tab is None else {'key': key, 'tab': tab})}"


def qr_svg(text: str) -> str:
    """A picture of this text, dark on light whatever surrounds it, as SVG without width and height."""
    out = io.BytesIO()
    segno.make(text, error="m", micro=False).save(
        out, kind="svg", border=4, xmldecl=False, omitsize=True, dark="#000", light="#fff"
    )
    return out.getvalue().decode()


# Not for addresses with a key, which is kept nowhere.
qr_svg_of_plain: Final = lru_cache(maxsize=64)(qr_svg)


def own_names() -> list[str]:
    """Names by which others of the network may know this machine; the last is the one that needs no name server."""
    name = socket.gethostname().lower()
    short = name.partition(".")[0]
    return [name, short, f"{short}.local"] if short else []


def is_name_announced() -> bool:
    """Whether something on this machine answers others that ask for its name ending in .local (mDNS)."""
    return sys.platform != "linux" or _AVAHI.exists()


def _own_addresses(version: int) -> list[str]:
    """The address by which this machine reaches other networks comes first, because its phones and laptops are there;
    those of virtual interfaces come last.

    Whoever listens on all addresses of one version is not reached by the other. A link-local address needs its zone
    in the URL, which browsers refuse.
    """
    parsed = [(name, ipaddress.ip_address(number.partition("%")[0])) for name, number in addresses_by_interface()]
    reachable = [
        (name, number)
        for name, number in parsed
        if number.version == version and not number.is_loopback and not number.is_link_local
    ]
    outward = _outward_address(version)
    ranked = sorted(reachable, key=lambda one: (_VIRTUAL.match(one[0]) is not None, str(one[1]) != outward))
    return [str(number) for _, number in ranked]


def _outward_address(version: int) -> str | None:
    """The own address on the way of the default route; None without one. Nothing is sent: a datagram socket that is
    connected only looks the way up."""
    family, anywhere = _DOCUMENTATION[version]
    with socket.socket(family, socket.SOCK_DGRAM) as looking:
        try:
            looking.connect((anywhere, 9))
        except OSError:
            return None
        return str(looking.getsockname()[0])


def _is_link_local(host: str) -> bool:
    """Whether browsers reach it by the machine's name alone, for no browser takes a zone in a URL."""
    try:
        number = ipaddress.ip_address(host.partition("%")[0])
    except ValueError:
        return False
    return number.version == 6 and number.is_link_local


def _is_loopback(host: str) -> bool:
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"


def _in_url(host: str) -> str:
    return f"[{host}]" if ":" in host else host
