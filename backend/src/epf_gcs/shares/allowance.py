"""A token bucket: a mean rate per second, with short bursts."""

from __future__ import annotations


class Allowance:
    """`per_s`: mean rate. `at_once`: largest burst, available from the start."""

    def __init__(self, per_s: float, at_once: float) -> None:
        self._per_s = per_s
        self._at_once = at_once
        self._left = at_once
        self._looked_s: float | None = None

    def take(self, now_s: float, count: float = 1.0) -> bool:
        """Take so many tokens at this time (any steady clock, in s); False if fewer are left."""
        if self._looked_s is not None:
            self._left = min(self._at_once, self._left + (now_s - self._looked_s) * self._per_s)
        self._looked_s = now_s
        if self._left < count:
            return False
        self._left -= count
        return True
