"""Whether the recording's times can be believed: a clock that is set in flight, or that nobody vouches for, is noted.

The stamps of a flight go on unbroken whatever happens to the system's clock; the note says how far off they turned out
to be, and the library files the flight under its true time.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from typing import Any, Final, Protocol

from epf_gcs.flight.memory.flight_log import say
from epf_gcs.recordings.notes import CLOCK
from epf_gcs.system.time_source import is_synchronised

# Less than this is a clock that is being steered, which nobody needs to know.
_JUMP_S: Final = 2.0


class Times(Protocol):
    """The clock of the stamps."""

    def unix_ns(self, steady_ns: int) -> int:
        """Unix nanoseconds of a moment of the steady clock."""


class ClockWatch:
    """Belongs to the event loop. `know(name, content)` puts what is known into this recording and the later ones."""

    def __init__(
        self,
        clock: Times,
        know: Callable[[str, Mapping[str, Any]], None],
        *,
        unix_ns: Callable[[], int] = time.time_ns,
        steady_ns: Callable[[], int] = time.monotonic_ns,
        synchronised: Callable[[], bool | None] = is_synchronised,
    ) -> None:
        self._clock = clock
        self._know = know
        self._unix_ns = unix_ns
        self._steady_ns = steady_ns
        self._synchronised = synchronised
        self._noted: tuple[float, bool | None] | None = None

    def look(self) -> None:
        """Compare the clocks, and note what is new."""
        ahead_s = (self._unix_ns() - self._clock.unix_ns(self._steady_ns())) * 1e-9
        vouched = self._synchronised()
        before = self._noted
        if before is not None and abs(ahead_s - before[0]) <= _JUMP_S and vouched == before[1]:
            return
        if before is None and abs(ahead_s) <= _JUMP_S:
            ahead_s = 0.0  # the moment between two readings
        if before is not None and abs(ahead_s - before[0]) > _JUMP_S:
            say("warning", "the system's clock was set", ahead_s=round(ahead_s, 3))
        self._noted = (ahead_s, vouched)
        self._know(CLOCK, {"ahead_s": round(ahead_s, 3), "synchronised": vouched})
