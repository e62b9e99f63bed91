"""A campaign flown on this machine's processors: each flight by a process that may die, none of them twice."""

from __future__ import annotations

import math
import signal
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from itertools import islice
from multiprocessing import get_context
from pathlib import Path
from typing import Final

from epf_gcs.codec.tables import Waypoint
from epf_gcs.lab.campaign import Campaign
from epf_gcs.lab.conditions import Conditions, gains_of
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.faults import Asked, read
from epf_gcs.lab.flight import Flight, fly
from epf_gcs.lab.routes import Route, route
from epf_gcs.lab.rows import Results, Row, row
from epf_gcs.system.priority import be_nice

# Lower than anything that a flight needs.
_NICE: Final = 19
# So many flights wait for each process, so that none of them waits for us.
_AHEAD: Final = 4
# A flight at whose turn a process died so often is a row that says so.
_TRIES: Final = 3


def fly_order(campaign: Campaign, number: int, library: Path | None = None) -> Row:
    """Fly one; what cannot be flown is a row that says why."""
    order = campaign.order(number)
    try:
        flown = fly_wanted(campaign.route, order.conditions, order.gains, library, order.faults)
        return row(order, flown)
    except LabError as error:
        return row(order, None, str(error))


def fly_wanted(
    wanted: Route | str | Path | Sequence[Waypoint],
    conditions: Mapping[str, object],
    gains: Mapping[str, object] | None = None,
    library: Path | None = None,
    faults: Iterable[Asked] = (),
    longest_s: float = math.inf,
) -> Flight:
    """Fly a route by name, from a file or of waypoints, in conditions by name. Raises LabError for an unknown one."""
    what = wanted if isinstance(wanted, Route) else route(wanted)
    return fly(what, Conditions.of(conditions), gains_of(gains or {}), library, read(faults), longest_s)


def fly_all(
    campaign: Campaign,
    results: Results,
    workers: int,
    library: Path | None = None,
    on_row: Callable[[Row], None] = lambda _: None,
) -> None:
    """Fly what is missing. What was flown when this ends by an exception is kept."""
    tries: dict[int, int] = {}
    while missing := list(results.missing()):
        try:
            for flown in _flown(campaign, missing, workers, library, tries):
                results.add(flown)
                on_row(flown)
        except BrokenProcessPool:
            for number in [number for number, count in tries.items() if count >= _TRIES]:
                if number not in results.rows:
                    lost = row(campaign.order(number), None, "the process that flew it died")
                    results.add(lost)
                    on_row(lost)


def _flown(
    campaign: Campaign, numbers: list[int], workers: int, library: Path | None, tries: dict[int, int]
) -> Iterator[Row]:
    """In the order in which they are done. Counts in `tries` who was under way when a process died."""
    coming = iter(numbers)
    under_way: dict[Future[Row], int] = {}
    pool = ProcessPoolExecutor(workers, get_context("spawn"), initializer=_begin)
    try:
        while True:
            for number in islice(coming, _AHEAD * workers - len(under_way)):
                under_way[pool.submit(fly_order, campaign, number, library)] = number
            if not under_way:
                return
            done, _ = wait(under_way, return_when=FIRST_COMPLETED)
            for future in done:
                yield future.result()
                del under_way[future]
    except BrokenProcessPool:
        for number in sorted(under_way.values())[:workers]:
            tries[number] = tries.get(number, 0) + 1
        raise
    finally:
        pool.shutdown(cancel_futures=True)


def _begin() -> None:
    """In each process: Ctrl+C is for the one that started it."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    be_nice(_NICE)
