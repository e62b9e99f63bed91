"""Tasks and callbacks that go on after a bug: one that fails must not end a flight, nor the others.

A task is run by `keep_alive`. A chain of timers that arms itself again tells `failed_in` what was raised, and goes on.
"""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from typing import Any, Final

import structlog

_RESTART_S: Final = 1.0


async def keep_alive(
    process: str, part: str, job: Callable[[], Awaitable[None]], on_failure: Callable[[], None]
) -> None:
    """Run `job` until cancelled, again and again. A failure is logged under `process`, then `on_failure` is called."""
    log = structlog.get_logger(process)
    while True:
        try:
            await job()
        except Exception:
            log.exception("a part failed and begins again", part=part)
            on_failure()
            await asyncio.sleep(_RESTART_S)


def log_and_count_failures(loop: asyncio.AbstractEventLoop, process: str, on_failure: Callable[[], None]) -> None:
    """From now on what a callback of the loop raises is logged under `process`, and `on_failure` is called."""
    log = structlog.get_logger(process)

    def handle(loop: asyncio.AbstractEventLoop, context: dict[str, Any]) -> None:
        error = context.get("exception")
        if error is None:
            loop.default_exception_handler(context)
            return
        log.error("a callback failed", what=context.get("message"), exc_info=error)
        on_failure()

    loop.set_exception_handler(handle)


def failed_in(what: str, error: Exception) -> None:
    """A turn of a chain of timers failed; whoever catches it arms the next turn."""
    asyncio.get_running_loop().call_exception_handler({"message": what, "exception": error})
