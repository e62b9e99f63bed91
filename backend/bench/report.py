"""What the flight report finds in fifty flights of the board's own laws in JSBSim, and how far its figures are off."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from bench.table import Row
from board_tests.closed_loop.report_flights import FlownSteps, fly_steps

FLIGHTS: Final = 50
WITHIN: Final = 0.05


def run() -> list[Row]:
    """The tests fly the first of them."""
    flown = [fly_steps(seed) for seed in range(1, FLIGHTS + 1)]
    pairs = [pair for one in flown for pair in one.pairs()]
    found = sum(one is not None for _, one in pairs) / len(pairs)
    rows = [Row(f"steps found of {len(pairs)} in {FLIGHTS} flights", 100.0 * found, "%", ">= 95 %", found >= 0.95)]
    for name, errors in errors_of(flown).items():
        what = f"worst error of {name} in {len(errors)} of them"
        worst = max(errors)
        rows.append(Row(what, 100.0 * worst, "%", f"<= {100 * WITHIN:g} %", worst <= WITHIN))
    return rows


def errors_of(flown: Sequence[FlownSteps]) -> dict[str, list[float]]:
    """Of the rise time as shares of the true one, of overshoot and steady error as shares of the step."""
    errors: dict[str, list[float]] = {"rise time": [], "overshoot": [], "steady error": []}
    for truth, one in (pair for flight in flown for pair in flight.pairs()):
        if one is None:
            continue
        if one.rise_s is not None and truth.rise_s is not None:
            errors["rise time"].append(abs(one.rise_s / truth.rise_s - 1.0))
        if one.overshoot_percent is not None:
            errors["overshoot"].append(abs(one.overshoot_percent - truth.overshoot_percent) / 100.0)
        if one.steady_error is not None:
            errors["steady error"].append(abs(one.steady_error - truth.end_error) / truth.size)
    return errors
