"""The process of one replay: started in a folder of its own, and gone when its viewer is."""

from __future__ import annotations

import asyncio
import contextlib
import shutil
import sys
import tempfile
from pathlib import Path
from typing import Any, Final

from epf_gcs.bus.station_end import Listener, StationEnd
from epf_gcs.errors import ConflictError

_POLITE_S: Final = 2.0
_MOST_WORDS: Final = 2000


class ReplayProcess:
    """`run` it as a task; cancelling the task ends the process. It also ends if this process is killed: its standard
    input closes then."""

    def __init__(self, recording: Path, keys: Path, at_s: float) -> None:
        self._recording = recording
        self._keys = keys
        self._at_s = at_s
        self._end: StationEnd | None = None

    @property
    def flight(self) -> str:
        """The recording's id."""
        return self._recording.stem

    def notice(self, name: str, /, **arguments: object) -> None:
        """Tell the replay; dropped before it is there."""
        if self._end is not None:
            self._end.notice(name, **arguments)

    async def request(self, name: str) -> Any:
        """Ask the replay about the moment that it shows. Raises ConflictError if it is not there."""
        if self._end is None:
            raise ConflictError("flight_away", "The replay is not there.")
        return await self._end.request(name)

    async def run(self, listener: Listener) -> str:
        """Run until the process ends by itself; returns its last words. `listener` gets what it sends."""
        folder = await asyncio.to_thread(tempfile.mkdtemp, prefix="epf-replay-")
        said = Path(folder) / "said"
        try:
            with said.open("wb") as words:
                process = await asyncio.create_subprocess_exec(
                    sys.executable,
                    *("-m", "epf_gcs.replay", "--with-parent"),
                    *("--recording", str(self._recording), "--folder", folder),
                    *("--keys", str(self._keys), "--at", repr(self._at_s)),
                    stdin=asyncio.subprocess.PIPE,
                    stdout=asyncio.subprocess.DEVNULL,
                    stderr=words,
                )
            self._end = StationEnd(Path(folder), listener)
            connected = asyncio.create_task(self._end.run())
            try:
                await process.wait()
            finally:
                self._end = None
                connected.cancel()
                with contextlib.suppress(asyncio.CancelledError):
                    await connected
                await _ended(process)
            return said.read_text(errors="replace")[-_MOST_WORDS:].strip()
        finally:
            shutil.rmtree(folder, ignore_errors=True)


async def _ended(process: asyncio.subprocess.Process) -> None:
    """End it, kindly and then not."""
    if process.returncode is not None:
        return
    with contextlib.suppress(ProcessLookupError):
        process.terminate()
    try:
        async with asyncio.timeout(_POLITE_S):
            await process.wait()
    except TimeoutError:
        with contextlib.suppress(ProcessLookupError):
            process.kill()
        await process.wait()
