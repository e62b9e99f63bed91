"""What TLS adds to the delay from board bytes to the message at a client: two stations, one under TLS, in turns."""

from __future__ import annotations

from functools import partial
from typing import Final

from bench.latency import keep_open, measure, until_ahrs
from bench.station import percentile, station
from bench.table import Row

ROUNDS: Final = 8
ADDED_MS: Final = 0.1


def run() -> list[Row]:
    """Measure both in turns, so that both meet the same load of the machine."""
    times: dict[str, list[float]] = {"plain": [], "tls": []}
    with station() as (plain, plain_line), station(tls=True) as (secure, secure_line):
        viewers = {"plain": plain.stream(0), "tls": secure.stream(0)}
        lines = {"plain": plain_line, "tls": secure_line}
        for _ in range(ROUNDS):
            for name in times:
                times[name] += measure(lines[name], partial(until_ahrs, viewers[name]))
                keep_open(plain_line, plain)
                keep_open(secure_line, secure)
        for viewer in viewers.values():
            viewer.close()
    rows = []
    for name, share in (("p50", 0.5), ("p99", 0.99)):
        ours, bare = percentile(times["tls"], share), percentile(times["plain"], share)
        reach = f"<= {ADDED_MS} ms over it" if name == "p50" else ""
        ok = ours - bare <= ADDED_MS if name == "p50" else None
        what = f"board bytes to WebSocket message under TLS, {name}"
        rows.append(Row(what, ours, "ms", reach, ok, bare, "the same without TLS"))
    return rows
