"""Starting and ending other programs: they do not hear a terminal's Ctrl-C, nor outlive the one that started them."""

from __future__ import annotations

import contextlib
import ctypes
import os
import signal
import subprocess
import sys
from collections.abc import Sequence
from typing import IO, Any, Final

_PR_SET_PDEATHSIG: Final = 1
_STDOUT: Final = 1

HANDS_DOWN: Final = sys.platform != "win32"
"""Whether programs inherit open files under the same numbers."""

if sys.platform == "win32":

    def own_group() -> dict[str, Any]:
        """Options of `subprocess.Popen` for a program that a terminal's Ctrl-C does not reach."""
        return {"creationflags": subprocess.CREATE_NEW_PROCESS_GROUP}

    def ask_to_end(process: subprocess.Popen[bytes]) -> None:
        """Ask a program of `own_group` to end; it hears SIGBREAK."""
        with contextlib.suppress(OSError):
            process.send_signal(signal.CTRL_BREAK_EVENT)

    def kill_group(process: subprocess.Popen[bytes]) -> None:
        """End a program at once."""
        with contextlib.suppress(OSError):
            process.kill()

    def ask_group_to_end(process: subprocess.Popen[bytes]) -> None:
        """Ask a program of `own_group`, and what it started, to end."""
        ask_to_end(process)

    def with_pipe(descriptor: int, _files: Sequence[int]) -> tuple[int, dict[str, Any]]:
        """Options of `subprocess.Popen` for a program that writes to this pipe, and the number that it knows it by.

        Open files cannot be handed down there under their numbers: the pipe is its standard output, and it gets no
        `files` (`HANDS_DOWN`).
        """
        return _STDOUT, {"stdout": descriptor}

else:

    def own_group() -> dict[str, Any]:
        """Options of `subprocess.Popen` for a program that a terminal's Ctrl-C does not reach."""
        return {"process_group": 0}

    def ask_to_end(process: subprocess.Popen[bytes]) -> None:
        """Ask a program of `own_group` to end; it hears SIGTERM."""
        with contextlib.suppress(ProcessLookupError):
            process.send_signal(signal.SIGTERM)

    def kill_group(process: subprocess.Popen[bytes]) -> None:
        """End a program of `own_group`, and what it started, at once."""
        _signal_group(process, signal.SIGKILL)

    def ask_group_to_end(process: subprocess.Popen[bytes]) -> None:
        """Ask a program of `own_group`, and what it started, to end."""
        _signal_group(process, signal.SIGTERM)

    def with_pipe(descriptor: int, files: Sequence[int]) -> tuple[int, dict[str, Any]]:
        """Options of `subprocess.Popen` for a program that writes to this pipe, and the number that it knows it by.

        It inherits `files` too, under the same numbers.
        """
        return descriptor, {"pass_fds": (*files, descriptor)}

    def _signal_group(process: subprocess.Popen[bytes], number: signal.Signals) -> None:
        # The group may be gone; the process itself is not reaped before `poll`, so its number is not another's.
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(process.pid, number)


def ending_with_us() -> dict[str, Any]:
    """Options of `subprocess.Popen` for a program that the system ends when this one is killed; only Linux can.

    Only for a program with one thread.
    """
    if sys.platform != "linux":
        return {}
    prctl = ctypes.CDLL(None).prctl
    return {"preexec_fn": lambda: prctl(_PR_SET_PDEATHSIG, signal.SIGTERM)}


def started(command: Sequence[str], *, log: IO[bytes], environment: dict[str, str]) -> subprocess.Popen[bytes]:
    """A program of its own group whose output goes to `log`, and that ends with us. Raises OSError."""
    return subprocess.Popen(
        command,
        env=environment,
        stdin=subprocess.DEVNULL,
        stdout=log,
        stderr=subprocess.STDOUT,
        **own_group(),
        **ending_with_us(),
    )
