"""Fields that are being prepared: each in a process of its own, one after the other, going on after a restart."""

from __future__ import annotations

import asyncio
import contextlib
import filecmp
import secrets
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Final

import msgspec
import structlog

from epf_gcs.contract.events import Say
from epf_gcs.contract.maps import FieldProof
from epf_gcs.errors import ConflictError, GatewayError, InvalidInputError, NotFoundError
from epf_gcs.fields.job import FieldJob, FieldState, at_rest, kept_jobs
from epf_gcs.fields.order import Level, Order, check, estimate, made_bytes
from epf_gcs.fields.pack import END
from epf_gcs.fields.work import FieldLine, Prepare, Prove, Work
from epf_gcs.fields.worker import PACK, not_written
from epf_gcs.maps.files import id_of, safe_name
from epf_gcs.maps.folder import exists
from epf_gcs.maps.maps import Maps
from epf_gcs.workers.child import child
from epf_gcs.workers.lines import hear_lines

FOLDER: Final = ".fields"

_WORKER: Final = "epf_gcs.fields.worker"
_MOST_KEPT: Final = 20
_MOST_STARTS: Final = 3
_PAUSE_S: Final = 1.0

log = structlog.get_logger("gateway")


class Fields:
    """Owned by the event loop; the maps' threads use the disk. One field at a time, for its sources' sake."""

    def __init__(self, maps: Maps, say: Say, report: Callable[[GatewayError], None]) -> None:
        self._maps = maps
        self._say = say
        self._report = report
        self._folder = maps.folder.path / FOLDER
        self._all: dict[str, FieldJob] = {}
        self._awake = asyncio.Event()
        self._worker: tuple[str, asyncio.subprocess.Process] | None = None
        self._ended = asyncio.Event()
        self._ended.set()

    async def run(self) -> None:
        """Go on with what an earlier run began, then prepare what is ordered, forever."""
        try:
            for job in await self._maps.in_thread(kept_jobs, self._folder):
                self._all.setdefault(job.id, job)
        except OSError as error:
            self._report(not_written(str(self._folder), error.strerror or str(error)))
        self._awake.set()
        while True:
            await self._awake.wait()
            self._awake.clear()
            while (first := next((one for one in self._all.values() if one.is_running()), None)) is not None:
                await self._prepare(first)

    def all(self) -> list[FieldJob]:
        """Those under way, and those that were done since the start; the oldest first."""
        return list(self._all.values())

    async def estimate(self, order: Order) -> tuple[list[Level], int]:
        """Levels with counts and bytes, and the bytes of what is made of them. Raises GatewayError."""
        check(order, self._maps.online.consent)
        return await self._maps.in_thread(lambda: (estimate(order), made_bytes(order)))

    async def start(self, order: Order) -> FieldJob:
        """Begin. Raises InvalidInputError if it cannot be brought, ConflictError if its name is taken."""
        name = safe_name(order.name + END)
        order = Order(name.removesuffix(END), order.area, order.parts)
        await self.estimate(order)
        job = FieldJob(secrets.token_hex(6), Path(), order)
        job.folder = self._folder / job.id
        is_there = await self._maps.in_thread((self._maps.folder.path / name).exists)
        # Nothing is waited for from here until the job is in the list: an equal order cannot come between.
        if is_there or any(one.file_name == name and one.state != "done" for one in self._all.values()):
            raise exists(name)
        if sum(one.state != "done" for one in self._all.values()) >= _MOST_KEPT:
            raise ConflictError(
                "field_too_many", f"{_MOST_KEPT} fields are waiting: remove one of them first.", limit=_MOST_KEPT
            )
        self._all[job.id] = job
        try:
            await self._maps.in_thread(job.write_order)
        except OSError as error:
            del self._all[job.id]
            raise not_written(order.name, error.strerror or str(error)) from error
        self._tell(job)
        self._awake.set()
        return job

    async def pause(self, field_id: str) -> FieldJob:
        """Stop for now; what arrived is kept, also over a restart. Raises NotFoundError, ConflictError."""
        job = self._get(field_id)
        if job.state != "running":
            raise _is_not(job)
        job.state = "paused"
        job.progress = at_rest(job.progress)
        await self._end_worker(job)
        if job.is_done():
            return job  # in just this moment
        await self._write_state(job)
        self._tell(job)
        return job

    async def resume(self, field_id: str) -> FieldJob:
        """Go on where it stopped. Raises NotFoundError, ConflictError."""
        job = self._get(field_id)
        if job.state not in ("paused", "failed"):
            raise _is_not(job)
        job.problem = None
        await self._enter(job, "running")
        self._awake.set()
        return job

    async def remove(self, field_id: str) -> None:
        """Forget it with all that arrived; a field that is done keeps its file. Raises NotFoundError, ConflictError."""
        job = self._get(field_id)
        before, job.state = job.state, "paused"
        await self._end_worker(job)
        try:
            await self._maps.in_thread(job.drop)
        except OSError as error:
            job.state = "failed" if before != "done" else before
            raise not_written(job.order.name, error.strerror or str(error)) from error
        self._all.pop(job.id, None)
        self._say("map_field", replace(job.told, state="removed"))

    async def prove(self, layer_id: str) -> FieldProof:
        """Compare every tile of a field's file with its manifest. Raises NotFoundError, InvalidInputError."""
        path = await self._maps.file_of(layer_id)
        if path.suffix.lower() != END:
            raise InvalidInputError("field_no_field", f"'{path.name}' is no prepared field.", name=path.name)
        told: list[FieldLine] = []
        problem = await self._work(Prove(str(path), path.name), told.append, lambda _: None)
        if problem is not None:
            raise problem
        if not told or told[-1].proof is None:
            raise InvalidInputError(
                "field_not_whole", f"'{path.name}' is not whole: remove it.", name=path.name, why="it cannot be read"
            )
        return told[-1].proof

    async def close(self) -> None:
        """End the worker; its field goes on at the next start."""
        if self._worker is not None:
            with contextlib.suppress(ProcessLookupError):
                self._worker[1].kill()

    async def _prepare(self, job: FieldJob) -> None:
        """Run workers until it is done, failed, or paused."""
        self._ended.clear()
        try:
            problem = await self._until_done(job)
        except OSError as error:
            problem = not_written(job.order.name, error.strerror or str(error))
        finally:
            self._ended.set()
        if not job.is_running():
            return  # paused or removed meanwhile
        if problem is not None:
            job.problem = problem
            self._report(problem)
            await self._enter(job, "failed")

    async def _until_done(self, job: FieldJob) -> GatewayError | None:
        tries, arrived = 0, -1
        while job.is_running():
            last = FieldLine()

            def hear(line: FieldLine) -> None:
                nonlocal last
                last = line
                if line.progress is not None and job.is_running():
                    job.hear(line.progress)
                    self._tell(job)

            problem = await self._work(
                Prepare(str(job.folder), self._maps.online.consent.servers),
                hear,
                lambda process: self._started(job, process),
            )
            if not job.is_running():
                return None
            if problem is not None:
                return problem
            if last.is_done:
                return await self._take_in(job)
            # It was killed: it goes on, unless that comes to nothing.
            tries = 0 if job.progress.tiles > arrived else tries + 1
            arrived = job.progress.tiles
            if tries >= _MOST_STARTS:
                return ConflictError(
                    "field_worker_died",
                    f"The preparation of '{job.order.name}' ended {_MOST_STARTS} times without a reason: the "
                    "memory may not suffice. Choose a smaller area, then go on.",
                    name=job.order.name,
                )
            log.warning("the worker of a field ended", name=job.order.name)
            await asyncio.sleep(_PAUSE_S)
        return None

    async def _take_in(self, job: FieldJob) -> GatewayError | None:
        pack = job.folder / PACK
        named = pack.with_name(job.file_name)

        def take() -> str:
            target = self._maps.folder.path / job.file_name
            # A run that was killed in just that moment has taken it in already: the same tiles make the same bytes.
            if target.exists() and filecmp.cmp(target, pack, shallow=False):
                return id_of(job.file_name)
            pack.replace(named)
            return self._maps.folder.take_in(named).id

        try:
            job.layer = await self._maps.in_thread(take)
        except GatewayError as error:
            return error
        except OSError as error:
            return not_written(job.order.name, error.strerror or str(error))
        with contextlib.suppress(OSError):
            await self._maps.in_thread(job.drop)
        job.progress = replace(job.progress, doing="done", percent=None, bytes_total=job.progress.bytes)
        job.state = "done"
        self._forget_old()
        self._tell(job)
        return None

    async def _work(
        self,
        asked: Work,
        hear: Callable[[FieldLine], None],
        started: Callable[[asyncio.subprocess.Process], None],
    ) -> GatewayError | None:
        """Run a worker to its end; the problem that it told. Raises OSError."""
        pipe = asyncio.subprocess.PIPE
        async with child(sys.executable, "-m", _WORKER, stdin=pipe, stdout=pipe) as process:
            started(process)
            if process.stdin is not None:
                # Stdin stays open: the worker ends when the station does, however that ends.
                process.stdin.write(msgspec.json.encode(asked) + b"\n")
            problem = await hear_lines(process, FieldLine, hear, ConflictError)
            await process.wait()
        return problem

    def _started(self, job: FieldJob, process: asyncio.subprocess.Process) -> None:
        self._worker = (job.id, process)

    async def _end_worker(self, job: FieldJob) -> None:
        """Kill this field's worker and wait for its end: what arrived is in the file already."""
        if self._worker is not None and self._worker[0] == job.id:
            with contextlib.suppress(ProcessLookupError):
                self._worker[1].kill()
            await self._ended.wait()

    async def _enter(self, job: FieldJob, state: FieldState) -> None:
        job.state = state
        await self._write_state(job)
        self._tell(job)

    async def _write_state(self, job: FieldJob) -> None:
        try:
            await self._maps.in_thread(job.write_state)
        except OSError as error:
            self._report(not_written(job.order.name, error.strerror or str(error)))

    def _forget_old(self) -> None:
        done = [one.id for one in self._all.values() if one.state == "done"]
        for old in done[:-_MOST_KEPT]:
            del self._all[old]

    def _get(self, field_id: str) -> FieldJob:
        found = self._all.get(field_id)
        if found is None:
            raise NotFoundError("field_unknown", f"There is no field '{field_id}' under way.", id=field_id)
        return found

    def _tell(self, job: FieldJob) -> None:
        self._say("map_field", job.told)


def _is_not(job: FieldJob) -> ConflictError:
    return ConflictError(
        "field_not_in_state",
        f"'{job.order.name}' is {job.state}: look at it again.",
        name=job.order.name,
        state=job.state,
    )
