"""Thins a signal for drawing so that no extreme is lost: a spike of one sample is seen at every zoom."""

from __future__ import annotations

from typing import Final, NamedTuple

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

# Samples further apart than this many usual periods, and than this time, leave a gap in the drawn line.
_GAP_PERIODS: Final = 6.0
_LEAST_GAP_S: Final = 0.5
# With fewer samples there is no usual period.
_LEAST_SAMPLES: Final = 8


class SignalEnvelope(NamedTuple):
    """`at_s` is the time of each step, `low` and `high` its extremes (NaN: no value, or a gap).

    `mean` (None where there is none) and `known` (a number) are of all samples of the stretch that have a value.
    """

    at_s: Array
    low: Array
    high: Array
    mean: float | None
    known: int


def usual_period_s(t_s: Array) -> float | None:
    """The usual time between samples (seconds); None where there are too few to tell."""
    return float(np.median(np.diff(t_s))) if len(t_s) >= _LEAST_SAMPLES else None


def longest_step_s(period_s: float | None) -> float:
    """Samples further apart than this have a gap between them."""
    return np.inf if period_s is None else max(_LEAST_GAP_S, _GAP_PERIODS * period_s)


def gaps_of(t_s: Array, period_s: float | None) -> list[tuple[float, float]]:
    """The stretches without samples, as times of the sample before and of the one after."""
    places = np.flatnonzero(np.diff(t_s) > longest_step_s(period_s))
    return [(float(t_s[place]), float(t_s[place + 1])) for place in places]


def thin(t_s: Array, values: Array, from_s: float, to_s: float, points: int, period_s: float | None) -> SignalEnvelope:
    """The samples from `from_s` to `to_s` in at most `points` steps.

    `t_s` (n,) in order, `values` (n,) with NaN where there is no value; `period_s` as `usual_period_s` gives it.
    With at most `points` samples each is a step of its own. Gaps add one step each, whose values are NaN.
    """
    first, last = np.searchsorted(t_s, (from_s, np.nextafter(to_s, np.inf)))
    t_s, values = t_s[first:last], values[first:last]
    known = np.isfinite(values)
    count = int(np.count_nonzero(known))
    mean = float(np.mean(values, where=known)) if count else None
    if len(t_s) <= points:
        at_s, low, high = t_s, values, values
        before = np.flatnonzero(np.diff(t_s) > longest_step_s(period_s))
        middles = (t_s[before] + t_s[before + 1]) / 2
        places = before + 1
    else:
        starts = _starts(t_s, from_s, to_s, points)
        ends = np.append(starts[1:], len(t_s)) - 1
        at_s = (t_s[starts] + t_s[ends]) / 2
        low, high = np.fmin.reduceat(values, starts), np.fmax.reduceat(values, starts)
        # A gap inside a step is narrower than a step: only those between steps can be drawn.
        before = np.flatnonzero(t_s[starts[1:]] - t_s[ends[:-1]] > longest_step_s(period_s))
        middles = (t_s[ends[before]] + t_s[starts[before + 1]]) / 2
        places = before + 1
    nothing = np.full(len(places), np.nan)
    return SignalEnvelope(
        np.insert(at_s, places, middles),
        np.insert(low, places, nothing),
        np.insert(high, places, nothing),
        mean,
        count,
    )


def _starts(t_s: Array, from_s: float, to_s: float, points: int) -> npt.NDArray[np.intp]:
    """The index of the first sample of each of `points` equal steps that has any."""
    edges = np.linspace(from_s, to_s, points, endpoint=False)
    starts = np.searchsorted(t_s, edges)
    starts[0] = 0
    return np.unique(starts[starts < len(t_s)])
