"""Asks the query program (`python -m epf_gcs.flights serve`), which is started at the first question.

It reads recordings, also strangers', so it is a program of its own that is ended when a question takes too long, and
when nobody has asked for a while.
"""

from __future__ import annotations

import asyncio
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Final

import msgspec
import structlog

from epf_gcs.contract.flight_questions import FlightQuestion
from epf_gcs.errors import ConflictError, GatewayError, InvalidInputError, NotFoundError
from epf_gcs.extras import FLIGHTS
from epf_gcs.repeating import repeat
from epf_gcs.workers.asked_process import AskedProcess
from epf_gcs.workers.lines import ToldFault
from epf_gcs.workers.missing import require
from epf_gcs.workers.pipe import ReplyHead

_LONGEST_S: Final = 30.0
_IDLE_S: Final = 600.0
_LOOK_EVERY_S: Final = 1.0
_MISSING: Final = ("signal_unknown", "flight_unknown")

log = structlog.get_logger("web")


class Queries:
    """Owned by the event loop; one question at a time, in the order they come."""

    def __init__(self, data_dir: Path, longest_s: float = _LONGEST_S, idle_s: float = _IDLE_S) -> None:
        self._process = AskedProcess("epf_gcs.flights", "serve", str(data_dir.absolute()))
        self._thread = ThreadPoolExecutor(1, thread_name_prefix="flight queries")
        self._loop = asyncio.get_running_loop()
        self._longest_s = longest_s
        self._idle_s = idle_s
        self._asked_s = self._loop.time()

    async def ask(self, question: FlightQuestion) -> bytes:
        """The answer's bytes. Raises GatewayError."""
        require(FLIGHTS)
        self._asked_s = self._loop.time()
        answer = await self._loop.run_in_executor(self._thread, self._process.ask, question, self._longest_s)
        self._asked_s = self._loop.time()
        if answer is None:
            flight = question.flight
            log.error("a question about a flight ended its program", flight=flight, do=type(question).__name__)
            raise ConflictError(
                "recording_unreadable",
                f"The flight '{flight}' cannot be read: it takes more memory or time than a question may.",
                reason="it takes more memory or time than a question may",
            )
        head, body = answer
        fault = msgspec.json.decode(head, type=ReplyHead).fault
        if fault is not None:
            raise _error(fault)
        return body

    async def run(self) -> None:
        """End the program when a question is overdue or nobody asks, forever."""
        await repeat(_LOOK_EVERY_S, "questions about flights", self._look)

    async def _look(self) -> None:
        self._process.end_if_late()
        if self._process.is_running and self._loop.time() - self._asked_s > self._idle_s:
            await self._loop.run_in_executor(self._thread, self._process.end)

    async def close(self) -> None:
        """End the program."""
        await asyncio.to_thread(self._thread.shutdown, cancel_futures=True)
        self._process.end()


def _error(fault: ToldFault) -> GatewayError:
    kind: type[GatewayError] = InvalidInputError
    if fault.code in _MISSING:
        kind = NotFoundError
    elif fault.code == "flight_not_indexed":
        kind = ConflictError
    return kind(fault.code, fault.detail, **fault.params)
