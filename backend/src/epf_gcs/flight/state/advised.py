"""Advice that begins in flight is told as an event: the stations hear it, and the recording keeps it."""

from __future__ import annotations

import asyncio
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any, Final

from epf_gcs.contract.events import AdviceEvent
from epf_gcs.contract.inspector import AdviceState
from epf_gcs.flight.state.inspection import build_inspector, take_snapshot
from epf_gcs.flight.state.sources import StateSources
from epf_gcs.repeating import repeat
from epf_gcs.vehicle.outside import Outlet

_EVERY_S: Final = 10.0
# What comes and goes is told again only after a minute without it.
_FORGOTTEN_LOOKS: Final = 6
# What tells two pieces of advice of one code apart.
_ABOUT: Final = ("row", "direction", "topic")


class AdviceWatch:
    """Looks every ten seconds whether there is anything new to advise."""

    def __init__(self, sources: StateSources, outlet: Outlet) -> None:
        self._sources = sources
        self._outlet = outlet
        self._looks = 0
        # The look at which each was last seen, by its code and what it is about.
        self._seen: dict[tuple[str, Any], int] = {}

    async def run(self) -> None:
        """Look forever."""
        await repeat(_EVERY_S, "advice", self._look)

    async def _look(self) -> None:
        # Copied here, calculated in a thread: the HIL loop does not wait.
        snapshot = take_snapshot(self._sources)
        found = await asyncio.to_thread(build_inspector, snapshot)
        for one in self.new_of(found.advice):
            self._outlet.event(AdviceEvent(**asdict(one)))

    def new_of(self, found: Sequence[AdviceState]) -> list[AdviceState]:
        """What was not advised in the last minute."""
        self._looks += 1
        new = []
        for one in found:
            key = (one.code, next((one.params[about] for about in _ABOUT if about in one.params), None))
            if self._looks - self._seen.get(key, -_FORGOTTEN_LOOKS) >= _FORGOTTEN_LOOKS:
                new.append(one)
            self._seen[key] = self._looks
        return new
