"""One program of the demonstration: started in its own process group, logged, and stopped, by force if it hangs."""

import contextlib
import os
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Final

from epf_gcs.launcher.errors import LaunchError
from epf_gcs.system.processes import ask_group_to_end, kill_group, started

STOP_TIMEOUT_S: Final = 5.0
_TAIL_LINES: Final = 8
_TAIL_BYTES: Final = 4096
MOST_LOG_BYTES: Final = 5_000_000


class Child:
    """A child process by pid. Its output goes to `<name>.log`, older output to `<name>.1.log`."""

    def __init__(
        self,
        name: str,
        command: Sequence[str],
        logs: Path,
        again: Sequence[str] | None = None,
        variables: Mapping[str, str] | None = None,
    ) -> None:
        """`again` is the command of every restart, if it differs from that of the first start; `variables` are for the
        program beside our own."""
        self.name = name
        self._command = tuple(command)
        self._variables = {**os.environ, **(variables or {})}
        self._again = self._command if again is None else tuple(again)
        self.log_path = logs / f"{name}.log"
        self._older_log_path = logs / f"{name}.1.log"
        self._process: subprocess.Popen[bytes] | None = None
        if self.log_path.exists():
            self.log_path.replace(self._older_log_path)

    def start(self) -> None:
        """Start the program; raises LaunchError if it cannot be run at all."""
        command = self._command if self._process is None else self._again
        # Append, so that what a program logged before it died stays after its restart.
        with self.log_path.open("ab") as log:
            try:
                # A terminal's Ctrl-C must not reach it: the launcher stops the programs in their order.
                self._process = started(command, log=log, environment=self._variables)
            except OSError as error:
                raise LaunchError(f"The {self.name} ({command[0]}) cannot be started: {error.strerror}.") from error

    @property
    def pid(self) -> int | None:
        """Process number, None before the first start."""
        return self._process.pid if self._process else None

    @property
    def ended(self) -> int | None:
        """Exit status once it has ended (negative: the signal), None while it runs or was never started."""
        return self._process.poll() if self._process else None

    def stop(self, timeout_s: float = STOP_TIMEOUT_S) -> bool:
        """Stop the process group, by SIGKILL if it hangs; returns False if it had to be killed."""
        if self._process is None:
            return True
        ask_group_to_end(self._process)
        try:
            self._process.wait(timeout_s)
        except subprocess.TimeoutExpired:
            kill_group(self._process)
            self._process.wait()
            return False
        # The program is gone, but a process that it started may still be there.
        kill_group(self._process)
        return True

    def turn_log_over(self, most_bytes: int = MOST_LOG_BYTES) -> None:
        """If the log is larger than this, copy its newest part to the older log and empty it.

        The program keeps the same file open for appending, so it continues at the start of the emptied file.
        """
        with contextlib.suppress(OSError):
            if self.log_path.stat().st_size <= most_bytes:
                return
            with self.log_path.open("r+b") as log:
                log.seek(-most_bytes, os.SEEK_END)
                part = self._older_log_path.with_suffix(".part")
                part.write_bytes(log.read(most_bytes))
                part.replace(self._older_log_path)
                log.truncate(0)

    def last_lines(self) -> str:
        """The end of its log, to be shown after it failed."""
        with contextlib.suppress(OSError):
            with self.log_path.open("rb") as log:
                log.seek(max(0, self.log_path.stat().st_size - _TAIL_BYTES))
                lines = log.read().decode(errors="replace").splitlines()
            return "\n".join(f"    {line}" for line in lines[-_TAIL_LINES:])
        return ""
