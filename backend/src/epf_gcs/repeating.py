"""Work that comes again and again, and goes on after a bug: what one turn raises ends neither the others nor a flight.

`Repeating` owns a chain of timers, `repeat` is its form for a task; both tell the event loop what was raised, and
`log_and_count_failures` has the loop log and count it. `keep_alive` runs a whole task again. Nothing else arms a timer
from its own callback (`backend/tests/test_repeating.py`).
"""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from typing import Any, Final

import structlog

_RESTART_S: Final = 1.0


class Repeating:
    """`turn` is called on the loop when due. It returns in how many seconds it is due again, or None to wait for `arm`.

    After a turn that raised, the next comes in `after_failure_s`; None: when it is armed. `what` names it in the log.
    """

    def __init__(
        self,
        loop: asyncio.AbstractEventLoop,
        what: str,
        turn: Callable[[], float | None],
        after_failure_s: float | None = None,
    ) -> None:
        self._loop = loop
        self._what = what
        self._turn = turn
        self._after_failure_s = after_failure_s
        self._handle: asyncio.Handle | None = None
        self._is_stopped = False
        # Counts `cancel`, so that one within a turn also holds for what the turn returns.
        self._cancelled = 0
        self.due_s = 0.0
        """When the turn that was armed last is due, or was, on the loop's clock."""

    @property
    def is_armed(self) -> bool:
        """Whether a turn is due."""
        return self._handle is not None

    def arm(self, in_s: float = 0.0) -> None:
        """Have a turn in so many seconds, at the earliest in the loop's next turn; nothing if one is due already."""
        if self._handle is None and not self._is_stopped:
            self.due_s = self._loop.time() + in_s
            self._handle = self._loop.call_soon(self._run) if in_s <= 0.0 else self._loop.call_at(self.due_s, self._run)

    def hurry(self) -> None:
        """Have the turn in the loop's next turn, whenever it was due."""
        self.cancel()
        self.arm()

    def run_now(self) -> None:
        """Have the turn here and now, instead of when it was due."""
        self.cancel()
        self._run()

    def cancel(self) -> None:
        """No turn is due until it is armed again."""
        self._cancelled += 1
        if self._handle is not None:
            self._handle.cancel()
            self._handle = None

    def stop(self) -> None:
        """No turn comes any more, for good."""
        self._is_stopped = True
        self.cancel()

    def _run(self) -> None:
        self._handle = None
        cancelled = self._cancelled
        try:
            in_s = self._turn()
        except Exception as error:  # noqa: BLE001 - told to the loop
            report_failure(self._loop, self._what, error)
            in_s = self._after_failure_s
        if in_s is not None and cancelled == self._cancelled:
            self.arm(in_s)


async def repeat(
    seconds: float, what: str, turn: Callable[[], Awaitable[None] | None], *, at_once: bool = False
) -> None:
    """Call `turn` every so many seconds until cancelled, the first time `at_once` or after the first wait."""
    if not at_once:
        await asyncio.sleep(seconds)
    while True:
        try:
            waits = turn()
            if waits is not None:
                await waits
        except Exception as error:  # noqa: BLE001 - told to the loop
            report_failure(asyncio.get_running_loop(), what, error)
        await asyncio.sleep(seconds)


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


def report_failure(loop: asyncio.AbstractEventLoop, what: str, error: Exception) -> None:
    """One of several was skipped because it raised: the loop logs and counts it, and the others have their turn."""
    loop.call_exception_handler({"message": what, "exception": error})
