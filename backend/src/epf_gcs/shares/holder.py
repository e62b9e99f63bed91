"""Who holds a share: a caller by its session, or a host by its address."""

from __future__ import annotations

import ipaddress
from enum import IntEnum
from functools import lru_cache
from typing import Final, NamedTuple

_IPV6_NETWORK_BITS: Final = 64
THIS_COMPUTER: Final = ""
"""The key of all pages and programs of this computer."""


class Standing(IntEnum):
    """Who goes first: the later in this list, the sooner. A host has the standing of the best key shown from there."""

    stranger = 0
    viewer = 1
    operator = 2
    owner = 3
    own = 4
    """This computer, and the station itself."""


class Holder(NamedTuple):
    """`key` tells holders of the same row apart."""

    key: str
    standing: Standing


STATION: Final = Holder("station", Standing.own)
"""What the station does by itself."""


@lru_cache(maxsize=4096)
def host_of(address: str) -> str:
    """What counts as one host: the same text for all of its addresses, THIS_COMPUTER for the loopback."""
    return THIS_COMPUTER if is_this_computer(address) else group_of(address)


@lru_cache(maxsize=4096)
def is_this_computer(address: str) -> bool:
    """Whether this address is this computer itself."""
    try:
        return ipaddress.ip_address(address.partition("%")[0]).is_loopback
    except ValueError:
        return address == ""


def group_of(address: str) -> str:
    """All addresses of one host: an IPv6 host has a whole network of them."""
    try:
        number = ipaddress.ip_address(address.partition("%")[0])
    except ValueError:
        return address
    if number.version == 4:
        return address
    if number.ipv4_mapped is not None:
        return str(number.ipv4_mapped)
    return str(ipaddress.ip_network((number, _IPV6_NETWORK_BITS), strict=False))
