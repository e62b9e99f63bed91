"""Keeps the processor's cores from falling asleep while something is timed."""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
from collections.abc import Iterator
from typing import Final

_SPIN: Final = """
import os, sys
os.sched_setscheduler(0, os.SCHED_IDLE, os.sched_param(0))
os.sched_setaffinity(0, {int(sys.argv[1])})
parent = os.getppid()
while os.getppid() == parent:
    for _ in range(100_000):
        pass
"""


@contextlib.contextmanager
def awake() -> Iterator[None]:
    """On each core a program runs that gives way to every other: no time is lost on waking a core.

    Waking one takes 5 to 50 us on a machine of its own, and 0.1 to 0.3 ms in a virtual one, whose host lends the core
    to others meanwhile. How often that happens says something of the machine, not of what is timed.
    """
    spinners = [subprocess.Popen([sys.executable, "-c", _SPIN, str(core)]) for core in os.sched_getaffinity(0)]
    try:
        yield
    finally:
        for spinner in spinners:
            spinner.kill()
        for spinner in spinners:
            spinner.wait()
