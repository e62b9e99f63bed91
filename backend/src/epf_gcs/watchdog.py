"""Finds a process that hangs: it writes a byte to a pipe twice a second, and its parent misses them."""

from __future__ import annotations

import asyncio
import contextlib
import os
import subprocess
import sys
from collections.abc import Callable
from typing import Final

from epf_gcs.system.pipes import PipeReader

FEED_S: Final = 0.5
# Longer than any pause of a slow computer that still works: a restart costs a flight more than a pause.
SILENT_S: Final = 8.0
# A process that is starting reads its modules from the disk and may repair a recording first.
STARTING_S: Final = 120.0
# Exit status (EX_CONFIG) of a process that was asked for something impossible: started again it would say the same.
REFUSED: Final = 78
_LOOK_S: Final = 0.5


async def feed(descriptor: int) -> None:
    """The child's part, on its event loop until cancelled: a loop that hangs falls silent."""
    os.set_inheritable(descriptor, False)
    if sys.platform != "win32":
        os.set_blocking(descriptor, False)
    while True:
        # A parent that does not read, or has died, is not this process's trouble here.
        with contextlib.suppress(BlockingIOError, BrokenPipeError):
            os.write(descriptor, b".")
        await asyncio.sleep(FEED_S)


def wait_for_end(
    process: subprocess.Popen[bytes], descriptor: int, silent_s: float, on_hung: Callable[[], None]
) -> int:
    """The parent's part: wait until `process` has ended, kill it once it is silent for `silent_s`; its exit status.

    `descriptor` is the end of the pipe to read, whose other end only the child holds. `on_hung` is called before the
    kill. Only time in which this process itself ran counts: a paused container does not look like a child that hangs.
    """
    reader = PipeReader(descriptor)
    looks, most = 0, STARTING_S
    while True:
        signs = reader.within(_LOOK_S)
        if signs is not None:
            if not signs:
                return process.wait()
            looks, most = 0, silent_s
            continue
        looks += 1
        if looks * _LOOK_S >= most:
            on_hung()
            process.kill()
            return process.wait()
