"""Tasks that begin again after a bug: one faulty task must not end a flight, nor the others."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from typing import Final

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
