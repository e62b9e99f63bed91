"""How well a topic arrives: its rate, its age and its implausible values."""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Iterable, Mapping
from statistics import median
from typing import Final

# Enough that one late or doubled sample does not change the median, few enough to follow a new rate within a second.
_INTERVALS: Final = 8
_TRUSTED_INTERVALS: Final = 5
STALE_PERIODS: Final = 3
# A 20 ms stream through a serial adapter, an operating system and a network jitters by more than three periods.
_SHORTEST_STALE_S: Final = 0.2

# Which task of the board sends which topic; the period of each task can be commanded.
TASK_OF_TOPIC: Final = {
    "heartbeat": "set_parameter_task_rate",
    "ahrs": "set_parameter_task_rate",
    "inertial": "set_parameter_task_rate",
    "analog": "set_parameter_task_rate",
    "servos_in": "set_servos_task_rate",
    "fly_by_wire": "set_servos_task_rate",
    "fms_plan": "set_fms_task_rate",
    "fms_hil_plan": "set_fms_task_rate",
    "statistics": "set_fms_task_rate",
    "gps": "set_fms_task_rate",
}
# Sent when asked for, not in a stream: they do not grow stale.
ANSWERS: Final = frozenset({"autopilot_parameters"})

KeptHealth = tuple[int, float | None, list[float], dict[str, int]]


class TopicHealth:
    """Counts of one topic. Times in seconds of any steady clock."""

    __slots__ = ("_intervals", "count", "implausible", "last_s")

    def __init__(self) -> None:
        self.count = 0
        self.last_s: float | None = None
        self.implausible: Counter[str] = Counter()
        self._intervals: deque[float] = deque(maxlen=_INTERVALS)

    def heard(self, now_s: float, implausible: Iterable[str]) -> None:
        """A sample came."""
        self.count += 1
        if self.last_s is not None:
            self._intervals.append(now_s - self.last_s)
        self.last_s = now_s
        if implausible:
            self.implausible.update(implausible)

    def kept(self) -> KeptHealth:
        """Count, time of the newest sample, newest intervals and implausible values, for `restored`."""
        return self.count, self.last_s, list(self._intervals), dict(self.implausible)

    @classmethod
    def restored(
        cls, count: int, last_s: float | None, intervals: Iterable[float], implausible: Mapping[str, int]
    ) -> TopicHealth:
        """Go on from a state that `kept` gave."""
        same = cls()
        same.count = count
        same.last_s = last_s
        same.implausible = Counter(implausible)
        same._intervals.extend(intervals)
        return same

    def forget_rate(self) -> None:
        """The rate was changed: drop the measured intervals."""
        self._intervals.clear()

    def period_s(self, commanded_s: float | None) -> float | None:
        """Time between samples: measured if there are enough intervals, else as commanded."""
        if len(self._intervals) >= _TRUSTED_INTERVALS or (self._intervals and commanded_s is None):
            return median(self._intervals)
        return commanded_s

    def stale_after_s(self, commanded_s: float | None) -> float | None:
        """Age above which the value is stale; None if unknown as yet."""
        period_s = self.period_s(commanded_s)
        return None if period_s is None else max(STALE_PERIODS * period_s, _SHORTEST_STALE_S)

    def rate_hz(self, now_s: float) -> float:
        """Samples a second now; 0 when they stopped."""
        if not self._intervals or self.last_s is None:
            return 0.0
        period_s = median(self._intervals)
        if period_s <= 0 or now_s - self.last_s > max(STALE_PERIODS * period_s, _SHORTEST_STALE_S):
            return 0.0
        return 1.0 / period_s
