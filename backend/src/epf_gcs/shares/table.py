"""The table of shares: what is scarce, how much there is of it, and how much of it one caller or one host has.

Owners go before operators, operators before viewers, hosts where somebody has shown a key before strangers, and this
computer before all: what stands in a later column of a row cannot be used up by those of an earlier one.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

from epf_gcs.shares.holder import Standing
from epf_gcs.shares.places import Part, Places
from epf_gcs.shares.rates import NOTHING, Flow, Newcomers, Rate

RESERVED_DESCRIPTORS: Final = 200
"""Descriptors kept for files, links, recordings and worker processes."""
_OF_A_CONNECTION: Final = 2
"""Its socket, and the file that is sent over it."""
_LEAST: Final = 50
_HOUR_S: Final = 3600.0
STATUS_PER_S: Final = 10
"""How often the status is told to all viewers, however often it changes."""
STREAM_COSTS_REQUESTS: Final = 20
"""Opening a stream counts as so many requests: its hello has everything, and all viewers hear of it."""

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
    """One row for each scarce thing; `Places` are held and given back, a `Flow` is used up and comes back with time."""

    connections: Places
    """By host, WebSockets included. One that has shown no key makes room for a new one, whatever it is doing."""
    sockets: Places
    """WebSockets, by host: a class behind one address, with a second page each. Strangers open none."""
    streams: Places
    """The same, by session."""
    handshakes: Flow
    """Of TLS, by host: each costs us a millisecond, and whoever begins it nearly nothing. A class behind one address
    opens six connections for each of its pages."""
    requests: Flow
    """By session, of strangers by host. A globe asks for hundreds of tiles at once; a class behind one address loads
    the page's sixty files twenty times before anybody has entered."""
    upload_bytes: Flow
    """By session."""
    uploads: Places
    """Files that are being received, by session."""
    jobs_waiting: Places
    """Work on recordings that waits for its turn, by session. The station's own work is not counted."""
    results: Places
    """What a person waits for and is made at once, by session: exports and reports."""
    preparing: Places
    """What is prepared at once: recordings that came, are packed and indexed. Each takes a core and the disk."""
    replays: Places
    """Streams of the past, by session. Those of one recording share a process."""
    asks: Flow
    """Asking to be let in, by host."""
    waiting: Places
    """People who wait to be let in, by host. Who has waited longest of the host with most makes room."""
    marks: Places
    """Marks in one flight, by who set them."""


def _bytes_per_h(size: float) -> Rate:
    return Rate(size / _HOUR_S, size)


SHARES: Final = Shares(
    connections=by_host(each=200, strangers=800, others=1000, own=300),
    sockets=by_host(each=120, strangers=400, others=400, own=250),
    streams=Places({_viewer: Part(8, 320), _operator: Part(16, 360), _owner: Part(16, 400), _own: Part(650, 650)}),
    handshakes=Flow(
        each=dict.fromkeys((_stranger, _viewer, _operator, _owner), Rate(10, 300)),
        together={_stranger: Rate(25, 500), _viewer: Rate(25, 500), _operator: Rate(25, 500), _owner: Rate(25, 500)},
        newcomers=Newcomers(each=Rate(0.2, 12), together=Rate(25, 500)),
    ),
    requests=Flow(
        each={
            _stranger: Rate(20, 2000),
            _viewer: Rate(50, 3000),
            _operator: Rate(100, 6000),
            _owner: Rate(200, 12000),
        },
        together={},
    ),
    upload_bytes=Flow(
        each={_stranger: NOTHING, _viewer: NOTHING, _operator: _bytes_per_h(4e9), _owner: _bytes_per_h(16e9)},
        together={_operator: _bytes_per_h(16e9), _owner: _bytes_per_h(16e9)},
    ),
    uploads=Places({_operator: Part(3, 4), _owner: Part(3, 5), _own: Part(3, 8)}),
    jobs_waiting=Places({_viewer: Part(4, 12), _operator: Part(8, 16), _owner: Part(12, 20), _own: Part(20, 24)}),
    results=Places({_viewer: Part(1, 2), _operator: Part(2, 2), _owner: Part(2, 3), _own: Part(2, 3)}),
    preparing=Places(dict.fromkeys((_viewer, _operator, _owner, _own), Part(1, 1))),
    replays=Places({_viewer: Part(4, 7), _operator: Part(6, 9), _owner: Part(8, 10), _own: Part(10, 12)}),
    asks=Flow(
        each=dict.fromkeys(Standing, Rate(0.1, 20)),
        together=dict.fromkeys(Standing, Rate(1, 40)),
        newcomers=Newcomers(each=Rate(1 / 600, 2), together=Rate(1, 20)),
    ),
    waiting=by_host(each=20, strangers=60, others=80, own=20),
    marks=Places({_viewer: Part(50, 600), _operator: Part(200, 800), _owner: Part(1000, 1000), _own: Part(1000, 1000)}),
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
