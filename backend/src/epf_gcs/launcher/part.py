"""One of the gateway's two processes: started, watched, and started again when it dies or hangs."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import time
from collections.abc import Sequence
from typing import Final

from epf_gcs.system.processes import ask_to_end, own_group, with_pipe
from epf_gcs.watchdog import REFUSED, SILENT_S, wait_for_end

# The first restart is immediate, because the aircraft may be in flight; repeated ones wait longer, up to this.
_LONGEST_WAIT_S: Final = 5.0
_LIVED_S: Final = 10.0


def environment() -> dict[str, str]:
    """Of the processes: as it is when they start, for the config file adds to it after this module was imported.

    The board of the command line is told to the first flight process alone: one that is started again in flight opens
    what was open, which may be another one by then.
    """
    return {name: value for name, value in os.environ.items() if name != "GCS_BOARD"}


class Part:
    """One of the two processes. `again` is the command of every restart; `silent_s` is told in `watchdog.py`."""

    def __init__(
        self,
        name: str,
        command: Sequence[str],
        again: Sequence[str],
        stdin: int,
        *,
        files: Sequence[int] = (),
        silent_s: float = SILENT_S,
    ) -> None:
        self.name = name
        self._command = tuple(command)
        self._again = tuple(again)
        self._stdin = stdin
        self._files = tuple(files)
        self._silent_s = silent_s
        self._quick_deaths = 0
        self.process: subprocess.Popen[bytes] | None = None

    def keep_running(self, stopping: threading.Event) -> int | None:
        """Start it again whenever it dies or hangs, until `stopping`. Returns its exit status if it refused."""
        is_first = True
        while not stopping.is_set():
            began_s = time.monotonic()
            code = self._run(self._command if is_first else self._again)
            if stopping.is_set():
                return None
            has_lived = time.monotonic() - began_s > _LIVED_S
            if is_first and (code == REFUSED or (code > 0 and not has_lived)):
                return code
            is_first = False
            how = f"by signal {-code}" if code < 0 else f"with status {code}"
            print(f"epf-gcs: the {self.name} process ended {how} and is started again.", file=sys.stderr, flush=True)
            stopping.wait(self._wait_s(has_lived=has_lived))
        return None

    def end(self, *, by_force: bool) -> None:
        """Ask it to end, or end it, if it runs."""
        if self.process is not None and self.process.poll() is None:
            if by_force:
                self.process.kill()
            else:
                ask_to_end(self.process)

    def _run(self, command: Sequence[str]) -> int:
        # Only we hold the write end of its standard input, so it notices when we die, and ends. A process group of its
        # own: a terminal's Ctrl-C reaches only us, and we end both in order.
        watched, fed = os.pipe()
        try:
            number, options = with_pipe(fed, self._files)
            self.process = subprocess.Popen(
                [*command, "--watchdog", str(number)],
                stdin=self._stdin,
                env=environment(),
                **own_group(),
                **options,
            )
        finally:
            os.close(fed)
        try:
            return wait_for_end(self.process, watched, self._silent_s, self._report_hung)
        finally:
            os.close(watched)

    def _report_hung(self) -> None:
        print(f"epf-gcs: the {self.name} process hangs and is killed.", file=sys.stderr, flush=True)

    def _wait_s(self, *, has_lived: bool) -> float:
        self._quick_deaths = 1 if has_lived else self._quick_deaths + 1
        return 0.0 if self._quick_deaths <= 1 else min(_LONGEST_WAIT_S, 0.1 * 2.0**self._quick_deaths)
