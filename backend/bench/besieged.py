"""The HIL loop under each attack of `bench.attacks`, and with 50 and 200 viewers, compared to the undisturbed loop.

A bare relay flies beside it, frame by frame in turns: what both take more is the machine, what only the station takes
more is the station. `besieged:pings` runs one attack, and the undisturbed loop; `besieged:none` the latter alone.
"""

from __future__ import annotations

import contextlib
from typing import Final, NamedTuple

from bench.attacks import ATTACKS, TLS_HALF_OPEN, attack
from bench.hil import Loop, bare_relay, fly_loops, simulator_socket
from bench.slow import own_mb
from bench.station import HEARTBEAT, Gateway, NetworkLine, percentile, station
from bench.table import Row
from tests.support.ports import free_udp_port

REACH_MS: Final = 0.5
FRAMES: Final = 1000
QUIET: Final = "none"
GROWTH_REACH_MB: Final = 4.0


class Ways(NamedTuple):
    """Delays in ms, the number of frames that did not come through, and what became of the station meanwhile."""

    there: list[float]
    back: list[float]
    lost: int
    grown_mb: float = 0.0
    unrecorded: int = 0


def run(only: str = "") -> list[Row]:
    """Both directions without and under each attack (or one of them)."""
    calm, relay = _measure(QUIET)
    rows = _rows(QUIET, calm, relay, calm)
    for name in [only] if only else ATTACKS:
        if name != QUIET:
            rows += _rows(name, *_measure(name), calm)
    return rows


def _rows(name: str, ours: Ways, relay: Ways, calm: Ways) -> list[Row]:
    rows: list[Row] = []
    for way, ours_ms, relay_ms, calm_ms in zip(_WAYS, ours[:2], relay[:2], calm[:2], strict=True):
        what = f"HIL under {name}: {_WAYS[way]}"
        median, bare_median = percentile(ours_ms, 0.5), percentile(relay_ms, 0.5)
        p99, bare, quiet = (percentile(times, 0.99) for times in (ours_ms, relay_ms, calm_ms))
        reach = f"<= {REACH_MS} ms over it"
        rows.append(Row(f"{what}, p50", median, "ms", "", None, bare_median, "bare relay beside it"))
        rows.append(Row(f"{what}, p99", p99, "ms", reach, p99 - bare <= REACH_MS, bare, "bare relay beside it"))
        if name != QUIET:
            rows.append(Row(f"{what}, p99", p99, "ms", reach, p99 - quiet <= REACH_MS, quiet, "quiet"))
    rows.append(Row(f"HIL under {name}: frames lost", ours.lost, "", "0", ours.lost == 0, relay.lost, "bare relay"))
    grown, lost = ours.grown_mb, ours.unrecorded
    what = f"HIL under {name}: memory of flight and web process, second half over first"
    rows.append(Row(what, grown, "MB", f"<= {GROWTH_REACH_MB:g} MB", grown <= GROWTH_REACH_MB))
    rows.append(Row(f"HIL under {name}: bytes not recorded", lost, "", "0", lost == 0))
    return rows


_WAYS: Final = {"in": "datagram in to frame out", "back": "frame in to datagram out"}


def _measure(name: str) -> tuple[Ways, Ways]:
    """The station's delays, and those of the relay that flies beside it."""
    simulator, port = simulator_socket()
    with (
        contextlib.closing(simulator),
        station(NetworkLine, tls=name == TLS_HALF_OPEN) as (gateway, line),
        bare_relay(NetworkLine) as relay,
    ):
        receive_port = free_udp_port()
        address = {"receive_port": receive_port, "send_host": "127.0.0.1", "send_port": port}
        gateway.put("/links/simulator", address)
        gateway.put("/hil", {"path": "assisted"})

        ours = Loop(simulator, receive_port, line)
        ours.begin()

        def live_on() -> None:
            # The simulator too: another sender is accepted in place of one that is silent.
            line.write(HEARTBEAT)
            line.read(0.0)
            ours.begin()

        with contextlib.nullcontext() if name == QUIET else attack(name, gateway.port, receive_port, live_on):
            fly_loops(ours, relay, frames=FRAMES // 2)
            first_mb = _memory_mb(gateway)
            fly_loops(ours, relay, frames=FRAMES // 2)
            grown_mb = _memory_mb(gateway) - first_mb
        recording = gateway.get("/status")["recording"]
        assert recording["active"], recording
    return Ways(ours.there, ours.back, ours.lost, grown_mb, recording["bytes_lost"]), Ways(
        relay.there, relay.back, relay.lost
    )


def _memory_mb(gateway: Gateway) -> float:
    """What the flight and the web process use of the memory by themselves."""
    return sum(own_mb(pid) for pid in gateway.parts.values())
