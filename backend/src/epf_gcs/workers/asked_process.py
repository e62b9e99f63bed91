"""A worker process that is asked one thing after the other, started at the first and again after it ended."""

from __future__ import annotations

import contextlib
import subprocess
import sys
import threading
import time
from typing import BinaryIO, Final, cast

from epf_gcs.workers.pipe import receive, send

_LONGEST_START_S: Final = 60.0


class AskedProcess:
    """`python -m PROGRAM ARGUMENTS`. One thread asks at a time; any other may end it.

    The program greets with an empty message when it is ready, so that no request is blamed for a slow start.
    """

    def __init__(self, *program: str) -> None:
        self._program = program
        self._process: subprocess.Popen[bytes] | None = None
        self._until_s: float | None = None
        self._lock = threading.Lock()

    @property
    def is_running(self) -> bool:
        """Whether the process was started and is alive."""
        return self._process is not None and self._process.poll() is None

    def ask(self, asked: object, longest_s: float) -> tuple[bytes, bytes] | None:
        """The answer, its head as JSON; None if the process died of the request."""
        process = self._process
        if process is None or process.poll() is not None:
            self.end()
            process = self._start()
        self._until_s = time.monotonic() + longest_s
        try:
            send(cast(BinaryIO, process.stdin), asked)
            answer = receive(cast(BinaryIO, process.stdout))
        except (OSError, ValueError):
            answer = None
        with self._lock:
            self._until_s = None
        if answer is None:
            self.end()
        return answer

    def end_if_late(self) -> None:
        """Kill the process if its request is overdue. Called by another thread than `ask`."""
        with self._lock:
            if self._until_s is not None and time.monotonic() > self._until_s and self._process is not None:
                self._process.kill()

    def end(self) -> None:
        """Kill the process; the next `ask` starts a new one."""
        process, self._process = self._process, None
        if process is None:
            return
        process.kill()
        for pipe in (process.stdin, process.stdout):
            if pipe is not None:
                with contextlib.suppress(OSError):
                    pipe.close()
        process.wait()

    def _start(self) -> subprocess.Popen[bytes]:
        process = subprocess.Popen(
            [sys.executable, "-m", *self._program], stdin=subprocess.PIPE, stdout=subprocess.PIPE
        )
        self._process = process
        self._until_s = time.monotonic() + _LONGEST_START_S
        with contextlib.suppress(OSError, ValueError):
            receive(cast(BinaryIO, process.stdout))  # without a greeting the request fails, and says so
        return process
