"""What a certificate has to name so that browsers find this machine in it: names and addresses."""

from __future__ import annotations

import ipaddress
import re
import unicodedata
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

import ifaddr

Address = ipaddress.IPv4Address | ipaddress.IPv6Address

_LABEL: Final = re.compile(r"[a-z0-9]([a-z0-9-]{0,61}[a-z0-9])?")
_MOST_NAME: Final = 253
_ALWAYS: Final = ("127.0.0.1", "::1")


@dataclass(frozen=True, slots=True)
class Identity:
    """Names are A-labels in lower case, as browsers send them.

    `own` are names that the machine has by itself, `chosen` those that the person who started the station named.
    """

    own: tuple[str, ...]
    chosen: tuple[str, ...]
    addresses: tuple[Address, ...]


def identity_of(machine: str, chosen: Iterable[str], addresses: Iterable[str]) -> Identity:
    """`machine` is the name that the machine gives itself, `chosen` are names or addresses.

    Only the first label of the machine's name counts: the rest may come from the network and change with it.
    What is neither a name nor an address is left out.
    """
    label = a_label(machine.partition(".")[0])
    own = ["localhost"] if label in (None, "localhost") else [f"{label}.local", str(label), "localhost"]
    names: dict[str, None] = {}
    numbers: dict[Address, None] = {}
    for text in (*_ALWAYS, *addresses, *chosen):
        number = _address(text)
        if number is not None:
            if not number.is_unspecified:
                numbers[number] = None
        elif (name := a_label(text)) is not None and name not in own:
            names[name] = None
    return Identity(tuple(own), tuple(names), tuple(numbers))


def addresses_here() -> list[str]:
    """Every address of every interface of this machine, without scopes."""
    return [number for _, number in addresses_by_interface()]


def addresses_by_interface() -> list[tuple[str, str]]:
    """The name of each interface of this machine with each of its addresses, without scopes."""
    found = [(adapter.nice_name, ip.ip) for adapter in ifaddr.get_adapters() for ip in adapter.ips]
    return [(name, one if isinstance(one, str) else one[0]) for name, one in found]


def a_label(name: str) -> str | None:
    """The name as browsers send it: lower case, other letters as A-labels (RFC 5890); None if it is no name.

    Python's own codec follows the older IDNA2003, in which `straße` became `strasse`; browsers do not any more.
    """
    labels = [_one_label(label) for label in unicodedata.normalize("NFKC", name.lower()).rstrip(".").split(".")]
    whole = ".".join(label or "" for label in labels)
    return whole if all(labels) and len(whole) <= _MOST_NAME else None


def _one_label(label: str) -> str | None:
    if label.isascii():
        return label if _LABEL.fullmatch(label) else None
    if not all(sign == "-" or unicodedata.category(sign)[0] in "LMN" for sign in label):
        return None
    coded = f"xn--{label.encode('punycode').decode('ascii')}"
    return coded if _LABEL.fullmatch(coded) else None


def _address(text: str) -> Address | None:
    try:
        return ipaddress.ip_address(text.strip("[]").partition("%")[0])
    except ValueError:
        return None
