"""The process that replays a recording for all its viewers: started with the first, ended with the last."""

from __future__ import annotations

import asyncio
import contextlib
import shutil
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Final

import orjson

from epf_gcs.bus.station_end import Listener, StationEnd
from epf_gcs.contract.notices import Notice
from epf_gcs.contract.requests import AnswerT_co, Request
from epf_gcs.errors import ConflictError
from epf_gcs.workers.child import child

_POLITE_S: Final = 2.0
_MOST_WORDS: Final = 2000


class ReplayProcess:
    """Starts when it is made. It also ends if this process is killed: its standard input closes then.

    `on_end` is called when it ends, or is to end: it takes no more viewers.
    """

    def __init__(self, recording: Path, keys: Path, on_end: Callable[[], None]) -> None:
        self.flight = recording.stem
        self._words = [sys.executable, "-m", "epf_gcs.replay", "--with-parent"]
        self._words += ["--recording", str(recording), "--keys", str(keys)]
        self._on_end: Callable[[], None] | None = on_end
        self._viewers = 0
        self._unsaid: list[bytes] = []
        self._process: asyncio.subprocess.Process | None = None
        self._task = asyncio.create_task(self._run(), name=f"replay of {self.flight}")

    def join(self) -> None:
        """One viewer more."""
        self._viewers += 1

    async def leave(self) -> None:
        """One viewer fewer; after the last the process ends, and is waited for."""
        self._viewers -= 1
        if not self._viewers:
            self._take_no_more()
            self._task.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await self._task

    async def last_words(self) -> str:
        """Wait until it ends by itself; what it said."""
        return await asyncio.shield(self._task)

    def open(self, folder: str, at_s: float) -> None:
        """Have it listen in a folder for a viewer of the moment `at_s` seconds after the start."""
        self._unsaid.append(orjson.dumps({"folder": folder, "at_s": at_s}) + b"\n")
        self._say()

    def _say(self) -> None:
        if self._process is not None and self._process.stdin is not None:
            self._process.stdin.write(b"".join(self._unsaid))
            self._unsaid.clear()

    def _take_no_more(self) -> None:
        if self._on_end is not None:
            self._on_end()
            self._on_end = None

    async def _run(self) -> str:
        pipe, nowhere = asyncio.subprocess.PIPE, asyncio.subprocess.DEVNULL
        with tempfile.TemporaryFile() as words:
            try:
                async with child(*self._words, grace_s=_POLITE_S, stdin=pipe, stdout=nowhere, stderr=words) as process:
                    self._process = process
                    self._say()
                    await process.wait()
            finally:
                self._take_no_more()
            words.seek(0)
            return words.read().decode(errors="replace")[-_MOST_WORDS:].strip()


class ViewersReplay:
    """One viewer's part in a process. `enter` gives the process, when the viewer is there."""

    def __init__(self, flight: str, enter: Callable[[], ReplayProcess], at_s: float) -> None:
        self.flight = flight
        self._enter = enter
        self._at_s = at_s
        self._end: StationEnd | None = None

    def notice(self, notice: Notice) -> None:
        """Tell the replay; dropped before it is there."""
        if self._end is not None:
            self._end.notice(notice)

    async def ask(self, request: Request[AnswerT_co]) -> AnswerT_co:
        """Ask the replay about the moment that it shows. Raises ConflictError if it is not there."""
        if self._end is None:
            raise ConflictError("flight_away", "The replay is not there.")
        return await self._end.ask(request)

    async def run(self, listener: Listener) -> str:
        """Run until cancelled, or until the process ends by itself; returns its last words then.

        `listener` gets what is sent.
        """
        process = self._enter()
        process.join()
        connected: asyncio.Task[None] | None = None
        folder = ""
        try:
            folder = await asyncio.to_thread(tempfile.mkdtemp, prefix="epf-replay-")
            self._end = StationEnd(Path(folder), listener)
            connected = asyncio.create_task(self._end.run())
            process.open(folder, self._at_s)
            return await process.last_words()
        finally:
            self._end = None
            if connected is not None:
                connected.cancel()
                with contextlib.suppress(asyncio.CancelledError):
                    await connected
            try:
                await process.leave()
            finally:
                shutil.rmtree(folder, ignore_errors=True)
