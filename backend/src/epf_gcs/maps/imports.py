"""Uploads of map files: written as they arrive; in the end the folder has the complete file or nothing."""

from __future__ import annotations

import asyncio
import contextlib
import secrets
import shutil
from collections.abc import AsyncIterator, Callable
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Final

from epf_gcs.contract.events import Say
from epf_gcs.contract.maps import ImportState, MapImport, problem_parts
from epf_gcs.errors import ConflictError, GatewayError, NotFoundError
from epf_gcs.maps.files import RASTERS, MapFile, safe_name
from epf_gcs.maps.folder import MapFolder, exists
from epf_gcs.maps.layer import Datum
from epf_gcs.maps.terrain_jobs import TerrainJobs, ThreadRunner

INCOMING: Final = ".incoming"
RESERVE_BYTES: Final = 200_000_000
"""Disk space that imports leave free, so that a map never stops the recording of a flight."""

_KEPT: Final = 20
_PIECE_BYTES: Final = 1 << 20
_TELL_EVERY_S: Final = 0.25


@dataclass(slots=True)
class Import:
    """One upload. `layer` is the layer's id once the file is in the folder."""

    id: str
    name: str
    total_bytes: int | None
    state: ImportState = "receiving"
    bytes: int = 0
    percent: int | None = None
    layer: str | None = None
    problem: GatewayError | None = None
    cancelled: bool = False

    @property
    def told(self) -> MapImport:
        """As the interface gives it."""
        return MapImport(
            *problem_parts(self.problem),
            id=self.id,
            name=self.name,
            state=self.state,
            bytes=self.bytes,
            total_bytes=self.total_bytes,
            percent=self.percent,
            layer=self.layer,
        )


