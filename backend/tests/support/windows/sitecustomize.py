"""Makes programs of ours believe that they run on Windows: read by Python at its start, from PYTHONPATH.

Our own modules see `sys.platform` as Windows says it, the names that Windows has, and not those that it lacks. Other
people's packages see the true system. What Windows would refuse is refused: handing down files, forking, signal
handlers of a loop, and programs on a loop that watches sockets.
"""

from __future__ import annotations

import asyncio
import builtins
import fcntl
import os
import signal
import socket
import subprocess
import sys
from collections.abc import Callable
from types import ModuleType
from typing import Any

LACKING = {"fcntl", "grp", "pty", "pwd", "resource", "termios", "tty", "uvloop"}


class Seen(ModuleType):
    """A module as it is on Windows."""

    def __init__(self, true: ModuleType, without: str = "", **other: Any) -> None:
        super().__init__(true.__name__)
        self.__dict__.update(other)
        self.__dict__["_true"] = true
        self.__dict__["_without"] = without.split()

    def __getattr__(self, name: str) -> Any:
        if name in self._without:
            raise AttributeError(f"{self.__name__} has no {name} on Windows")
        return getattr(self._true, name)


class Popen(subprocess.Popen[Any]):
    """Starts programs with what Windows has."""

    def __init__(self, *words: Any, creationflags: int = 0, **options: Any) -> None:
        for name in ("pass_fds", "preexec_fn", "process_group", "start_new_session", "umask", "user"):
            if name in options:
                raise ValueError(f"{name} is not supported on Windows platforms")
        super().__init__(*words, process_group=0 if creationflags else None, **options)


def locking(descriptor: int, _mode: int, count: int) -> None:
    """`msvcrt.locking`, which takes a range at the present place."""
    fcntl.lockf(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB, count, os.lseek(descriptor, 0, os.SEEK_CUR))


def refuse(*_: Any, **__: Any) -> Any:
    """What this system cannot."""
    raise NotImplementedError


MSVCRT = ModuleType("msvcrt")
MSVCRT.__dict__.update(locking=locking, LK_NBLCK=2)
OF_WINDOWS: dict[str, ModuleType] = {
    "sys": Seen(sys, platform="win32"),
    "os": Seen(
        os,
        "fdatasync fork getuid geteuid getgid killpg nice pread pwrite preadv pwritev sched_setscheduler sched_param "
        "setpriority statvfs sync uname getpriority mkfifo openpty posix_fallocate posix_fadvise",
        name="nt",
    ),
    "signal": Seen(signal, "SIGHUP SIGKILL SIGUSR1 SIGALRM", SIGBREAK=signal.SIGTERM, CTRL_BREAK_EVENT=signal.SIGTERM),
    "socket": Seen(socket, "AF_UNIX SO_REUSEPORT"),
    "subprocess": Seen(subprocess, CREATE_NEW_PROCESS_GROUP=0x200, Popen=Popen),
    "msvcrt": MSVCRT,
}
for _name in ("add_signal_handler", "_make_subprocess_transport", "connect_read_pipe", "connect_write_pipe"):
    setattr(asyncio.SelectorEventLoop, _name, refuse)

_true_import: Callable[..., Any] = builtins.__import__


def _import(name: str, globals: Any = None, locals: Any = None, fromlist: Any = (), level: int = 0) -> Any:  # noqa: A002
    if level == 0 and (globals or {}).get("__package__", "").startswith("epf_gcs"):
        if name in LACKING:
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)
        if name in OF_WINDOWS:
            return OF_WINDOWS[name]
    return _true_import(name, globals, locals, fromlist, level)


builtins.__import__ = _import
