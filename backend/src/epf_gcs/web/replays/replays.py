"""Replays for viewers: at most so many, those of one recording in one process, which ends with its last viewer."""

from __future__ import annotations

import asyncio
import contextlib
import math
from collections.abc import Callable
from http import HTTPStatus
from pathlib import Path
from typing import Final

from epf_gcs.access.caller import Caller
from epf_gcs.access.limits import holder_of
from epf_gcs.error_log import ErrorLog
from epf_gcs.recordings.places import Places, is_id
from epf_gcs.shares.places import Holdings
from epf_gcs.shares.table import Shares
from epf_gcs.web.replays.busy_replay import BusyReplay, replays_busy
from epf_gcs.web.replays.replay_conversation import ReplayConversation
from epf_gcs.web.replays.replay_process import ReplayProcess, ViewersReplay
from epf_gcs.web.stream.handshake import Refusal
from epf_gcs.web.stream.socket import SocketConnection

CURRENT: Final = "current"
_FARTHEST_S: Final = 1e9


class Replays:
    """`growing` gives the id of the flight that is being recorded, None while there is none."""

    def __init__(self, data_dir: Path, errors: ErrorLog, growing: Callable[[], str | None], shares: Shares) -> None:
        self._places = Places(data_dir)
        self._errors = errors
        self._growing = growing
        self._open: Holdings[SocketConnection] = Holdings(shares.replays)
        self._running: set[asyncio.Task[None]] = set()
        self._processes: dict[Path, ReplayProcess] = {}

    @property
    def count(self) -> int:
        """How many there are now."""
        return len(self._open)

    @property
    def flights(self) -> set[str]:
        """The flights that are replayed now."""
        return {file.stem for file in self._processes}

    def open(
        self,
        connection: SocketConnection,
        caller: Caller,
        query: dict[str, str],
        rate_hz: int,
        on_end: Callable[[], None],
    ) -> ReplayConversation | BusyReplay:
        """A replay of `flight` from `at_s` on, for this connection; `on_end`: it is over. Raises Refusal."""
        flight = query["flight"]
        file = self._file(flight)
        at_s = _read_moment(query.get("at_s", "0"))
        if at_s is None:
            self._errors.count("invalid_request")
            raise Refusal(HTTPStatus.BAD_REQUEST, "at_s must be seconds after the start of the flight.")
        shortage = self._open.take(connection, holder_of(caller))
        if shortage is not None:
            error = replays_busy(shortage)
            self._errors.count(error.code)
            return BusyReplay(connection, error, on_end)

        def leave() -> None:
            self._open.leave(connection)
            on_end()

        replay = ViewersReplay(file.stem, lambda: self._process(file), at_s)
        return ReplayConversation(connection, caller, replay, rate_hz=rate_hz, on_start=self._start, on_end=leave)

    async def close(self) -> None:
        """End all: the web process ends."""
        for task in tuple(self._running):
            task.cancel()
        for task in tuple(self._running):
            with contextlib.suppress(asyncio.CancelledError):
                await task

    def _process(self, file: Path) -> ReplayProcess:
        """The one that replays this recording, or a new one."""
        process = self._processes.get(file)
        if process is None:
            keys = self._places.keyframes(file.stem)

            def forget() -> None:
                self._processes.pop(file, None)

            process = self._processes[file] = ReplayProcess(file, keys, forget)
        return process

    def _start(self, task: asyncio.Task[None]) -> None:
        self._running.add(task)
        task.add_done_callback(self._running.discard)

    def _file(self, flight: str) -> Path:
        """The file of this id. Raises Refusal."""
        flight_id = self._growing() if flight == CURRENT else flight if is_id(flight) else None
        file = None if flight_id is None else self._places.recording(flight_id)
        if file is None or not file.is_file():
            self._errors.count("recording_unknown")
            sentence = (
                "Nothing is being recorded now: open the board's or the simulator's line first."
                if flight == CURRENT
                else "There is no such recording: GET /api/v1/flights lists them."
            )
            raise Refusal(HTTPStatus.NOT_FOUND, sentence)
        return file


def _read_moment(text: str) -> float | None:
    try:
        at_s = float(text)
    except ValueError:
        return None
    return at_s if math.isfinite(at_s) and abs(at_s) < _FARTHEST_S else None
