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
from typing import Any, Final

import numpy as np
import numpy.typing as npt

Times = npt.NDArray[np.int64]
Rows = npt.NDArray[np.float64]

# Samples that come after less than this share of the usual period came in a burst.
_BURST_SHARE: Final = 0.5
# A longer silence says nothing of the period.
_LONGEST_STEP_NS: Final = 5_000_000_000
# As many samples are held while a burst may go on.
_MOST_HELD: Final = 200_000


def spread(batches: Iterable[tuple[Times, Rows]]) -> Iterator[tuple[Times, Rows]]:
    """The same samples in the same order, with the times (Unix ns) at which they may have been taken.

    Each batch has times of shape (n,) and rows of shape (n, ...). Where the clock was set back, so is the result.
    """
    held: tuple[Times, Rows] | None = None
    before_ns: int | None = None
    for t_ns, rows in batches:
        if held is not None:
            t_ns, rows = np.concatenate((held[0], t_ns)), np.concatenate((held[1], rows))  # noqa: PLW2901
        held = None
        starts = _starts(t_ns)
        cut = int(starts[-1]) if len(starts) else 0
        if not cut and len(t_ns) < _MOST_HELD:
            held = (t_ns, rows)
            continue
        cut = cut or len(t_ns)
        yield _evened(t_ns, starts, before_ns, cut), rows[:cut]
        before_ns = int(t_ns[cut - 1])
        held = (t_ns[cut:], rows[cut:])
    if held is not None and len(held[0]):
        yield _evened(held[0], _starts(held[0]), before_ns, len(held[0])), held[1]


def _starts(t_ns: Times) -> npt.NDArray[np.int64]:
    """The index of the first sample of each burst; a sample by itself is one too."""
    steps = np.diff(t_ns)
    begins = (steps < 0) | (steps >= _BURST_SHARE * _usual_ns(steps)) & (steps > 0)
    return np.concatenate(([0], np.flatnonzero(begins) + 1)).astype(np.int64)


def _usual_ns(steps: Times) -> float:
    """The usual period: the mean, for whatever came in a burst is missing before it. 0 if there is none."""
    usual = steps[(steps >= 0) & (steps <= _LONGEST_STEP_NS)]
    return float(usual.mean()) if len(usual) else 0.0


def _evened(t_ns: Times, starts: npt.NDArray[np.int64], before_ns: int | None, cut: int) -> Times:
    """The times of the first `cut` samples, of which whole bursts are; `before_ns` is of the sample before them."""
    period_ns = _usual_ns(np.diff(t_ns))
    begins = starts[starts < cut]
    ends = np.append(begins[1:], cut)
    counts, last = ends - begins, t_ns[ends - 1]
    earlier = np.empty_like(last)
    earlier[1:] = last[:-1]
    earlier[0] = last[0] - round(period_ns * counts[0]) if before_ns is None else before_ns
    room = np.where(last > earlier, last - earlier, 0)
    steps = np.minimum(period_ns, room / counts)
    behind = np.repeat(ends - 1, counts) - np.arange(cut)
    evened: Any = np.repeat(last, counts) - np.round(behind * np.repeat(steps, counts)).astype(np.int64)
    return evened  # type: ignore[no-any-return]
