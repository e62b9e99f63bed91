"""The flights of this station: their library, the jobs that prepare them, the bin, and the room on the disk."""

from __future__ import annotations

import asyncio
import contextlib
import shutil
from collections.abc import Awaitable, Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from typing import Any, Final, Literal, TypeVar

import structlog

from epf_gcs.clock import Clock
from epf_gcs.contract.answers import DiskPolicy
from epf_gcs.errors import ConflictError, GatewayError
from epf_gcs.extras import FLIGHTS
from epf_gcs.library.about import About
from epf_gcs.library.aircraft import AircraftNameChoice
from epf_gcs.library.folder import BinEntry, FlightFolder, unknown
from epf_gcs.library.jobs import Job, Jobs
from epf_gcs.library.library import Library, Row
from epf_gcs.library.policy import PolicyChoice
from epf_gcs.library.query import FlightQuery, LibraryWords
from epf_gcs.recordings.places import Places
from epf_gcs.shares.holder import STATION

# How often the folder is looked at for what other programs put there or took away.
_LOOK_EVERY_S: Final = 30.0
_ROOM_EVERY_S: Final = 60.0
# Flights whose bytes and seconds give the rate by which the hours left are judged.
_JUDGED_BY: Final = 5
# Work that the disk refused is tried again after so long: it may have room by then.
_AGAIN_S: Final = 600.0
_REFUSED: Final = ("flight_disk_full", "flight_not_written")
_WORTH_KEYS_NS: Final = 60_000_000_000
_KEYS_RESERVE_BYTES: Final = 1_200_000_000
# How long the file that a job made waits to be fetched.
_RESULT_KEPT_S: Final = 3600.0

T = TypeVar("T")
log = structlog.get_logger("web")


@dataclass(frozen=True, slots=True)
class FlightsInUse:
    """`growing` gives the id of the flight that is being recorded, or None; `is_known` says whether that is certain:
    without the flight process no recording is prepared, for one of them may still be written. `looked_at` gives the
    flights that are replayed now: none of them is deleted to make room.
    """

    growing: Callable[[], str | None]
    is_known: Callable[[], bool]
    looked_at: Callable[[], set[str]]


