"""Slows down whoever shows wrong keys: a delay that grows with the failures of an address, a limit for all together.

Pure: told the time. A right key is not asked about here: it enters at once, whatever others try.
"""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import dataclass
from typing import Final

from epf_gcs.shares.holder import group_of

FREE_FAILURES: Final = 4
"""Slips of the pen that cost nothing."""
LONGEST_S: Final = 300.0
FORGOTTEN_S: Final = 3600.0
MOST_ADDRESSES: Final = 4096
TRIES_PER_S: Final = 2.0
TRIES_AT_ONCE: Final = 30.0
"""Tries of all addresses together: so many at once, then so many a second."""


@dataclass(slots=True)
class _Failures:
    count: int
    last_s: float
    until_s: float


class GuessLimiter:
    """`now_s` is a steady clock's."""

    def __init__(self) -> None:
        self._of: OrderedDict[str, _Failures] = OrderedDict()
        self._tries = TRIES_AT_ONCE
        self._tries_s = 0.0

    def failed(self, address: str, now_s: float) -> float:
        """Count a failure of this address: 0, or the seconds until it is answered again."""
        key = group_of(address)
        failures = self._of.get(key)
        if failures is not None and failures.until_s > now_s:
            return failures.until_s - now_s
        self._tries = min(TRIES_AT_ONCE, self._tries + max(0.0, now_s - self._tries_s) * TRIES_PER_S)
        self._tries_s = now_s
        if self._tries < 1.0:
            return (1.0 - self._tries) / TRIES_PER_S
        self._tries -= 1.0
        count = 1 if failures is None or now_s - failures.last_s > FORGOTTEN_S else failures.count + 1
        delay_s = 0.0 if count < FREE_FAILURES else min(LONGEST_S, 2.0 ** min(count - FREE_FAILURES, 16))
        self._of[key] = _Failures(count, now_s, now_s + delay_s)
        self._of.move_to_end(key)
        if len(self._of) > MOST_ADDRESSES:
            self._of.popitem(last=False)
        return 0.0
