"""All replays of one recording on an event loop, one for each viewer, and the scout's work between their turns.

They share a process because ten that each wake sixty times a second find the processor's caches cold at each wake.
"""

from __future__ import annotations

import asyncio
from pathlib import Path
from time import monotonic
from typing import Final

import structlog

from epf_gcs.bus.address import Listener
from epf_gcs.repeating import Repeating
from epf_gcs.replay.keys import Keys
from epf_gcs.replay.scout import Scout
from epf_gcs.replay.timeline import Timeline
from epf_gcs.replay.viewing import ReplayViewer

# The scout works while no turn is due for this long.
_SPARE_S: Final = 0.002
_LOOK_S: Final = 0.1

log = structlog.get_logger("replay")


class VehicleProcess:
    """`keys` is the file of key frames, None for none. Raises RecordingError for a file that is no recording."""

    def __init__(self, recording: Path, keys: Path | None) -> None:
        self._flight = recording.stem
        self._keys_file = keys
        self._timeline = Timeline(recording)
        self._keys: Keys | None = None
        self._scout: Scout | None = None
        self._spare: Repeating | None = None
        self._viewings: set[ReplayViewer] = set()
        self._asked: asyncio.Queue[tuple[Path, float]] = asyncio.Queue()

    def open(self, folder: Path, at_s: float) -> None:
        """Replay from `at_s` seconds after the start for the viewer that connects to a socket in this folder."""
        self._asked.put_nowait((folder, at_s))

    async def run(self) -> None:
        """Play until cancelled. Raises RecordingError if the file turns out to be none."""
        while self._timeline.starts_ns is None:
            # A recording that begins now, and holds no byte yet.
            await asyncio.sleep(_LOOK_S)
            self._timeline.look()
        keys = self._keys = Keys(self._keys_file, self._flight, self._timeline.starts_ns)
        self._scout = Scout(self._timeline, keys)
        self._spare = Repeating(asyncio.get_running_loop(), "the scout of a replay", self._work, after_failure_s=1.0)
        try:
            async with asyncio.TaskGroup() as tasks:
                while True:
                    folder, at_s = await self._asked.get()
                    viewing = ReplayViewer(self._timeline, keys, self._flight, at_s, on_turn=self._look_for_work)
                    tasks.create_task(self._show(viewing, folder))
        except ExceptionGroup as group:
            # What ends one replay of this file ends all.
            raise group.exceptions[0] from group

    def close(self) -> None:
        """Let the file of key frames go."""
        if self._spare is not None:
            self._spare.stop()
        if self._keys is not None:
            self._keys.close()

    async def _show(self, viewing: ReplayViewer, folder: Path) -> None:
        self._viewings.add(viewing)
        self._timeline.readers = len(self._viewings) + 1
        try:
            listener = Listener(folder)
        except OSError as error:
            log.warning("a viewer's folder has gone", reason=str(error))
        else:
            try:
                await viewing.run(listener)
            finally:
                listener.close()
        finally:
            self._viewings.discard(viewing)
            self._timeline.readers = len(self._viewings) + 1

    def _look_for_work(self) -> None:
        if self._spare is not None and self._scout is not None and self._scout.has_work:
            self._spare.arm()

    def _work(self) -> float | None:
        """A slice of the scout's work, if no viewer waits for a turn."""
        scout = self._scout
        if scout is None or not scout.has_work or not self._viewings:
            return None
        wait_s = min(viewing.due_s for viewing in self._viewings) - monotonic()
        if wait_s <= _SPARE_S:
            return _SPARE_S
        if scout.work():
            for viewing in self._viewings:
                viewing.keys_came()
        return 0.0
