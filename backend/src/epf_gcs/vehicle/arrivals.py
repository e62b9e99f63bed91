"""When the newest messages of one kind came: how often, how evenly, and what the last one said."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise, takewhile
from math import sqrt
from statistics import median
from typing import Any, Final

from epf_gcs.vehicle.health import STALE_PERIODS

_INTERVALS: Final = 256
_RATE_WINDOW_S: Final = 5.0
# Intervals before a pause are not used: they do not describe the stream as it is now.
_PAUSE_PERIODS: Final = 10.0
_SHORTEST_PAUSE_S: Final = 1.0
_RECENT: Final = 16
_SHORTEST_SILENCE_S: Final = 0.5
# Times that a kept state holds: enough for a rate; jitter is measured anew.
_REMEMBERED: Final = 9


KeptArrivals = tuple[int, list[float], Any]


@dataclass(frozen=True, slots=True)
class ArrivalSummary:
    """`jitter_ms` is the standard deviation of the intervals, None below two; `age_s` is None before the first."""

    count: int
    rate_hz: float
    jitter_ms: float | None
    age_s: float | None


class Arrivals:
    """Call `heard` for each message; it costs a counter and one append. Times in seconds of any steady clock."""

    __slots__ = ("_times_s", "count", "values")

    def __init__(self) -> None:
        self.count = 0
        self.values: Any = None
        self._times_s: deque[float] = deque(maxlen=_INTERVALS + 1)

    def heard(self, t_s: float, values: Any) -> None:
        """A message came."""
        self.count += 1
        self.values = values
        self._times_s.append(t_s)

    @property
    def last_s(self) -> float | None:
        """When the newest came; None before the first."""
        return self._times_s[-1] if self._times_s else None

    def copy(self) -> Arrivals:
        """A copy of the present state, which later messages do not change."""
        same = Arrivals()
        same.count = self.count
        same.values = self.values
        same._times_s = self._times_s.copy()
        return same

    def kept(self) -> KeptArrivals:
        """Count, times of the newest messages and values of the last, for `restored`."""
        return self.count, list(self._times_s)[-_REMEMBERED:], self.values

    @classmethod
    def restored(cls, count: int, times_s: Iterable[float], values: Any) -> Arrivals:
        """Go on from a state that `kept` gave."""
        same = cls()
        same.count = count
        same.values = values
        same._times_s.extend(times_s)
        return same

    def forget_rate(self) -> None:
        """The rate was changed: drop the measured intervals, keep the time of the newest message."""
        newest = list(self._times_s)[-1:]
        self._times_s.clear()
        self._times_s.extend(newest)

    def summary(self, now_s: float) -> ArrivalSummary:
        """Count, rate, jitter and age at `now_s`."""
        if not self._times_s:
            return ArrivalSummary(self.count, 0.0, None, None)
        age_s = max(0.0, now_s - self._times_s[-1])
        intervals = self._run()
        if not intervals:
            return ArrivalSummary(self.count, 0.0, None, age_s)
        mean_s = sum(intervals) / len(intervals)
        jitter_ms = None
        if len(intervals) > 1:
            jitter_ms = 1000.0 * sqrt(sum((interval - mean_s) ** 2 for interval in intervals) / len(intervals))
        return ArrivalSummary(self.count, _rate_hz(intervals, age_s), jitter_ms, age_s)

    def _run(self) -> list[float]:
        """Intervals since the last pause, newest first."""
        times_s = list(self._times_s)
        intervals = [later - earlier for earlier, later in pairwise(times_s)][::-1]
        if not intervals:
            return []
        pause_s = max(_SHORTEST_PAUSE_S, _PAUSE_PERIODS * median(intervals[:_RECENT]))
        if max(intervals) <= pause_s:
            return intervals
        return list(takewhile(lambda interval: interval <= pause_s, intervals))


def _rate_hz(intervals: list[float], age_s: float) -> float:
    """Rate over the newest five seconds, or from the last two messages if they are further apart; 0 after they stop."""
    span_s = 0.0
    count = 0
    for interval in intervals:
        if count and span_s + interval > _RATE_WINDOW_S:
            break
        span_s += interval
        count += 1
    if span_s <= 0 or age_s > max(STALE_PERIODS * span_s / count, _SHORTEST_SILENCE_S):
        return 0.0
    return count / span_s
