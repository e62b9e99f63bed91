"""The HIL loop under each attack of `bench.attacks`, and with 50 and 200 viewers, compared to the undisturbed loop.

`besieged:pings` runs one attack, with the undisturbed loop of the same run: a minute each instead of eight for all.
"""

from __future__ import annotations

import contextlib
from typing import Final

from bench.attacks import ATTACKS, attack
from bench.hil import fly, simulator_socket
from bench.station import HEARTBEAT, percentile, station
from bench.table import Row
from tests.support.ports import free_udp_port

REACH_MS: Final = 0.5
_WAYS: Final = ("datagram in to frame out", "frame in to datagram out")

Ways = tuple[list[float], list[float]]


def run(only: str = "") -> list[Row]:
    """p99 of both directions under each attack (or one of them), compared to the undisturbed loop of the same run."""
    quiet = _measure(None)
    rows: list[Row] = []
    for name in [only] if only else ATTACKS:
        for way, times, before in zip(_WAYS, _measure(name), quiet, strict=True):
            ours, calm = percentile(times, 0.99), percentile(before, 0.99)
            reach = f"<= {REACH_MS} ms over it"
            rows.append(Row(f"HIL under {name}: {way}, p99", ours, "ms", reach, ours - calm <= REACH_MS, calm, "quiet"))
    return rows


def _measure(name: str | None) -> Ways:
    simulator, port = simulator_socket()
    with contextlib.closing(simulator), station() as (gateway, line):
        receive_port = free_udp_port()
        address = {"receive_port": receive_port, "send_host": "127.0.0.1", "send_port": port}
        gateway.put("/links/simulator", address)
        gateway.put("/hil", {"path": "assisted"})

        def live_on() -> None:
            line.write(HEARTBEAT)
            line.read(0.0)

        with contextlib.nullcontext() if name is None else attack(name, gateway.port, receive_port, live_on):
            return fly(simulator, receive_port, line)
