"""So many in a second on average, and a few more at once."""

from __future__ import annotations


class Allowance:
    """Told the time. Full when it is made."""

    def __init__(self, per_s: float, at_once: float) -> None:
        self._per_s = per_s
        self._at_once = at_once
        self._left = at_once
        self._looked_s: float | None = None

    def take(self, now_s: float) -> bool:
        """Take one; False where none is left."""
        if self._looked_s is not None:
            self._left = min(self._at_once, self._left + (now_s - self._looked_s) * self._per_s)
        self._looked_s = now_s
        if self._left < 1.0:
            return False
        self._left -= 1.0
        return True
