"""Recordings from other machines: received whole or not at all, checked by a worker program, then part of the library.

What a stranger's file says is believed nowhere: the worker reads it within limits and writes what it found anew.
"""

from __future__ import annotations

import asyncio
import secrets
import shutil
from collections.abc import AsyncIterator, Awaitable
from pathlib import Path
from typing import IO, Final

from epf_gcs.errors import ConflictError, GatewayError, InvalidInputError
from epf_gcs.library.about import About, write_about
from epf_gcs.library.flights import Flights
from epf_gcs.library.jobs import Job, JobAnswer
from epf_gcs.recordings.places import free_id
from epf_gcs.shares.holder import Holder

MOST_BYTES: Final = 8_000_000_000
RESERVE_BYTES: Final = 1_500_000_000
"""Space that imports leave free, so that no file of another machine ever stops the recording of a flight."""
_PIECE_BYTES: Final = 1 << 20
_LONGEST_TITLE: Final = 200
_LONGEST_DAMAGE: Final = 2000


def most_import_bytes(free_bytes: int | None) -> int:
    """The largest file that is taken in with so much space on the disk (None: not known)."""
    if free_bytes is None:
        return MOST_BYTES
    # Twice, for the checked file is written beside the one that came.
    return max(0, min(MOST_BYTES, (free_bytes - RESERVE_BYTES) // 2))


class FlightImports:
    """Owned by the event loop."""

    def __init__(self, flights: Flights) -> None:
        self._flights = flights
        self._cleaning: set[asyncio.Task[None]] = set()

    async def receive(self, name: str, total_bytes: int | None, chunks: AsyncIterator[bytes], by: Holder) -> Job:
        """Take a file; returns the job that checks it. Raises GatewayError, and then leaves nothing behind."""
        folder = self._flights.places.incoming / secrets.token_hex(6)
        came, checked = folder / "came.mcap", folder / "checked.mcap"
        try:
            await self._flights.in_thread(lambda: folder.mkdir(parents=True))
            await self._write(name, came, total_bytes, chunks)
            job = self._flights.jobs.start(
                "import",
                [str(came), str(checked)],
                by=by,
                flight=None,
                then=lambda job: self._take_in(job, checked, name),
            )
        except BaseException as error:
            await asyncio.shield(self._remove(folder))
            if isinstance(error, OSError):
                why = error.strerror or str(error)
                raise ConflictError(
                    "flight_not_written", f"'{name}' could not be written ({why}): free the disk.", why=why
                ) from error
            raise
        cleaning = asyncio.create_task(self._remove_after(job, folder))
        self._cleaning.add(cleaning)
        cleaning.add_done_callback(self._cleaning.discard)
        return job

    async def _remove_after(self, job: Job, folder: Path) -> None:
        await job.ended.wait()
        await self._remove(folder)

    def _remove(self, folder: Path) -> Awaitable[None]:
        return asyncio.ensure_future(self._flights.in_thread(lambda: shutil.rmtree(folder, ignore_errors=True)))

    async def _write(self, name: str, path: Path, total_bytes: int | None, chunks: AsyncIterator[bytes]) -> None:
        if total_bytes is not None and total_bytes > MOST_BYTES:
            raise _too_large(name)
        # As in `most_import_bytes`: which of both is the reason is said.
        await self._check_room(name, 2 * (total_bytes or 0))
        file: IO[bytes] = await self._flights.in_thread(lambda: path.open("xb"))
        size = 0
        try:
            held = bytearray()
            async for chunk in chunks:
                held += chunk
                size += len(chunk)
                if size > MOST_BYTES:
                    raise _too_large(name)
                if len(held) >= _PIECE_BYTES:
                    await self._check_room(name, size)
                    await self._flights.in_thread(file.write, bytes(held))
                    held.clear()
            await self._flights.in_thread(file.write, bytes(held))
        finally:
            await asyncio.shield(self._flights.in_thread(file.close))

    async def _check_room(self, name: str, needed_bytes: int) -> None:
        free_bytes = await self._flights.free_bytes()
        if free_bytes is not None and free_bytes < needed_bytes + RESERVE_BYTES:
            raise ConflictError(
                "flight_disk_full",
                f"'{name}' does not fit: {free_bytes // 1_000_000} MB are free, and {RESERVE_BYTES // 1_000_000} MB of "
                "them are kept for flights. Free the disk.",
                name=name,
                free_mb=free_bytes // 1_000_000,
                reserve_mb=RESERVE_BYTES // 1_000_000,
            )

    async def _take_in(self, job: Job, checked: Path, name: str) -> None:
        """Give the checked recording an id and a place. Raises GatewayError, OSError."""
        answer = job.answer or JobAnswer()
        known = await self._flights.with_fingerprint(answer.fingerprint)
        if known is not None:
            raise ConflictError("flight_known", f"'{name}' is the flight '{known}' of the library.", flight=known)
        job.flight = await self._flights.in_thread(self._place, answer, checked, name)
        self._flights.wake()

    def _place(self, answer: JobAnswer, checked: Path, name: str) -> str:
        places = self._flights.places
        taken = {path.stem for folder in (places.recordings, places.bin) for path in folder.glob("*.mcap")}
        flight = free_id(answer.started_ns, taken)
        title = name.removesuffix(".mcap")[:_LONGEST_TITLE]
        places.recordings.mkdir(parents=True, exist_ok=True)
        write_about(places.about(flight), _about(flight, title, answer))
        checked.replace(places.recording(flight))
        return flight


def _about(flight: str, title: str, answer: JobAnswer) -> About:
    damage = (answer.damage or "")[:_LONGEST_DAMAGE]
    return About(title="" if title == flight else title, imported=True, came_damaged=damage, log=answer.log)


def _too_large(name: str) -> GatewayError:
    return InvalidInputError("recording_too_large", f"'{name}' is larger than {MOST_BYTES} bytes.", most=MOST_BYTES)


def incomplete(name: str) -> GatewayError:
    """The upload ended early."""
    return ConflictError("flight_import_incomplete", f"'{name}' did not come whole: nothing of it was kept.", name=name)
