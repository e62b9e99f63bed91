"""When samples were taken that came together: spread over the time before they came.

The wire's messages have no time of their own (the receiver's time of day does not come over it), so a sample has the
time at which it was read. While the station's machine was busy, many samples were read at once and have one time, or
nearly: a reader that derives a speed from them finds one that nobody flew. A late sample can only be later than it
was taken, and never by so much that it was taken before the one ahead of it came. So samples that follow each other
much faster than is usual are one burst, whose last has the right time, and the others are spread evenly back from it,
at the usual period or closer if the time since the sample before the burst allows no more.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final

import numpy as np
import numpy.typing as npt

Times = npt.NDArray[np.int64]
Rows = npt.NDArray[np.float64]

# Samples that come after less than this share of the usual period came in a burst.
_BURST_SHARE: Final = 0.5
# A longer silence says nothing of the period.
_LONGEST_STEP_NS: Final = 5_000_000_000
# The usual period is that of so many steps before, and of those at hand.
_RECENT: Final = 4096
# As many samples are held while a burst may go on.
_MOST_HELD: Final = 200_000


def spread(batches: Iterable[tuple[Times, Rows]]) -> Iterator[tuple[Times, Rows]]:
    """The same samples in the same order, with the times (Unix ns) at which they may have been taken.

    Each batch has times of shape (n,) and rows of shape (n, ...). Where the clock was set back, so is the result.
    """
    held: tuple[Times, Rows] | None = None
    before_ns: int | None = None
    recent = np.empty(0, dtype=np.int64)
    for t_ns, rows in batches:
        if held is not None:
            t_ns, rows = np.concatenate((held[0], t_ns)), np.concatenate((held[1], rows))  # noqa: PLW2901
        held = None
        steps = np.diff(t_ns)
        period_ns = _usual_ns(np.concatenate((recent, steps)))
        starts = _starts(steps, period_ns)
        cut = int(starts[-1])
        if not cut and len(t_ns) < _MOST_HELD:
            held = (t_ns, rows)
            continue
        cut = cut or len(t_ns)
        yield _evened(t_ns[:cut], starts[starts < cut], before_ns, period_ns), rows[:cut]
        before_ns = int(t_ns[cut - 1])
        recent = np.concatenate((recent, steps[:cut]))[-_RECENT:]
        held = (t_ns[cut:], rows[cut:])
    if held is not None and len(held[0]):
        steps = np.diff(held[0])
        period_ns = _usual_ns(np.concatenate((recent, steps)))
        yield _evened(held[0], _starts(steps, period_ns), before_ns, period_ns), held[1]


def _starts(steps: Times, period_ns: float) -> npt.NDArray[np.int64]:
    """The index of the first sample of each burst; a sample by itself is one too."""
    begins = (steps < 0) | ((steps >= _BURST_SHARE * period_ns) & (steps > 0))
    return np.concatenate(([0], np.flatnonzero(begins) + 1)).astype(np.int64)


def _usual_ns(steps: Times) -> float:
    """The usual period: half of the time passes in steps that are no longer. So bursts, which take no time, and a few
    stalls have no part in it. 0 if there is none."""
    usual = np.sort(steps[(steps > 0) & (steps <= _LONGEST_STEP_NS)])
    if not len(usual):
        return 0.0
    passed = np.cumsum(usual)
    return float(usual[np.searchsorted(passed, passed[-1] / 2)])


def _evened(t_ns: Times, starts: npt.NDArray[np.int64], before_ns: int | None, period_ns: float) -> Times:
    """The times of whole bursts; `before_ns` is that of the sample before them."""
    ends = np.append(starts[1:], len(t_ns))
    counts, last = ends - starts, t_ns[ends - 1]
    earlier = np.empty_like(last)
    earlier[1:] = last[:-1]
    earlier[0] = last[0] - round(period_ns * counts[0]) if before_ns is None else before_ns
    room = np.where(last > earlier, last - earlier, 0)
    steps = np.minimum(period_ns, room / counts)
    behind = np.repeat(ends - 1, counts) - np.arange(len(t_ns))
    evened = np.repeat(last, counts) - np.ceil(behind * np.repeat(steps, counts)).astype(np.int64)
    # Those of a burst that did not all come at once are no later than they came.
    return np.minimum(evened, t_ns)
