"""How fast control goes from one page to another through the real gateway, and a million steps through its rules."""

from __future__ import annotations

import time
from collections.abc import Callable

from bench.station import percentile, station
from bench.table import Row
from tests.support.control_walk import Walk
from tests.support.page import CutLine, Page, page

TAKES = 60
LOSSES = 8
STEPS = 1_000_000
SEED = 13
TAKEN_MS = 300.0
FREE_MS = 1000.0


def run() -> list[Row]:
    """Both pages are on the stream of a flying station at 60 Hz, each read by a thread of this process."""
    with station() as (gateway, _):
        base = f"http://127.0.0.1:{gateway.port}"
        taken_ms = _take_overs_ms(base)
        cut_ms = [_loss_ms(base, gateway.port, lambda _, line: line.cut()) for _ in range(LOSSES)]
        closed_ms = [_loss_ms(base, gateway.port, lambda pilot, _: pilot.connection.close()) for _ in range(LOSSES)]
    return [
        _row(f"take-over by an owner until the other page is told, worst of {TAKES}", max(taken_ms), TAKEN_MS),
        Row("the same, median", percentile(taken_ms, 0.5), "ms"),
        _row(f"line of the holder cut until its control is free, worst of {LOSSES}", max(cut_ms), FREE_MS),
        _row(f"page of the holder closed until its control is free, worst of {LOSSES}", max(closed_ms), FREE_MS),
        _walk(),
    ]


def _row(what: str, worst_ms: float, reach_ms: float) -> Row:
    return Row(what, worst_ms, "ms", f"<= {reach_ms:g} ms", worst_ms <= reach_ms)


def _take_overs_ms(base: str) -> list[float]:
    took: list[float] = []
    with page(base) as one, page(base) as other:
        for _ in range(TAKES // 2):
            for taker, loser in ((other, one), (one, other)):
                begun_s = time.monotonic()
                taker.act("take", confirm=True).raise_for_status()
                while loser.event("control")["client"] != taker.client:
                    pass
                took.append((time.monotonic() - begun_s) * 1e3)
    return took


def _loss_ms(base: str, port: int, lose: Callable[[Page, CutLine], None]) -> float:
    line = CutLine(port)
    try:
        with page(base) as watching, page(base, line=line.port) as pilot:
            pilot.act("take", confirm=True).raise_for_status()
            while watching.event("control")["client"] != pilot.client:
                pass
            begun_s = time.monotonic()
            lose(pilot, line)
            while watching.event("control")["client"] is not None:
                pass
            free_ms = (time.monotonic() - begun_s) * 1e3
            line.mend()
            return free_ms
    finally:
        line.close()


def _walk() -> Row:
    """Raises AssertionError where two pages have control, a stick has no holder, or there is no way back."""
    begun_s = time.monotonic()
    Walk(SEED).go(STEPS)
    return Row(f"{STEPS:,} random steps through the rules, no second holder", time.monotonic() - begun_s, "s")
