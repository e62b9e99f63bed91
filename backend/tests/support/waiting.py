"""Waits for a condition. Every test's patience is `DEADLINE_S`: it costs nothing where the machine is fast."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable, Iterable, Iterator
from typing import TypeVar

# As long as a program may take to start while other work keeps every core busy.
DEADLINE_S = 180.0
_FIRST_PAUSE_S = 0.005
_LONGEST_PAUSE_S = 0.05

T = TypeVar("T")
R = TypeVar("R")


def eventually(condition: Callable[[], bool], what: str) -> None:
    """Return when the condition holds; fail with `what` if it does not before the deadline."""
    for pause_s in _pauses(what):
        if condition():
            return
        time.sleep(pause_s)


async def eventually_async(condition: Callable[[], bool], what: str) -> None:
    """The same as a coroutine, without blocking the event loop."""
    for pause_s in _pauses(what):
        if condition():
            return
        await asyncio.sleep(pause_s)


def _pauses(what: str) -> Iterator[float]:
    """Longer and longer: looking takes the processor from what is waited for."""
    give_up_s = time.monotonic() + DEADLINE_S
    pause_s = _FIRST_PAUSE_S
    while time.monotonic() < give_up_s:
        yield pause_s
        pause_s = min(_LONGEST_PAUSE_S, 1.2 * pause_s)
    raise AssertionError(f"never happened: {what}")


def until_late(coming: Iterable[T], what: str) -> Iterator[T]:
    """What comes, one after the other, for who looks for a certain one among them; fails with `what` at the deadline.

    Each of them may come in time for ever: whoever waits for one that never comes is told so.
    """
    give_up_s = time.monotonic() + DEADLINE_S
    for one in coming:
        yield one
        if time.monotonic() > give_up_s:
            break
    raise AssertionError(f"never came: {what}")


def first_of(receive: Callable[[], T], found: Callable[[T], R | None], what: str) -> R:
    """What `found` makes of the first that it knows among those that `receive` gives, and None of all before it.

    Fails with `what` at the deadline: others may keep coming for ever. `receive` has a deadline of its own.
    """
    give_up_s = time.monotonic() + DEADLINE_S
    while (result := found(receive())) is None:
        if time.monotonic() > give_up_s:
            raise AssertionError(f"never came: {what}")
    return result
