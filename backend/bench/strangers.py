"""The HIL loop while another program of the simulator's machine floods its port: `python -m bench.strangers PORT`.

Measures as `bench.hil`, without viewers, with and without the flood; and how much of the flood is recorded.
"""

from __future__ import annotations

import contextlib
import socket
import subprocess
import sys
import time
from pathlib import Path
from typing import Final

from bench.hil import fly, simulator_socket
from bench.station import percentile, station
from bench.table import Row
from tests.support.ports import free_udp_port

PER_S: Final = 10_000
REACH_MS: Final = 0.5
_STEP_S: Final = 0.001
_FORGED: Final = b"DATA@" + bytes(36)


def run() -> list[Row]:
    """Measure both directions of the loop."""
    quiet, quiet_bytes = _measure(flooded=False)
    flooded, flooded_bytes = _measure(flooded=True)
    rows: list[Row] = []
    for way, times, before in zip(
        ("datagram in to frame out", "frame in to datagram out"), flooded, quiet, strict=True
    ):
        for name, share in (("p50", 0.5), ("p99", 0.99)):
            ours, bare = percentile(times, share), percentile(before, share)
            ok = ours - bare <= REACH_MS
            what = f"HIL, {PER_S} strangers a second: {way}, {name}"
            rows.append(Row(what, ours, "ms", f"<= {REACH_MS} ms over it", ok, bare, "no strangers"))
    what = f"recorded, {PER_S} strangers a second"
    ok = flooded_bytes <= 1.1 * quiet_bytes
    rows.append(Row(what, flooded_bytes / 1000.0, "kB/s", "as without", ok, quiet_bytes / 1000.0, "no strangers"))
    return rows


def _measure(*, flooded: bool) -> tuple[tuple[list[float], list[float]], float]:
    """Delays in ms of both directions, and recorded bytes/s."""
    simulator, port = simulator_socket()
    with contextlib.closing(simulator), station() as (gateway, line):
        receive_port = free_udp_port()
        gateway.put("/links/simulator", {"receive_port": receive_port, "send_host": "127.0.0.1", "send_port": port})
        gateway.put("/hil", {"path": "assisted"})
        # The simulator sends first, so that the gateway accepts it as the sender.
        simulator.sendto(_FORGED, ("127.0.0.1", receive_port))
        time.sleep(0.1)
        flood = subprocess.Popen([sys.executable, "-m", "bench.strangers", str(receive_port)]) if flooded else None
        try:
            begun_s = time.monotonic()
            times = fly(simulator, receive_port, line)
            took_s = time.monotonic() - begun_s
        finally:
            if flood is not None:
                flood.terminate()
                flood.wait()
        recorded = sum(file.stat().st_size for file in Path(line.folder).rglob("*.mcap"))
    return times, recorded / took_s


def _flood(port: int) -> None:
    """Send a simulator's rows from another port of the same machine, forever."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        sent, begun_s = 0, time.monotonic()
        while True:
            while sent < (time.monotonic() - begun_s) * PER_S:
                sock.sendto(_FORGED, ("127.0.0.1", port))
                sent += 1
            time.sleep(_STEP_S)


if __name__ == "__main__":
    _flood(int(sys.argv[1]))
