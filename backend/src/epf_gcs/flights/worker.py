"""What every worker program is: of the lowest priority, limited, told to stop by SIGTERM, gone with its parent.

It says how far it is as JSON lines on standard output: {"progress": 0 to 1, "doing": word} as often as it likes, then
one of {"done": {...}} and {"fault": {"code", "detail", "params"}}.
"""

from __future__ import annotations

import contextlib
import os
import queue
import signal
import threading
from collections.abc import Callable, Mapping
from typing import Final

from epf_gcs.errors import GatewayError
from epf_gcs.system.limits import limit_memory, limit_time
from epf_gcs.system.priority import WAITED_FOR, be_nice, read_last
from epf_gcs.workers.lines import tell, tell_fault

_MOST_MEMORY_BYTES: Final = 4_000_000_000
_MOST_CPU_S: Final = 3600
# How long a cancelled worker may take to remove its half-written files.
_GRACE_S: Final = 2.0

_first_line: Final[queue.SimpleQueue[str]] = queue.SimpleQueue()

Say = Callable[[float, str], None]
Run = Callable[[list[str], Say], Mapping[str, object]]
"""A verb's work; what it answers is a `JobAnswer` of the library."""


class Cancellation(BaseException):
    """The worker was told to stop: not an error, and not to be caught by `except Exception`."""


def be_modest(most_cpu_s: int | None = _MOST_CPU_S, *, is_waited_for: bool = False) -> None:
    """Take processor and disk only while nobody else wants them, and limit memory and processor time.

    With None the processor time is not limited. One whose answer somebody waits for comes before the background.
    """
    if is_waited_for:
        be_nice(WAITED_FOR)
    else:
        be_nice()
    read_last()
    limit_memory(_MOST_MEMORY_BYTES)
    if most_cpu_s is not None:
        limit_time(most_cpu_s)


def end_with_parent() -> None:
    """End when standard input closes, as it does when the parent dies, however it dies."""
    threading.Thread(target=_wait_for_parent, name="parent", daemon=True).start()


def work(run: Run, arguments: list[str]) -> int:
    """Run a verb to its end and say how it ended; returns the exit code of the process."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C reaches all programs of a terminal: the parent ends this one
    signal.signal(signal.SIGTERM, _cancel)
    be_modest()
    end_with_parent()
    try:
        tell({"done": run(arguments, say)})
    except GatewayError as error:
        tell_fault(error)
    except MemoryError:
        tell_fault(GatewayError("job_failed", "It needs more memory than a flight may take.", why="memory"))
    except OSError as error:
        why = error.strerror or str(error)
        detail = f"The flights' folder could not be changed ({why}): free the disk or correct its permissions."
        tell_fault(GatewayError("flight_not_written", detail, why=why))
    except Cancellation:
        return 128 + signal.SIGTERM
    else:
        return 0
    return 1


def secret() -> str:
    """The line that the parent wrote to standard input, where no other user sees it. Waits for it."""
    return _first_line.get()


def say(progress: float, doing: str) -> None:
    """Say how far the work is: 0 to 1, and a stable word for the step."""
    tell({"progress": round(min(1.0, max(0.0, progress)), 4), "doing": doing})


def _cancel(_number: int, _frame: object) -> None:
    # Once: told to stop and left by its parent in the same moment, it would break off its own clearing up.
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    raise Cancellation


def _wait_for_parent() -> None:
    line = bytearray()
    with contextlib.suppress(OSError):
        while read := os.read(0, 1):
            if read == b"\n":
                _first_line.put(line.decode())
                line.clear()
            else:
                line += read
    # As when cancelled, so that no half-written file stays; then in any case.
    os.kill(os.getpid(), signal.SIGTERM)
    threading.Event().wait(_GRACE_S)
    os._exit(1)
