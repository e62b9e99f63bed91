"""When something ends, also where the system's time is set meanwhile, as on a computer without a clock of its own."""

from __future__ import annotations

import time
from functools import lru_cache
from pathlib import Path
from typing import Final, NamedTuple

_BOOT: Final = Path("/proc/sys/kernel/random/boot_id")


class Moment(NamedTuple):
    """Unix seconds, seconds of the steady clock that all processes of this computer share, and since which of its
    starts that one counts (empty where the system does not tell)."""

    unix_s: float
    steady_s: float
    boot: str

    @classmethod
    def now(cls, unix_s: float | None = None) -> Moment:
        """This moment; `unix_s` where another clock than the system's is followed."""
        return cls(time.time() if unix_s is None else unix_s, time.monotonic(), _boot())

    def later(self, seconds: float) -> Moment:
        """So many seconds after it."""
        return Moment(self.unix_s + seconds, self.steady_s + seconds, self.boot)

    def left_s(self, now: Moment) -> float:
        """Seconds from `now` until this moment, 0 or less once it is over. The steady clock decides as long as the
        computer has not started again, the system's time after that."""
        if self.boot and self.boot == now.boot:
            return self.steady_s - now.steady_s
        return self.unix_s - now.unix_s


@lru_cache(maxsize=1)
def _boot() -> str:
    try:
        return _BOOT.read_text("ascii").strip()
    except OSError:
        return ""
