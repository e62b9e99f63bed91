"""Who goes first when the processor is short: the flight process before everything that is not real-time."""

from __future__ import annotations

import contextlib
import ctypes
import os
import sys
import threading
from collections.abc import Callable
from typing import Final, Literal

from epf_gcs.system.limits import may_lock_memory

Priority = Literal["real-time", "raised", "normal"]

# The least real-time priority: before all ordinary programs, behind the system's own real-time tasks.
_REAL_TIME: Final = 1
_RAISED: Final = -10
_LOWEST: Final = 19
WAITED_FOR: Final = 5
"""Niceness of a program that somebody waits for: behind the flight and every ordinary program, but not starved by the
browser beside it, as the lowest is."""
# Linux's flags of mlockall(2).
_LOCK_NOW: Final = 1
_LOCK_LATER: Final = 2
_LOCK_ON_USE: Final = 4
# Linux's system call ioprio_set on these processors, its "this process" and the class "only while nobody else reads".
_IOPRIO_SET: Final = {"x86_64": 251, "aarch64": 30, "armv7l": 314, "riscv64": 30}
_THIS_PROCESS: Final = 1
_IDLE: Final = 3 << 13


def go_first() -> Priority:
    """Let this thread and the threads it starts later go first, as far as the system permits; returns what it got.

    Call it before any thread is started: one at normal priority that holds the interpreter when it has to give way to
    another program would delay the event loop. A program started later would inherit it (Linux's reset on fork is no
    help: it takes it from later threads too), so the flight process starts none. The system itself keeps a share of the
    processor for all others. Both need a permission (Linux: CAP_SYS_NICE, or the limits rtprio and nice).
    """
    if sys.platform == "linux":
        with contextlib.suppress(OSError):
            os.sched_setscheduler(0, os.SCHED_RR, os.sched_param(_REAL_TIME))
            return "real-time"
    if sys.platform != "win32":
        with contextlib.suppress(OSError):
            os.setpriority(os.PRIO_PROCESS, 0, _RAISED)
            return "raised"
    return "normal"


def take_own_core() -> None:
    """Let this thread and those it starts run on the flight's core alone; with a single core nothing changes.

    For a process with real-time priority: all others give way to it there, but while one of them is inside the kernel
    that can take milliseconds (Linux without kernel preemption). Those that are ours keep away (`leave_flight_core`).
    """
    _run_on(lambda flight, _others: {flight})


def leave_flight_core() -> None:
    """Let this thread, and the threads and programs it starts, run on any core but the flight's; as `take_own_core`."""
    _run_on(lambda _flight, others: others)


def _run_on(choose: Callable[[int, set[int]], set[int]]) -> None:
    """The flight's core is the last of those that this process may use: the first has most of the interrupts."""
    if sys.platform == "linux":
        cores = os.sched_getaffinity(0)
        flight = max(cores)
        if others := cores - {flight}:
            with contextlib.suppress(OSError):
                os.sched_setaffinity(0, choose(flight, others))


def stay_in_memory() -> bool:
    """Keep every page that this process uses out of the swap, where nothing limits that; whether it does.

    Pages are locked when they are first used (MCL_ONFAULT), so that a thread's unused stack costs nothing. Under a
    limit it is left alone: the first allocation beyond the limit would fail.
    """
    if sys.platform == "linux" and may_lock_memory():
        with contextlib.suppress(AttributeError, OSError):
            return bool(ctypes.CDLL(None).mlockall(_LOCK_NOW | _LOCK_LATER | _LOCK_ON_USE) == 0)
    return False


def go_last() -> None:
    """Let the calling thread give way to all others, as far as the system can: no real time, the lowest niceness.

    For work that takes long and that no flight waits for. It must hold the interpreter for moments only.
    """
    if sys.platform == "linux":
        with contextlib.suppress(OSError):
            os.sched_setscheduler(0, os.SCHED_OTHER, os.sched_param(0))
        with contextlib.suppress(OSError):
            os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), _LOWEST)


def be_nice(niceness: int = _LOWEST) -> None:
    """Let this process take the processor only while nobody else wants it."""
    if sys.platform != "win32":
        with contextlib.suppress(OSError):
            os.nice(niceness)


def slow_down(process: int, niceness: int = _LOWEST) -> None:
    """As `be_nice`, for another process of this user that has just been started and has no threads yet."""
    if sys.platform != "win32":
        with contextlib.suppress(OSError):
            before = os.getpriority(os.PRIO_PROCESS, process)
            os.setpriority(os.PRIO_PROCESS, process, min(before + niceness, _LOWEST))


def read_last() -> None:
    """Let this process use the disk only while nobody else does."""
    if sys.platform == "linux":
        with contextlib.suppress(AttributeError, OSError, KeyError):
            ctypes.CDLL(None).syscall(_IOPRIO_SET[os.uname().machine], _THIS_PROCESS, 0, _IDLE)
