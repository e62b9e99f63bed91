"""Puts an earlier flight's manoeuvres beside those of a flight: the same kind, and nearly the same size."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from epf_gcs.contract.report import EarlierFlight, FlightReport, GainDifference, ReportLoop, ReportManoeuvre
from epf_gcs.flights.report.gains import KINDS, medians

# Sizes that differ more than this are not the same manoeuvre.
_MOST_RATIO: Final = 2.0


def compare(report: FlightReport, earlier: FlightReport) -> FlightReport:
    """The report with each manoeuvre's like in the earlier flight (its place in `earlier.manoeuvres`), and the gains
    that both flights know but with another value."""
    there = earlier.manoeuvres
    manoeuvres = [replace(one, earlier=_alike(one, there)) for one in report.manoeuvres]
    before, now = earlier.gains_known, report.gains_known
    gains = [
        GainDifference(name, before[name], value)
        for name, value in now.items()
        if name in before and before[name] != value
    ]
    other = EarlierFlight(
        flight=earlier.flight,
        times=earlier.times,
        distances=earlier.distances,
        battery=earlier.battery,
        link=earlier.link,
        loops=earlier.loops,
        manoeuvres=there,
        gains=gains,
    )
    return replace(report, manoeuvres=manoeuvres, earlier=other)


def loops(manoeuvres: list[ReportManoeuvre]) -> list[ReportLoop]:
    """Medians of each loop over all its manoeuvres that have figures."""
    found = []
    for loop, kinds in KINDS.items():
        some = [one for one in manoeuvres if one.kind in kinds and one.method != "none"]
        if some:
            found.append(ReportLoop(loop, len(some), some[0].unit, **medians(some)))
    return found


def _alike(one: ReportManoeuvre, there: list[ReportManoeuvre]) -> int | None:
    """The place of the manoeuvre that is nearest in size; of legs the one to the same waypoint."""
    best: tuple[float, int] | None = None
    for place, other in enumerate(there):
        if other.kind != one.kind or (one.kind == "leg" and other.waypoint != one.waypoint):
            continue
        ratio = max(one.size, other.size) / max(min(one.size, other.size), 1e-9)
        if ratio <= _MOST_RATIO and (one.method == "none") == (other.method == "none"):
            best = min(best or (ratio, place), (ratio, place))
    return None if best is None else best[1]
