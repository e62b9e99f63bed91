"""A program that the web process starts ends with the work that needed it, and never outlives the event loop."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncIterator, Awaitable
from typing import Any, TypeVar

_Result = TypeVar("_Result")


@contextlib.asynccontextmanager
async def child(*words: str, grace_s: float = 0.0, **streams: Any) -> AsyncIterator[asyncio.subprocess.Process]:
    """Start a program; where the block ends it has ended: told to, and after `grace_s` seconds killed.

    `streams` are those of `asyncio.create_subprocess_exec`. Whoever is cancelled in the block, even several times,
    still waits for that end, which takes `grace_s` at most: the loop may be closed right afterwards. Raises OSError.
    """
    starting = asyncio.ensure_future(asyncio.create_subprocess_exec(*words, **streams))
    try:
        await _whole(starting)
        yield starting.result()
    finally:
        if not starting.cancelled() and starting.exception() is None:
            await _whole(_end(starting.result(), grace_s))


async def _whole(work: Awaitable[_Result]) -> _Result:
    """The result of the work, through any number of cancellations; the last of them is raised at its end."""
    task, cancelled = asyncio.ensure_future(work), None
    while not task.done():
        try:
            await asyncio.wait({task})
        except asyncio.CancelledError as error:
            cancelled = error
    if cancelled is not None:
        raise cancelled
    return task.result()


async def _end(process: asyncio.subprocess.Process, grace_s: float) -> None:
    if process.returncode is None and grace_s > 0.0:
        with contextlib.suppress(ProcessLookupError):
            process.terminate()
        with contextlib.suppress(TimeoutError):
            async with asyncio.timeout(grace_s):
                await process.wait()
    if process.returncode is None:
        with contextlib.suppress(ProcessLookupError):
            process.kill()
        await process.wait()
    if process.stdin is not None:
        process.stdin.close()
