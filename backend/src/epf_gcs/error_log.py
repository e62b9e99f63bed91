"""Everything that went wrong, counted by kind; and told to the viewers, but not over and over."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from typing import Final

from epf_gcs.errors import GatewayError

# A bad line makes hundreds of the same complaint a second: the count says how many, one sentence is enough.
_QUIET_S: Final = 10.0


class ErrorLog:
    """`counts` is part of the status. Viewers get at most one event of each kind in ten seconds, from `tell_viewers`
    on."""

    def __init__(self) -> None:
        self.counts: Counter[str] = Counter()
        self._steady_s: Callable[[], float] = lambda: 0.0
        self._tell: Callable[[GatewayError, int], None] = lambda _error, _count: None
        self._told_s: dict[str, float] = {}

    def tell_viewers(self, steady_s: Callable[[], float], tell: Callable[[GatewayError, int], None]) -> None:
        """There are viewers to tell now: the error and how often it came; `steady_s`: any clock that is never set."""
        self._steady_s = steady_s
        self._tell = tell

    def count(self, code: str) -> None:
        """One more of this kind; whoever caused it was told by an answer of its own."""
        self.counts[code] += 1

    def report(self, error: GatewayError) -> None:
        """One more of this kind, from a line that cannot be answered: the viewers are told."""
        self.counts[error.code] += 1
        now_s = self._steady_s()
        if now_s - self._told_s.get(error.code, -_QUIET_S) < _QUIET_S:
            return
        self._told_s[error.code] = now_s
        self._tell(error, self.counts[error.code])
