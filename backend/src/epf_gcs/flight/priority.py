"""Who goes first when the processor is short: the flight process before everything that is not real-time."""

from __future__ import annotations

import os
from typing import Final, Literal

Priority = Literal["real-time", "raised", "normal"]

# The least real-time priority: before all ordinary programs, behind the system's own real-time tasks.
_REAL_TIME: Final = 1
_RAISED: Final = -10


def go_first() -> Priority:
    """Let this thread and the threads it starts later go first, as far as the system permits; returns what it got.

    Call it before any thread is started: one at normal priority that holds the interpreter when it has to give way to
    another program would delay the event loop. Processes started later inherit it too. The system itself keeps a share
    of the processor for all others. Both need a permission (Linux: CAP_SYS_NICE, or the limits rtprio and nice).
    """
    if hasattr(os, "sched_setscheduler"):
        try:
            os.sched_setscheduler(0, os.SCHED_RR, os.sched_param(_REAL_TIME))
        except OSError:
            pass
        else:
            return "real-time"
    if hasattr(os, "setpriority"):
        try:
            os.setpriority(os.PRIO_PROCESS, 0, _RAISED)
        except OSError:
            pass
        else:
            return "raised"
    return "normal"