class Flights:
    """Owned by the event loop; one thread of its own reads and writes the disk."""

    def __init__(
        self,
        places: Places,
        jobs: Jobs,
        clock: Clock,
        in_use: FlightsInUse,
        *,
        policy: PolicyChoice,
        aircraft: AircraftNameChoice,
        report: Callable[[GatewayError], None],
    ) -> None:
        self.places = places
        self.jobs = jobs
        self._clock = clock
        self._policy = policy
        self.aircraft = aircraft
        self._in_use = in_use
        self._report = report
        self._library = Library(places)
        self._folder = FlightFolder(places)
        self._thread = ThreadPoolExecutor(1, thread_name_prefix="flights")
        self._loop = asyncio.get_running_loop()
        self._awake = asyncio.Event()
        self._was: tuple[bool, str | None] = (False, None)
        self._left_alone: set[str] = set()
        self._again_at_s: dict[str, float] = {}
        self._room_at_s = 0.0
        # Until when it is believed, on the loop's clock, and the bytes that all flights take.
        self._used = (0.0, 0)
        self._preparing: Job | None = None

    @property
    def growing(self) -> str | None:
        """The flight that is being recorded."""
        return self._in_use.growing()

    async def run(self) -> None:
        """Prepare flights one after the other, forever."""
        await self.in_thread(self._tidy_up)
        while True:
            self._awake.clear()
            with contextlib.suppress(OSError):
                await self.in_thread(self._library.refresh, self.growing)
                await self._make_room()
                await self._prepare()
            with contextlib.suppress(TimeoutError):
                async with asyncio.timeout(_LOOK_EVERY_S):
                    await self._awake.wait()

    async def close(self) -> None:
        """Stop all jobs and close the library."""
        await self.jobs.close()
        await self.in_thread(self._library.close)
        await asyncio.to_thread(self._thread.shutdown)

    def wake(self) -> None:
        """Look at the recordings now."""
        self._awake.set()

    def status_changed(self) -> None:
        """Look at the recordings when one began or ended, and when the flight process came or went."""
        now = (self._in_use.is_known(), self._in_use.growing())
        if now != self._was:
            self._was = now
            self.wake()

    async def search(self, wanted: FlightQuery) -> tuple[list[Row], int]:
        """One page of the flights as the files are now, and the number of all."""
        await self._refresh()
        return await self.in_thread(self._library.search, wanted)

    async def all(self) -> list[Row]:
        """All flights, oldest first."""
        return await self.in_thread(self._library.all)

    async def words(self) -> LibraryWords:
        """What the list may be narrowed by, and the files whose names are no flight's."""
        return await self.in_thread(self._library.words)

    async def get(self, flight: str) -> Row:
        """One flight. Raises NotFoundError."""
        found = await self.in_thread(self._library.get, flight)
        if found is None:
            await self._refresh()
            found = await self.in_thread(self._library.get, flight)
        if found is None:
            raise unknown(flight)
        return found

    async def say(self, flight: str, change: Callable[[About], About]) -> Row:
        """Change what people say of a flight. Raises NotFoundError, and ConflictError where the disk refuses."""
        row = await self.get(flight)
        await self._writing(self._library.say, flight, change(replace(row.about)))
        return await self.get(flight)

    async def delete(self, flight: str) -> None:
        """Move a flight to the bin. Raises NotFoundError, and ConflictError while it is recorded."""
        await self.get(flight)
        if flight == self.growing:
            raise ConflictError(
                "flight_recording", f"The flight '{flight}' is being recorded: end it first.", flight=flight
            )
        await self._stop_work_on(flight)
        await self._writing(self._folder.delete, flight, self._clock.now_s())
        await self.in_thread(self._library.forget, flight)

    async def restore(self, flight: str) -> Row:
        """Bring a flight back from the bin. Raises NotFoundError, ConflictError."""
        await self._writing(self._folder.restore, flight)
        self._left_alone.discard(flight)
        await self._refresh()
        self.wake()
        return await self.get(flight)

    async def bin(self) -> list[BinEntry]:
        """What lies in the bin."""
        return await self.in_thread(self._folder.bin)

    async def index_again(self, flight: str) -> Row:
        """Make everything that is made of a recording again. Raises NotFoundError, ConflictError."""
        await self.get(flight)
        await self._stop_work_on(flight)
        self._left_alone.discard(flight)
        self._again_at_s.pop(flight, None)
        await self._writing(self._folder.drop_made, flight)
        await self.in_thread(self._library.forget, flight)
        await self._refresh()
        self.wake()
        return await self.get(flight)

    async def cancel(self, job: Job) -> None:
        """Stop a job; a flight that it was to prepare is left alone until somebody asks for its index again."""
        if job.kind in ("pack", "index") and job.flight is not None and not job.is_over:
            self._left_alone.add(job.flight)
        await self.jobs.cancel(job)

    async def with_fingerprint(self, fingerprint: str) -> str | None:
        """The flight with this content; None if there is none."""
        return await self.in_thread(self._library.with_fingerprint, fingerprint)

    async def policy(self) -> DiskPolicy:
        """What happens when the disk fills."""
        return await self._policy.now()

    async def set_policy(self, policy: DiskPolicy) -> None:
        """Choose what happens when the disk fills. Raises GatewayError while the flight process is away."""
        await self._policy.choose(policy)
        self._room_at_s = 0.0
        self.wake()

    async def room(self) -> tuple[int | None, float | None]:
        """Free bytes, and the hours of flight for which they last; None where that is not known."""
        free_bytes = await self.free_bytes()
        rows = await self.in_thread(self._library.newest, _JUDGED_BY)
        made = await self.in_thread(lambda: sum(self._folder.made_bytes(row.id) for row in rows))
        recorded = made + sum(row.bytes for row in rows)
        duration_ns = sum(row.summary.duration_ns for row in rows if row.summary)
        if free_bytes is None or not recorded:
            return free_bytes, None
        return free_bytes, free_bytes / recorded * duration_ns / 3.6e12

    async def used_bytes(self) -> int:
        """What all flights take of the disk, as it was found lately."""
        now_s = self._loop.time()
        if now_s >= self._used[0]:
            self._used = now_s + _ROOM_EVERY_S, await self.in_thread(self._folder.used_bytes)
        return self._used[1]

    async def free_bytes(self) -> int | None:
        """Free space on the disk of the recordings; None if it cannot be measured."""
        try:
            return await self.in_thread(self._folder.free_bytes)
        except OSError:
            return None

    def preparing(self, flight: str) -> bool:
        """Whether the flight is being prepared now."""
        return (job := self._preparing) is not None and job.flight == flight and not job.is_over

    def in_thread(self, work: Callable[..., T], /, *values: Any) -> Awaitable[T]:
        """Run blocking work in the flights' thread."""
        return self._loop.run_in_executor(self._thread, work, *values)

    async def _writing(self, work: Callable[..., T], /, *values: Any) -> T:
        try:
            return await self.in_thread(work, *values)
        except OSError as error:
            why = error.strerror or str(error)
            raise ConflictError(
                "flight_not_written",
                f"The flights' folder could not be changed ({why}): free the disk or correct its permissions.",
                why=why,
            ) from error

    async def _refresh(self) -> None:
        with contextlib.suppress(OSError):
            await self.in_thread(self._library.refresh, self.growing)

    async def _prepare(self) -> None:
        """Pack and index every flight that is not yet, newest first: it is looked for first."""
        tried: set[str] = set()
        while self._in_use.is_known():
            rows = await self.in_thread(self._library.waiting)
            waiting = [row for row in rows if self._must_prepare(row) and row.id not in tried]
            if not waiting:
                return
            tried.add(waiting[0].id)
            await self._prepare_one(waiting[0].id)

    def _must_prepare(self, row: Row) -> bool:
        is_wrong = row.fault is not None and not (row.fault.code == "extra_missing" and FLIGHTS.is_here)
        is_due = self._loop.time() >= self._again_at_s.get(row.id, 0.0)
        return not is_wrong and row.id != self.growing and row.id not in self._left_alone and is_due

    async def _prepare_one(self, flight: str) -> None:
        path = str(self.places.recording(flight))
        # What could not be packed is indexed as it is: packing only saves room.
        if (await self._work("pack", path, flight)).state == "cancelled":
            return
        try:
            job = await self._work("index", path, flight)
        except ConflictError as error:  # packages are missing: who looks at the flight is told
            await self.in_thread(self._library.refused, flight, error)
            return
        if job.fault is not None:
            self._report(job.fault)
            if job.fault.code in _REFUSED:  # nothing is wrong with the recording
                self._again_at_s[flight] = self._loop.time() + _AGAIN_S
                return
            await self.in_thread(self._library.refused, flight, job.fault)
        elif job.state == "done":
            await self._make_keys(flight)

    async def _make_keys(self, flight: str) -> None:
        """Begin to make the key frames of a flight that is worth it: a short one is soon played to any moment."""
        row = await self.in_thread(self._library.get, flight)
        free_bytes = await self.free_bytes()
        if row is None or row.summary is None or free_bytes is None or free_bytes < _KEYS_RESERVE_BYTES:
            return
        if row.summary.duration_ns >= _WORTH_KEYS_NS:
            files = ["--recording", str(self.places.recording(flight)), "--keys", str(self.places.keyframes(flight))]
            with contextlib.suppress(ConflictError):
                self.jobs.start("keys", files, by=STATION, flight=flight)

    async def _work(self, kind: Literal["pack", "index"], path: str, flight: str) -> Job:
        job = self._preparing = self.jobs.start(kind, [path], by=STATION, flight=flight)
        await job.ended.wait()
        await self.in_thread(self._folder.drop_half_packed, flight)
        await self._refresh()
        return job

    async def _stop_work_on(self, flight: str) -> None:
        self._left_alone.add(flight)
        for job in self.jobs.of(flight):
            await self.jobs.cancel(job)

    async def _make_room(self) -> None:
        """Remove what is old or belongs to nothing, and delete the oldest flights if the person allowed it."""
        now_s = self._loop.time()
        if now_s < self._room_at_s:
            return
        self._room_at_s = now_s + _ROOM_EVERY_S
        await self.in_thread(self._folder.purge, self._clock.now_s())
        await self.in_thread(self._folder.drop_orphans)
        self.jobs.drop_results(_RESULT_KEPT_S)
        policy = await self.policy()
        if not policy.delete_oldest or not self._in_use.is_known():
            return
        if await self.in_thread(self._folder.free_bytes) < policy.keep_free_bytes:
            self.jobs.drop_results(0.0)
        for flight in reversed(await self.bin()):
            if await self.in_thread(self._folder.free_bytes) >= policy.keep_free_bytes:
                return
            await self.in_thread(self._folder.remove_from_bin, flight.id)
            log.warning("the disk is full: a deleted flight was removed from the bin", flight=flight.id)
        for row in await self.all():
            if await self.in_thread(self._folder.free_bytes) >= policy.keep_free_bytes:
                return
            # The room of a file that is open comes back only when it is closed.
            if not row.about.pinned and row.id != self.growing and row.id not in self._in_use.looked_at():
                await self._stop_work_on(row.id)
                await self.in_thread(self._folder.remove, row.id)
                await self.in_thread(self._library.forget, row.id)
                log.warning("the disk is full: the oldest flight was deleted, as was chosen", flight=row.id)

    def _tidy_up(self) -> None:
        """Delete what an earlier run left half done."""
        for folder in (self.places.incoming, self.places.exports):
            shutil.rmtree(folder, ignore_errors=True)
        self._folder.drop_half_packed("*")
