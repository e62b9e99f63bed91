"""The time from a simulator frame sent to the board until its answer. Frames carry no number to match the two by."""

from __future__ import annotations

from collections import deque
from typing import Final

from epf_gcs.contract.status import RoundTripMs

_KEPT: Final = 512
# A question unanswered for this long was lost on the line: the loop itself counts as lost at 250 ms.
_FORGET_S: Final = 0.5


class RoundTrip:
    """Pairs questions (frames to the board) and answers in order. Lost ones are found by the gap that they leave.

    A lost frame would shift every later pair by one. So a gap of several periods between two answers removes the
    questions that were lost in it, and a question older than half a second is dropped.
    """

    def __init__(self) -> None:
        self._asked: deque[float] = deque(maxlen=64)
        self._answers_ms: deque[float] = deque(maxlen=_KEPT)
        self._last_answer_s: float | None = None
        self._period_s = 0.0
        self.answers = 0
        self._last_asked_s: float | None = None

    def asked(self, now_s: float) -> None:
        """A frame went to the board."""
        if self._last_asked_s is not None:
            self._period_s = now_s - self._last_asked_s
        self._last_asked_s = now_s
        self._asked.append(now_s)

    def answered(self, now_s: float, *, is_counted: bool = True) -> None:
        """An answer came: pair it with the oldest open question; figures leave out what is not counted."""
        while self._asked and now_s - self._asked[0] > _FORGET_S:
            self._asked.popleft()
        for _ in range(self._lost_before(now_s)):
            if len(self._asked) > 1:
                self._asked.popleft()
        self._last_answer_s = now_s
        if self._asked:
            asked_s = self._asked.popleft()
            if is_counted:
                self.answers += 1
                self._answers_ms.append((now_s - asked_s) * 1000.0)

    @property
    def newest_ms(self) -> float | None:
        """The newest answer's; None before the first."""
        return self._answers_ms[-1] if self._answers_ms else None

    def clear(self) -> None:
        """The loop was opened: drop the open questions and the statistics."""
        self._asked.clear()
        self._answers_ms.clear()
        self._last_answer_s = self._last_asked_s = None
        self.answers = 0

    def summary(self) -> RoundTripMs:
        """Newest, median and 99th percentile."""
        if not self._answers_ms:
            return RoundTripMs()
        ordered = sorted(self._answers_ms)
        last = len(ordered) - 1
        return RoundTripMs(self._answers_ms[-1], ordered[last // 2], ordered[round(last * 0.99)])

    def _lost_before(self, now_s: float) -> int:
        if self._last_answer_s is None or self._period_s <= 0:
            return 0
        return max(0, round((now_s - self._last_answer_s) / self._period_s) - 1)
