"""One clock for everything that is stamped: Unix seconds that never jump."""

from __future__ import annotations

import time


class Clock:
    """Wall time at the start plus monotonic time since: comparable with other logs, and never set back."""

    def __init__(self) -> None:
        self._offset_ns = time.time_ns() - time.monotonic_ns()

    @property
    def offset_ns(self) -> int:
        """Unix nanoseconds minus the system's steady clock."""
        return self._offset_ns

    def follow(self, offset_ns: int) -> None:
        """Take over another process's offset, so that both stamp alike even where the system's time was set between
        their starts. The steady clock is the same for all processes of a machine."""
        self._offset_ns = offset_ns

    def now_ns(self) -> int:
        """Unix nanoseconds."""
        return self._offset_ns + time.monotonic_ns()

    def steady_s(self) -> float:
        """Seconds since some time or other, for measuring. The event loop's own clock counts whole milliseconds."""
        return time.monotonic()

    def unix_ns(self, steady_ns: int) -> int:
        """Unix nanoseconds of a moment of the system's steady clock."""
        return self._offset_ns + steady_ns

    def now_s(self) -> float:
        """Unix seconds."""
        return (self._offset_ns + time.monotonic_ns()) * 1e-9
