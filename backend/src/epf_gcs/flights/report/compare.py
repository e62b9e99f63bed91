"""Puts an earlier flight's manoeuvres beside those of a flight: the same kind, and nearly the same size."""

from __future__ import annotations

from typing import Any, Final

from epf_gcs.flights.report.gains import FIGURES, KINDS, median

# Sizes that differ more than this are not the same manoeuvre.
_MOST_RATIO: Final = 2.0

Values = dict[str, Any]


def compare(report: Values, earlier: Values) -> Values:
    """The report with each manoeuvre's like in the earlier flight (its place in `earlier.manoeuvres`), and the gains
    that both flights know but with another value."""
    there = earlier["manoeuvres"]
    manoeuvres = [{**one, "earlier": _alike(one, there)} for one in report["manoeuvres"]]
    before, now = earlier["gains_known"], report["gains_known"]
    gains = [
        {"name": name, "before": before[name], "after": value}
        for name, value in now.items()
        if name in before and before[name] != value
    ]
    return {
        **report,
        "manoeuvres": manoeuvres,
        "earlier": {
            "flight": earlier["flight"],
            "times": earlier["times"],
            "distances": earlier["distances"],
            "battery": earlier["battery"],
            "link": earlier["link"],
            "loops": earlier["loops"],
            "manoeuvres": there,
            "gains": gains,
        },
    }


def loops(manoeuvres: list[Values]) -> list[Values]:
    """Medians of each loop over all its manoeuvres that have figures."""
    found = []
    for loop, kinds in KINDS.items():
        some = [one for one in manoeuvres if one["kind"] in kinds and one["method"] != "none"]
        if some:
            medians = {name: median([one[name] for one in some]) for name in FIGURES}
            found.append({"loop": loop, "manoeuvres": len(some), "unit": some[0]["unit"], **medians})
    return found


def _alike(one: Values, there: list[Values]) -> int | None:
    """The place of the manoeuvre that is nearest in size; of legs the one to the same waypoint."""
    best: tuple[float, int] | None = None
    for place, other in enumerate(there):
        if other["kind"] != one["kind"] or (one["kind"] == "leg" and other["waypoint"] != one["waypoint"]):
            continue
        ratio = max(one["size"], other["size"]) / max(min(one["size"], other["size"]), 1e-9)
        if ratio <= _MOST_RATIO and (one["method"] == "none") == (other["method"] == "none"):
            best = min(best or (ratio, place), (ratio, place))
    return None if best is None else best[1]
