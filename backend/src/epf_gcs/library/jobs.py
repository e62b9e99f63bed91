"""Jobs: work on recordings in separate programs, few at once, with progress, and stopped when asked.

A program ends with the web process, however that ends: it watches its standard input.
"""

from __future__ import annotations

import asyncio
import contextlib
import secrets
import sys
from collections.abc import Awaitable, Callable
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Final

import msgspec
import structlog

from epf_gcs.contract.events import Say
from epf_gcs.contract.flights import Fault, JobKind, JobResult, JobState, LogKind
from epf_gcs.contract.flights import Job as JobReport
from epf_gcs.errors import ConflictError, GatewayError, NotFoundError
from epf_gcs.extras import FLIGHTS
from epf_gcs.shares.holder import STATION, Holder
from epf_gcs.shares.places import Holdings, Shortage
from epf_gcs.shares.table import SHARES, Shares
from epf_gcs.shares.turns import Turns
from epf_gcs.workers.child import child
from epf_gcs.workers.lines import WorkerLine, hear_lines
from epf_gcs.workers.missing import require

_PROGRAM: Final = "epf_gcs.flights"
_NEED_TABLES: Final = frozenset({"index", "export", "report"})
_KEYS_PROGRAM: Final = ("epf_gcs.replay", "--make-keys")
_KEPT: Final = 30
_TELL_EVERY_S: Final = 0.25
_GRACE_S: Final = 3.0
_LONGEST_S: Final = 2 * 3600.0
_LONGEST_LINE: Final = 8_000_000
_OVER: Final = ("done", "failed", "cancelled")

log = structlog.get_logger("web")


class JobAnswer(msgspec.Struct):
    """What a job's program says at its end. An import: where the recording begins (Unix ns), its fingerprint, what is
    wrong with the file, and of which kind of program it is a log; a report, as JSON or as a page."""

    started_ns: int = 0
    fingerprint: str = ""
    damage: str | None = None
    log: LogKind | None = None
    report: msgspec.Raw = msgspec.Raw()
    page: str = ""


class JobLine(WorkerLine):
    """A line of a job's program."""

    progress: float = 0.0
    doing: str = ""
    done: JobAnswer | None = None


@dataclass(slots=True)
class Job:
    """One piece of work. `answer` is what the program said at its end; `result` is the file that it made."""

    id: str
    kind: JobKind
    flight: str | None
    by: Holder
    state: JobState = "waiting"
    progress: float = 0.0
    doing: str = "waiting"
    fault: GatewayError | None = None
    answer: JobAnswer | None = None
    then: Callable[[Job], Awaitable[None]] | None = None
    result: Path | None = None
    result_name: str = ""
    ended: asyncio.Event = field(default_factory=asyncio.Event)
    task: asyncio.Task[None] | None = None
    ended_s: float = 0.0

    @property
    def is_over(self) -> bool:
        """Whether it has ended, one way or the other."""
        return self.state in _OVER

    @property
    def told(self) -> JobReport:
        """As the interface gives it."""
        result = None
        if self.state == "done" and self.result is not None and self.result.exists():
            result = JobResult(self.result_name, self.result.stat().st_size)
        return JobReport(
            id=self.id,
            kind=self.kind,
            flight=self.flight,
            state=self.state,
            progress=self.progress,
            doing=self.doing,
            file=self.result_name or None,
            fault=None if self.fault is None else Fault.of(self.fault),
            result=result,
        )


