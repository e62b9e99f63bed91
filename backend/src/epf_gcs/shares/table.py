"""The table of shares: what is scarce, how much there is of it, and how much of it one caller or one host has.

Owners go before operators, operators before viewers, hosts where somebody has shown a key before strangers, and this
computer before all: what stands in a later column of a row cannot be used up by those of an earlier one.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

from epf_gcs.shares.holder import Standing
from epf_gcs.shares.places import Part, Places

RESERVED_DESCRIPTORS: Final = 200
"""Descriptors kept for files, links, recordings and worker processes."""
_OF_A_CONNECTION: Final = 2
"""Its socket, and the file that is sent over it."""
_LEAST: Final = 50

_stranger, _viewer, _operator, _owner, _own = Standing


def by_host(*, each: int, strangers: int, others: int, own: int) -> Places:
    """A row of hosts: `strangers` and `others` count all hosts but this computer, which has `own` beside them."""
    known = Part(each, others)
    return Places(
        {
            _stranger: Part(each, strangers),
            **dict.fromkeys((_viewer, _operator, _owner), known),
            _own: Part(own, others + own),
        }
    )


@dataclass(frozen=True, slots=True)
class Shares:
    """One row for each scarce thing."""

    connections: Places
    """By host, WebSockets included. One that has shown no key makes room for a new one, whatever it is doing."""
    sockets: Places
    """WebSockets, by host: a class behind one address, with a second page each. Strangers open none."""


SHARES: Final = Shares(
    connections=by_host(each=200, strangers=800, others=1000, own=300),
    sockets=by_host(each=120, strangers=400, others=400, own=250),
)


def fitting(shares: Shares, descriptors: int) -> Shares:
    """The table with as many connections as this many file descriptors allow."""
    most = max(_LEAST, (descriptors - RESERVED_DESCRIPTORS) // _OF_A_CONNECTION)
    if shares.connections.all <= most:
        return shares
    own = most // 3
    others = most - own
    each = min(shares.connections.parts[_stranger].each, others // 2)
    return replace(shares, connections=by_host(each=each, strangers=others * 4 // 5, others=others, own=own))
