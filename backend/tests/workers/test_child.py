"""Programs that the web process starts: none outlives the work that needed it."""

from __future__ import annotations

import asyncio
import os
import sys
from collections.abc import Coroutine
from pathlib import Path
from typing import Any

import pytest

from epf_gcs.system.loops import new_loop
from epf_gcs.workers.child import child

_PIPE = asyncio.subprocess.PIPE
# Says that it is there, and takes no notice of being told to end.
_STUBBORN = "import signal, time; signal.signal(signal.SIGTERM, signal.SIG_IGN); print(flush=True); time.sleep(60)"
_POLITE = (
    "import signal, sys, time; signal.signal(signal.SIGTERM, lambda *_: sys.exit(7)); print(flush=True); time.sleep(60)"
)


def _run(work: Coroutine[Any, Any, None]) -> None:
    with asyncio.Runner(loop_factory=new_loop) as runner:
        runner.run(work)


def _is_there(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True


def test_whoever_is_cancelled_again_and_again_still_waits_for_the_end_of_the_program() -> None:
    async def work() -> None:
        pids: asyncio.Queue[int] = asyncio.Queue()

        async def user() -> None:
            async with child(sys.executable, "-c", _STUBBORN, grace_s=0.3, stdout=_PIPE) as process:
                assert process.stdout is not None
                await process.stdout.readline()
                pids.put_nowait(process.pid)
                await process.wait()

        task = asyncio.create_task(user())
        pid = await pids.get()
        while not task.done():
            task.cancel()
            await asyncio.sleep(0.01)
        with pytest.raises(asyncio.CancelledError):
            await task
        assert not _is_there(pid)

    _run(work())


def test_who_is_cancelled_while_the_program_starts_leaves_none_behind() -> None:
    async def work() -> None:
        async def user() -> None:
            async with child(sys.executable, "-c", "import time; time.sleep(60)"):
                pytest.fail("it was cancelled before")

        task = asyncio.create_task(user())
        await asyncio.sleep(0)  # it has asked for the program
        await asyncio.sleep(0)
        task.cancel()
        with pytest.raises(asyncio.CancelledError):
            await task

    before = _children()
    _run(work())
    assert _children() == before


def test_a_program_that_ends_when_told_is_not_killed() -> None:
    async def work() -> None:
        async with child(sys.executable, "-c", _POLITE, grace_s=20.0, stdout=_PIPE) as process:
            assert process.stdout is not None
            await process.stdout.readline()
        assert process.returncode == 7

    _run(work())


def test_a_program_that_cannot_be_started_is_an_error_of_the_system() -> None:
    async def work() -> None:
        with pytest.raises(FileNotFoundError):
            async with child("/there/is/none"):
                pytest.fail("it was started")

    _run(work())


def _children() -> set[str]:
    return set(Path(f"/proc/self/task/{os.getpid()}/children").read_text(encoding="ascii").split())
