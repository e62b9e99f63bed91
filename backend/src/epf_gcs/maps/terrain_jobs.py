"""Converts rasters of heights to terrain, one after the other, each in a process that can be killed."""

from __future__ import annotations

import asyncio
import contextlib
import sys
from collections.abc import Awaitable, Callable
from functools import partial
from typing import Any, Final, Protocol, TypeVar

import structlog

from epf_gcs.errors import GatewayError, InvalidInputError
from epf_gcs.extras import MAPS
from epf_gcs.maps import faults
from epf_gcs.maps.files import MapFile
from epf_gcs.maps.folder import MapFolder
from epf_gcs.maps.open_files import Stamp
from epf_gcs.workers.child import child
from epf_gcs.workers.lines import WorkerLine, hear_lines
from epf_gcs.workers.missing import missing

_WORKER: Final = "epf_gcs.maps.terrain_worker"

log = structlog.get_logger("gateway")


T = TypeVar("T")


class ThreadRunner(Protocol):
    """Runs blocking work in one of the maps' threads."""

    def __call__(self, work: Callable[..., T], /, *values: Any) -> Awaitable[T]:
        """Return the work's result, or raise its exception."""


class TerrainLine(WorkerLine):
    """A line of the terrain worker."""

    percent: int = 0


class TerrainJobs:
    """Converts every raster in the folder that has no terrain: at the start, and after each `wake`.

    `told(file, percent)`: progress. `ended(file, problem)`: finished; `problem` is None, or why it failed.
    """

    def __init__(self, folder: MapFolder, in_thread: ThreadRunner, report: Callable[[GatewayError], None]) -> None:
        self._folder = folder
        self._in_thread = in_thread
        self._report = report
        self.told: Callable[[MapFile, int], None] = lambda _file, _percent: None
        self.ended: Callable[[MapFile, GatewayError | None], Awaitable[None]] = _nobody_asked
        self._awake = asyncio.Event()
        self._awake.set()
        self._percent: dict[str, int] = {}
        self._failed: dict[tuple[str, Stamp], GatewayError] = {}
        self._current: tuple[str, asyncio.subprocess.Process] | None = None
        self._was_cancelled = False
        folder.waiting = self._problem_of

    def wake(self) -> None:
        """Look for new rasters in the folder."""
        self._awake.set()

    def cancel(self, file: MapFile) -> None:
        """Stop the conversion of this file, which is about to be deleted."""
        if self._current is not None and self._current[0] == file.id:
            self._was_cancelled = True
            with contextlib.suppress(ProcessLookupError):
                self._current[1].kill()

    async def run(self) -> None:
        """Convert rasters, forever."""
        while True:
            await self._awake.wait()
            self._awake.clear()
            for file in await self._in_thread(self._folder.unconverted):
                if (file.id, file.stamp) not in self._failed:
                    await self._convert(file)

    async def _convert(self, file: MapFile) -> None:
        if not await self._in_thread(file.path.exists):
            return
        if not MAPS.is_here:
            self._failed[file.id, file.stamp] = missing(MAPS)
            await self.ended(file, self._failed[file.id, file.stamp])
            return
        self._was_cancelled = False
        target = self._folder.terrain_of(file)
        try:
            await self._in_thread(lambda: target.parent.mkdir(parents=True, exist_ok=True))
            problem = await self._work(file, [str(file.path), str(target), file.path.name, file.inside or ""])
        except OSError as error:
            problem = faults.not_converted(file.path.name, error.strerror or str(error))
        finally:
            self._percent.pop(file.id, None)
            await asyncio.shield(self._in_thread(lambda: target.with_suffix(".part").unlink(missing_ok=True)))
        if problem is not None and not self._was_cancelled:
            self._failed[file.id, file.stamp] = problem
            self._report(problem)
        await self.ended(file, problem)

    async def _work(self, file: MapFile, arguments: list[str]) -> GatewayError | None:
        """Run the worker; None if it succeeded."""
        nowhere, pipe = asyncio.subprocess.DEVNULL, asyncio.subprocess.PIPE
        async with child(sys.executable, "-m", _WORKER, *arguments, stdin=nowhere, stdout=pipe) as process:
            self._current = (file.id, process)
            try:
                problem = await hear_lines(process, TerrainLine, partial(self._heard, file), InvalidInputError)
                code = await process.wait()
            finally:
                self._current = None
        if code != 0 and problem is None:
            log.error("the terrain worker failed", file=file.path.name, code=code)
            problem = faults.not_converted(file.path.name, f"{code}")
        return problem

    def _heard(self, file: MapFile, line: TerrainLine) -> None:
        self._percent[file.id] = line.percent
        self.told(file, line.percent)

    def _problem_of(self, file: MapFile) -> GatewayError:
        failed = self._failed.get((file.id, file.stamp))
        return failed if failed is not None else faults.converting(file.path.name, self._percent.get(file.id, 0))


async def _nobody_asked(_file: MapFile, _problem: GatewayError | None) -> None:
    """Default for `ended`: do nothing."""