class Imports:
    """Owned by the event loop; the maps' threads write to the disk."""

    def __init__(
        self,
        folder: MapFolder,
        jobs: TerrainJobs,
        in_thread: ThreadRunner,
        say: Say,
        free_bytes: Callable[[Path], int] = lambda path: shutil.disk_usage(path).free,
    ) -> None:
        self._folder = folder
        self._jobs = jobs
        self._in_thread = in_thread
        self._say = say
        self._free_bytes = free_bytes
        self._loop = asyncio.get_running_loop()
        self._all: dict[str, Import] = {}
        self._converting: dict[str, tuple[Import, MapFile]] = {}
        self._told_s: dict[str, float] = {}
        jobs.told = self._on_percent
        jobs.ended = self._on_ended

    def get(self, import_id: str) -> Import:
        """One of the last imports. Raises NotFoundError."""
        found = self._all.get(import_id)
        if found is None:
            raise NotFoundError(
                "map_import_unknown",
                f"There is no import '{import_id}': only the last {_KEPT} are remembered.",
                id=import_id,
            )
        return found

    async def receive(
        self, name: str, total_bytes: int | None, chunks: AsyncIterator[bytes], datum: Datum | None = None
    ) -> Import:
        """Receive a file. `datum`: what its heights count from. Raises GatewayError if it cannot be stored or is no
        map, and then leaves nothing behind."""
        cleaned = safe_name(name)
        busy = [one for one in self._all.values() if one.state in ("receiving", "converting")]
        if any(one.name == cleaned for one in busy) or await self._in_thread((self._folder.path / cleaned).exists):
            raise exists(cleaned)
        one = Import(secrets.token_hex(6), cleaned, total_bytes)
        self._remember(one)
        folder = self._folder.path / INCOMING / one.id
        try:
            await self._in_thread(lambda: folder.mkdir(parents=True))
            await self._write(one, folder / cleaned, chunks)
            file = await self._in_thread(self._folder.take_in, folder / cleaned)
            if datum is not None:
                await self._in_thread(self._folder.choose_datum, file.id, datum)
        except BaseException as error:
            one.problem = _reason(cleaned, error)
            self._enter(one, "failed")
            if isinstance(error, OSError):
                raise one.problem from error
            raise
        finally:
            # Shielded: also when the browser disconnected and this task is being cancelled.
            await asyncio.shield(self._in_thread(lambda: shutil.rmtree(folder, ignore_errors=True)))
        one.layer = file.id
        if file.format in RASTERS:
            one.percent = 0
            self._converting[file.id] = (one, file)
            self._enter(one, "converting")
            self._jobs.wake()
        else:
            self._enter(one, "done")
        return one

    async def cancel(self, import_id: str) -> Import:
        """Cancel an import and delete its file. A finished import is not changed. Raises NotFoundError."""
        one = self.get(import_id)
        if one.state == "receiving":
            one.cancelled = True
        elif one.state == "converting" and one.layer is not None:
            _, file = self._converting.pop(one.layer)
            one.problem = _cancelled(one.name)
            self._jobs.cancel(file)
            await self._in_thread(self._folder.discard, file)
            one.layer = None
            self._enter(one, "failed")
        return one

    async def _write(self, one: Import, path: Path, chunks: AsyncIterator[bytes]) -> None:
        await self._check_room(one, (one.total_bytes or 0) + RESERVE_BYTES)
        file: IO[bytes] = await self._in_thread(lambda: path.open("xb"))
        try:
            held = bytearray()
            async for chunk in chunks:
                if one.cancelled:
                    raise _cancelled(one.name)
                held += chunk
                one.bytes += len(chunk)
                if len(held) >= _PIECE_BYTES:
                    await self._put(one, file, held)
            await self._put(one, file, held)
        finally:
            await asyncio.shield(self._in_thread(file.close))

    async def _put(self, one: Import, file: IO[bytes], held: bytearray) -> None:
        data = bytes(held)
        held.clear()
        await self._check_room(one, len(data) + RESERVE_BYTES)
        await self._in_thread(file.write, data)
        if one.total_bytes:
            one.percent = min(100, one.bytes * 100 // one.total_bytes)
        if self._loop.time() - self._told_s.get(one.id, 0.0) >= _TELL_EVERY_S:
            self._tell(one)

    async def _check_room(self, one: Import, needed_bytes: int) -> None:
        free_bytes = await self._in_thread(self._free_bytes, self._folder.path)
        if free_bytes < needed_bytes:
            raise ConflictError(
                "map_disk_full",
                f"'{one.name}' does not fit: {free_bytes // 1_000_000} MB are free, and "
                f"{RESERVE_BYTES // 1_000_000} MB of them are kept for recordings. Free the disk.",
                name=one.name,
                free_mb=free_bytes // 1_000_000,
                reserve_mb=RESERVE_BYTES // 1_000_000,
            )

    def _on_percent(self, file: MapFile, percent: int) -> None:
        found = self._converting.get(file.id)
        if found is not None:
            found[0].percent = percent
            if self._loop.time() - self._told_s.get(found[0].id, 0.0) >= _TELL_EVERY_S:
                self._tell(found[0])

    async def _on_ended(self, file: MapFile, problem: GatewayError | None) -> None:
        found = self._converting.pop(file.id, None)
        if found is None:
            return
        one, raster = found
        if problem is None:
            one.percent = 100
            self._enter(one, "done")
            return
        one.problem, one.layer = problem, None
        with contextlib.suppress(OSError):
            await self._in_thread(self._folder.discard, raster)
        self._enter(one, "failed")

    def _remember(self, one: Import) -> None:
        self._all[one.id] = one
        over = [old.id for old in self._all.values() if old.state in ("done", "failed")]
        for old in over[: max(0, len(self._all) - _KEPT)]:
            del self._all[old]
            self._told_s.pop(old, None)
        self._tell(one)

    def _enter(self, one: Import, state: ImportState) -> None:
        one.state = state
        self._tell(one)

    def _tell(self, one: Import) -> None:
        self._told_s[one.id] = self._loop.time()
        self._say("map_import", one.told)


def _cancelled(name: str) -> ConflictError:
    return ConflictError("map_import_incomplete", f"'{name}' did not come whole: nothing of it was kept.", name=name)


def _reason(name: str, error: BaseException) -> GatewayError:
    if isinstance(error, GatewayError):
        return error
    if isinstance(error, OSError):
        why = error.strerror or str(error)
        return ConflictError(
            "map_not_written",
            f"'{name}' could not be written ({why}): correct the permissions of the maps' folder.",
            name=name,
            why=why,
        )
    return _cancelled(name)
