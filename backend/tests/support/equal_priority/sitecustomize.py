"""Lets no program of ours lower its own priority: read by Python at its start, from PYTHONPATH.

A test that waits for a worker of the lowest priority would wait as long as other work keeps every core busy. Tests of
the priority itself do without.
"""

from __future__ import annotations

import os

_true_setpriority = os.setpriority


def keep_niceness(_increment: int) -> int:
    """As `os.nice`, without any change."""
    return os.getpriority(os.PRIO_PROCESS, 0)


def only_raise(which: int, who: int, priority: int) -> None:
    """As `os.setpriority`, for what does not lower it."""
    if priority <= os.getpriority(which, who):
        _true_setpriority(which, who, priority)


os.nice = keep_niceness
os.setpriority = only_raise
