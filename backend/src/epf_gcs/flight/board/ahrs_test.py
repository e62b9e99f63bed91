"""The AHRS test: the board sends a stream of bare attitudes in place of frames until the test ends.

Meanwhile the board takes no commands and sends no heartbeat, so the test is refused while the board flies. The
first record proves its start, the next heartbeat its end.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Final, Literal

from epf_gcs.clock import Clock
from epf_gcs.contract.answers import CommandOutcome
from epf_gcs.error_log import ErrorLog
from epf_gcs.errors import ConflictError, LinkError
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.vehicle import Vehicle

Stage = Literal["off", "starting", "running", "ending"]

# The dialogue is tried twice: 0.2 s and 2 s each.
_BEGIN_S: Final = 4.6
# Reopening the session takes a heartbeat, plus 0.5 s on a deployed board, which does not answer; retried each second.
_END_S: Final = 4.0
# Records come at 50 Hz: after this long without one the board was switched off or left the test by itself.
_SILENCE_S: Final = 2.0


class AhrsTestRun:
    """Takes over the board's line. The test is refused while `flies()`; `changed` is called on each new stage."""

    def __init__(
        self,
        *,
        vehicle: Vehicle,
        clock: Clock,
        errors: ErrorLog,
        flies: Callable[[], bool],
        changed: Callable[[], None],
    ) -> None:
        self._board: Board = vehicle.board
        self._samples = vehicle.ahrs_test
        self._clock = clock
        self._errors = errors
        self._flies = flies
        self._changed = changed
        self._lock = asyncio.Lock()
        self._test = vehicle.ahrs_test.test
        self._heard_s = 0.0
        self._has_record = False
        self._news = asyncio.Event()
        self._is_ending = False

    @property
    def stage(self) -> Stage:
        """The test's stage: "running" only from the first attitude, for the board's announcement proves nothing."""
        if self._board.exclusive_user is self:
            return "running" if self._has_record else "starting"
        return "ending" if self._is_ending else "off"

    async def start(self) -> CommandOutcome:
        """Begin and wait for the first record. Raises ConflictError if the board cannot run the test now."""
        async with self._lock:
            started_s = self._clock.steady_s()
            if self.stage != "running":
                self._check_startable()
                self._heard_s = started_s
                self._has_record = False
                self._board.acquire_line(self)
                self._board.write(self._test.start(started_s))
                self._changed()
                await self._wait(lambda: self.stage != "starting", _BEGIN_S)
            done = self.stage == "running"
            if not done and self._board.exclusive_user is self:
                self._board.release_line()
            self._changed()
            return self._result(started_s, done=done, by="read_back")

    async def stop(self) -> CommandOutcome:
        """End and wait until the board speaks frames again."""
        async with self._lock:
            started_s = self._clock.steady_s()
            if self._board.exclusive_user is self:
                self._board.release_line()
            self._is_ending = True
            self._changed()
            try:
                await self._wait(lambda: self._board.is_open or self._board.link is None, _END_S)
            finally:
                self._is_ending = False
                self._changed()
            return self._result(started_s, done=self._board.is_open, by="heartbeat")

    def tick(self) -> None:
        """Send what is due and detect a test that went silent; called a few times a second."""
        if self._board.exclusive_user is not self:
            self._news.set()
            return
        now_s = self._clock.steady_s()
        due = self._test.tick(now_s)
        if due:
            self._board.write(due)
        if self.stage == "running" and now_s - self._heard_s > _SILENCE_S:
            self._errors.report(
                LinkError(
                    "ahrs_test_lost",
                    "The AHRS test is over because the board sent no attitude any more: check its power and cable.",
                )
            )
            self._board.release_line()
            self._changed()
        self._news.set()

    def on_bytes(self, data: bytes) -> None:
        """Take bytes of the board's line during the test."""
        was = self.stage
        if self._samples.take(data):
            self._has_record = True
            self._heard_s = self._clock.steady_s()
            self._news.set()
        if self.stage != was:
            self._changed()

    def on_line_released(self) -> bytes:
        """Return the bytes that end the test on the board, and regard the test as over."""
        self._news.set()
        return self._test.stop()

    def _check_startable(self) -> None:
        self._board.check_commandable()
        if not self._board.is_open:
            raise ConflictError(
                "board_not_open", "The AHRS test was not started because no board is connected: open its link first."
            )
        if self._flies():
            raise ConflictError(
                "ahrs_test_in_flight",
                "The AHRS test was not started because the board is flying: it hears no command during the test. "
                "Switch its autopilot off, and the simulator to manual.",
            )

    async def _wait(self, condition: Callable[[], bool], at_most_s: float) -> None:
        try:
            async with asyncio.timeout(at_most_s):
                while not condition():
                    self._news.clear()
                    await self._news.wait()
        except TimeoutError:
            return

    def _result(self, started_s: float, *, done: bool, by: Literal["read_back", "heartbeat"]) -> CommandOutcome:
        ms = round((self._clock.steady_s() - started_s) * 1000.0, 1)
        return CommandOutcome("confirmed" if done else "timed_out", by, ms)
