"""What the flight report reads from fifty flights of JSBSim under the board's own code, and how far it is off what they
flew: five steps each, with gains from sluggish to unstable, in calm air, wind and light turbulence."""

from __future__ import annotations

from typing import Final

from bench.table import Row
from board_tests.closed_loop.stepped_flights import WITHIN, errors, f1_of, fly

FLIGHTS: Final = 50
REACH_F1: Final = 0.95


def run() -> list[Row]:
    """The tests fly the first of them."""
    flights = [fly(seed) for seed in range(FLIGHTS)]
    steps, f1 = sum(len(flight.flown) for flight in flights), f1_of(flights)
    rows = [
        Row(
            f"{steps} steps found in {FLIGHTS} flights of the closed loop, F1",
            f1,
            "",
            f">= {REACH_F1:g}",
            f1 >= REACH_F1,
        )
    ]
    for name, found in errors(flights).items():
        what = f"worst error of the {name} in {len(found)} of them"
        rows.append(Row(what, 100.0 * max(found), "%", f"<= {100 * WITHIN:g} %", max(found) <= WITHIN))
    for name, found in errors(flights, is_gust=True).items():
        rows.append(Row(f"the same of {len(found)} airspeeds in gusts of their size, {name}", 100.0 * max(found), "%"))
    return rows
