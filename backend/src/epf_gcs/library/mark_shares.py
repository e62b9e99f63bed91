"""How many marks one caller has set in one flight, and how many there are: both have a limit.

Counted since the station started. A mark that was removed counts no more.
"""

from __future__ import annotations

from collections import Counter, OrderedDict
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Final

from epf_gcs.contract.flights import FlightEvents
from epf_gcs.errors import ConflictError
from epf_gcs.shares.holder import Holder, Standing
from epf_gcs.shares.places import Places

_MOST_FLIGHTS: Final = 256


@dataclass(slots=True)
class _Marked:
    """A flight. `by`: who set which mark. `there`: marks that it had when it was looked at last."""

    by: dict[str, str] = field(default_factory=dict)
    there: int = 0
    under_way: Counter[str] = field(default_factory=Counter)


class MarkShares:
    """Owned by the event loop."""

    def __init__(self, row: Places) -> None:
        self._row = row
        self._flights: OrderedDict[str, _Marked] = OrderedDict()

    @contextmanager
    def one_more(self, flight: str, holder: Holder) -> Iterator[None]:
        """A mark is being set, inside. Raises ConflictError."""
        marked = self._marked(flight)
        own = sum(key == holder.key for key in marked.by.values()) + marked.under_way[holder.key]
        there = max(marked.there, len(marked.by)) + marked.under_way.total()
        shortage = self._row.shortage(holder, own, {Standing.stranger: there})
        if shortage is not None and shortage.of == "own":
            raise ConflictError(
                "marks_own",
                f"You have set {shortage.most} marks in this flight already: have an operator remove some.",
                limit=shortage.most,
            )
        if shortage is not None:
            raise ConflictError(
                "marks_full",
                f"This flight has {shortage.most} marks already: have an operator remove some.",
                limit=shortage.most,
            )
        marked.under_way[holder.key] += 1
        try:
            yield
        finally:
            marked.under_way[holder.key] -= 1

    def note(self, flight: str, holder: Holder, mark: str) -> None:
        """This mark was set by this holder."""
        self._marked(flight).by[mark] = holder.key

    def forget(self, flight: str, mark: str) -> None:
        """This mark was removed."""
        self._marked(flight).by.pop(mark, None)

    def look(self, flight: str, events: FlightEvents) -> None:
        """These are the events of the flight now."""
        self._marked(flight).there = sum(event.kind == "mark" for event in events.events)

    def _marked(self, flight: str) -> _Marked:
        marked = self._flights.setdefault(flight, _Marked())
        self._flights.move_to_end(flight)
        if len(self._flights) > _MOST_FLIGHTS:
            self._flights.popitem(last=False)
        return marked
