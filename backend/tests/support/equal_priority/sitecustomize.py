"""Lets no program of ours lower its own priority: read by Python at its start, from PYTHONPATH.

A test that waits for a worker of the lowest priority would wait as long as other work keeps every core busy. Tests of
the priority itself do without.
"""

from __future__ import annotations

import os
from typing import Any

_true_setpriority = os.setpriority


def keep_niceness(_increment: int) -> int:
    """As `os.nice`, without any change."""
    return os.getpriority(os.PRIO_PROCESS, 0)


def only_raise(which: int, who: int, niceness: int) -> Any:
    """As `os.setpriority`, for what does not lower it."""
    if niceness <= os.getpriority(which, who):
        _true_setpriority(which, who, niceness)


os.nice = keep_niceness
os.setpriority = only_raise
