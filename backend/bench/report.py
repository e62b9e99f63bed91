"""What the flight report finds in fifty made flights of known dynamics, and how far its figures are off."""

from __future__ import annotations

from typing import Final

from bench.table import Row
from tests.flights.report.made import WITHIN, f1_of, fly, worst_errors

FLIGHTS: Final = 50
REACH_F1: Final = 0.95


def run() -> list[Row]:
    """The tests fly the first of them."""
    flown = fly(FLIGHTS)
    f1 = f1_of(flown)
    rows = [Row(f"manoeuvres found in {FLIGHTS} made flights, F1", f1, "", f">= {REACH_F1:g}", f1 >= REACH_F1)]
    for name, worst in worst_errors(flown).items():
        what = f"worst error of {name} in them"
        rows.append(Row(what, 100.0 * worst, "%", f"<= {100 * WITHIN:g} %", worst <= WITHIN))
    return rows
