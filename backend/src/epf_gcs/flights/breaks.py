"""Where a flight is broken: nothing is computed across a break.

The simulator put its aircraft elsewhere or was paused, or the board was silent or began anew.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

import numpy as np

from epf_gcs.flights.events import Event
from epf_gcs.flights.signals import Array

Span = tuple[float, float]
"""From and to, in seconds since the flight's start."""

_SIMULATOR: Final = frozenset({("jump", ""), ("gap", "simulator"), ("alarm", "simulator_paused")})
_BOARD: Final = frozenset({("gap", "silence"), ("restart", "")})


def motion_breaks(events: Iterable[Event], start_ns: int) -> list[Span]:
    """Where the aircraft's motion is broken, in order; while the board is silent, the simulator's aircraft flies on."""
    return _breaks(events, start_ns, _SIMULATOR)


def breaks_of(events: Iterable[Event], start_ns: int) -> list[Span]:
    """All breaks, also those of what the board did, in order; a moment is a break too."""
    return _breaks(events, start_ns, _SIMULATOR | _BOARD)


def _breaks(events: Iterable[Event], start_ns: int, meant: frozenset[tuple[str, str]]) -> list[Span]:
    """None of them overlap."""
    found: list[Span] = []
    for event in sorted(events, key=lambda one: one.t_ns):
        if (event.kind, event.name) not in meant:
            continue
        is_pause = event.kind == "alarm"
        begin = (event.t_ns - start_ns) * 1e-9
        end = (event.until_ns - start_ns) * 1e-9 if event.until_ns is not None else np.inf if is_pause else begin
        if found and begin <= found[-1][1]:
            found[-1] = (found[-1][0], max(found[-1][1], end))
        else:
            found.append((begin, end))
    return found


def parts(t_s: Array, breaks: list[Span]) -> list[Array]:
    """The places of the samples at these times (n,), in order: one array for each unbroken part that has any."""
    begins, ends = (np.array([span[side] for span in breaks]) for side in (0, 1))
    number = np.searchsorted(ends, t_s, side="right")
    following = np.append(begins, np.inf)[number]
    places = np.flatnonzero(t_s <= following)
    return np.split(places, np.flatnonzero(np.diff(number[places])) + 1) if len(places) else []
