"""Who goes first when the processor is short: the process that flies before the one that serves pages."""

from __future__ import annotations

import contextlib
import os
from typing import Final

FLIGHT: Final = -5
WEB: Final = 5


def set_niceness(niceness: int) -> None:
    """Set this process's niceness (lower goes first), before its threads are started. Where the system does not allow
    or know it, everything stays as it is: raising one's own priority takes a permission."""
    with contextlib.suppress(AttributeError, OSError):
        os.setpriority(os.PRIO_PROCESS, 0, niceness)
