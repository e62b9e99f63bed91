"""Waits for a condition, with a deadline far above what a healthy machine needs."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable

DEADLINE_S = 20.0
_LOOK_EVERY_S = 0.005


def eventually(condition: Callable[[], bool], what: str) -> None:
    """Return when the condition holds; fail with `what` if it does not before the deadline."""
    give_up_s = time.monotonic() + DEADLINE_S
    while not condition():
        if time.monotonic() > give_up_s:
            raise AssertionError(f"never happened: {what}")
        time.sleep(_LOOK_EVERY_S)


async def eventually_async(condition: Callable[[], bool], what: str) -> None:
    """The same as a coroutine, without blocking the event loop."""
    give_up_s = time.monotonic() + DEADLINE_S
    while not condition():
        if time.monotonic() > give_up_s:
            raise AssertionError(f"never happened: {what}")
        await asyncio.sleep(_LOOK_EVERY_S)