class Jobs:
    """Owned by the event loop."""

    def __init__(self, say: Say, longest_s: float = _LONGEST_S, shares: Shares = SHARES) -> None:
        self._say = say
        self._loop = asyncio.get_running_loop()
        self._longest_s = longest_s
        self._jobs: dict[str, Job] = {}
        self._told_s: dict[str, float] = {}
        self._waiting: Holdings[str] = Holdings(shares.jobs_waiting)
        preparing, results = Turns(shares.preparing), Turns(shares.results)
        self._lanes: dict[JobKind, Turns] = {
            "pack": preparing,
            "index": preparing,
            "keys": Turns(shares.preparing),
            "import": preparing,
            "export": results,
            "report": results,
            "backup": results,
        }

    def all(self) -> list[Job]:
        """Jobs under way and the last that ended, newest first."""
        return list(reversed(self._jobs.values()))

    def get(self, job_id: str) -> Job:
        """One of them. Raises NotFoundError."""
        found = self._jobs.get(job_id)
        if found is None:
            raise NotFoundError(
                "job_unknown", f"There is no job '{job_id}': only the last {_KEPT} are remembered.", job=job_id
            )
        return found

    def of(self, flight: str) -> list[Job]:
        """The jobs of a flight that are not over."""
        return [job for job in self._jobs.values() if job.flight == flight and not job.is_over]

    def start(
        self,
        kind: JobKind,
        arguments: list[str],
        *,
        by: Holder,
        flight: str | None,
        result: Path | None = None,
        result_name: str = "",
        then: Callable[[Job], Awaitable[None]] | None = None,
        secret: str | None = None,
    ) -> Job:
        """Queue `python -m epf_gcs.flights KIND ARGUMENTS` (key frames: `epf_gcs.replay`), which writes `result`.

        `then` is awaited with the job's answer before the job counts as done; it may raise GatewayError or OSError.
        `secret` is one line that the program alone hears: it stands neither in its arguments nor in the job.
        Raises ConflictError while too many jobs are waiting, of all or of `by`, and where the kind needs packages that
        are not installed.
        """
        if kind in _NEED_TABLES:
            require(FLIGHTS)
        job = Job(secrets.token_hex(6), kind, flight, by, result=result, result_name=result_name, then=then)
        if by != STATION and (shortage := self._waiting.take(job.id, by)) is not None:
            raise _busy(shortage)
        self._remember(job)
        job.task = self._loop.create_task(self._run(job, arguments, secret), name=f"job {kind}")
        return job

    async def cancel(self, job: Job) -> None:
        """Stop it and wait until its program has gone. One that is over stays as it is."""
        if not job.is_over and job.task is not None:
            job.task.cancel()
            await job.ended.wait()

    def drop(self, job: Job) -> None:
        """Delete the file that a job made: it was fetched."""
        _drop(job)

    def drop_results(self, kept_s: float) -> None:
        """Delete the files that were made at least so long ago, whether they were fetched or not."""
        for job in self._jobs.values():
            is_old = job.is_over and self._loop.time() - job.ended_s >= kept_s
            if is_old and job.result is not None and job.result.exists():
                _drop(job)
                self._tell(job)

    async def close(self) -> None:
        """Stop all of them, and forget their results."""
        await asyncio.gather(*(self.cancel(job) for job in self._jobs.values()))
        for job in self._jobs.values():
            _drop(job)

    async def _run(self, job: Job, arguments: list[str], secret: str | None) -> None:
        try:
            async with self._lanes[job.kind].turn(job.by):
                self._waiting.leave(job.id)
                job.state = "running"
                self._tell(job)
                async with asyncio.timeout(self._longest_s):
                    await self._work(job, arguments, secret)
                if job.fault is None and job.then is not None:
                    await job.then(job)
                job.state = "done" if job.fault is None else "failed"
        except GatewayError as error:
            job.fault, job.state = error, "failed"
        except TimeoutError:
            job.fault, job.state = _failed(f"it took more than {self._longest_s / 60:.0f} minutes"), "failed"
        except OSError as error:
            job.fault, job.state = _failed(error.strerror or str(error)), "failed"
        except asyncio.CancelledError:
            job.state = "cancelled"
        finally:
            self._end(job)

    async def _work(self, job: Job, arguments: list[str], secret: str | None) -> None:
        async with child(
            sys.executable,
            "-m",
            *(_KEYS_PROGRAM if job.kind == "keys" else (_PROGRAM, job.kind)),
            *arguments,
            grace_s=_GRACE_S,
            stdin=asyncio.subprocess.PIPE,
            stdout=asyncio.subprocess.PIPE,
            limit=_LONGEST_LINE,
        ) as process:
            if secret is not None and process.stdin is not None:
                process.stdin.write(secret.encode() + b"\n")
            job.fault = await hear_lines(process, JobLine, partial(self._heard, job))
            code = await process.wait()
            if job.fault is None and (code != 0 or job.answer is None):
                log.error("a job failed", kind=job.kind, flight=job.flight, code=code)
                job.fault = _failed(f"its program ended with {code}")

    def _heard(self, job: Job, line: JobLine) -> None:
        if line.done is not None:
            job.answer = line.done
        else:
            job.progress, job.doing = line.progress, line.doing
            if self._loop.time() - self._told_s.get(job.id, 0.0) >= _TELL_EVERY_S:
                self._tell(job)

    def _end(self, job: Job) -> None:
        self._waiting.leave(job.id)
        if job.state == "done":
            job.progress = 1.0
        else:
            _drop(job)
        job.doing = job.state
        job.ended_s = self._loop.time()
        self._tell(job)
        job.ended.set()

    def _remember(self, job: Job) -> None:
        self._jobs[job.id] = job
        over = [old for old in self._jobs.values() if old.is_over]
        for old in over[: max(0, len(self._jobs) - _KEPT)]:
            _drop(old)
            del self._jobs[old.id]
            self._told_s.pop(old.id, None)
        self._tell(job)

    def _tell(self, job: Job) -> None:
        self._told_s[job.id] = self._loop.time()
        self._say("job", job.told)


def _drop(job: Job) -> None:
    if job.result is not None:
        with contextlib.suppress(OSError):
            job.result.unlink(missing_ok=True)


def _busy(shortage: Shortage) -> ConflictError:
    most = shortage.most
    if shortage.of == "own":
        detail = f"{most} of your jobs are waiting already: wait until one begins, or cancel one."
        return ConflictError("jobs_busy_own", detail, limit=most)
    return ConflictError("jobs_busy", f"{most} jobs are waiting already: try again when some have begun.", limit=most)


def _failed(why: str) -> GatewayError:
    return GatewayError("job_failed", f"The work on the recording failed ({why}).", why=why)
