"""All parts of the maps: the folder, the conversion to terrain, imports, online sources."""

from __future__ import annotations

import asyncio
import shutil
from collections.abc import Awaitable, Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, Final

from epf_gcs.clock import Clock
from epf_gcs.contract.events import Say
from epf_gcs.errors import GatewayError
from epf_gcs.maps.folder import MapFolder, not_deleted, unknown
from epf_gcs.maps.imports import INCOMING, Imports
from epf_gcs.maps.layer import Datum, Description, Layer, Tile
from epf_gcs.maps.online import Online
from epf_gcs.maps.online_file import OnlineFile
from epf_gcs.maps.open_files import Stamp
from epf_gcs.maps.terrain_jobs import T, TerrainJobs

# Threads for maps only: a slow memory stick delays other maps and nothing else.
_THREADS: Final = 3
TILES: Final = ".online-tiles.sqlite"


class Maps:
    """Constructed on the running loop; keeps its files in the folder `maps` of `data_dir`."""

    def __init__(self, data_dir: Path, say: Say, clock: Clock, report: Callable[[GatewayError], None]) -> None:
        path = data_dir / "maps"
        chosen = OnlineFile(data_dir, lambda error: self._tell(report, error))
        self._loop = asyncio.get_running_loop()
        self._threads = ThreadPoolExecutor(_THREADS, thread_name_prefix="maps")
        self.folder = MapFolder(path, lambda error: self._tell(report, error))
        self._listing: asyncio.Future[list[Layer]] | None = None
        self._jobs = TerrainJobs(self.folder, self.in_thread, report)
        self.imports = Imports(self.folder, self._jobs, self.in_thread, say)
        self.online = Online(
            path / TILES,
            chosen.read(),
            chosen.write,
            report,
            clock.now_s,
        )

    async def run(self) -> None:
        """Delete unfinished files of an earlier run, then convert rasters to terrain, forever."""
        await self.in_thread(self._prepare)
        await self._jobs.run()

    async def layers(self) -> list[Layer]:
        """All layers, of files and of online sources."""
        # Scanning the folder may take long: callers meanwhile share one scan and occupy no further thread.
        if self._listing is None or self._listing.done():
            self._listing = asyncio.ensure_future(self.in_thread(self.folder.layers))
        found = await asyncio.shield(self._listing)
        if any(layer.problem is not None and layer.problem.code == "map_raster_converting" for layer in found):
            self._jobs.wake()
        return [*found, *self.online.layers()]

    async def picture(self, layer_id: str, zoom: int, column: int, row: int) -> tuple[Tile | None, Stamp]:
        """One picture or tile of roads, rows from the north; None if there is none. Raises NotFoundError, or why it
        cannot be read."""
        if self.online.has(layer_id):
            return await self.online.tile(layer_id, zoom, column, row)
        tile, description, stamp = await self.in_thread(self.folder.tile, layer_id, zoom, column, row)
        return (None if description.kind == "terrain" else tile), stamp

    async def terrain(self, layer_id: str, zoom: int, column: int, row: int) -> tuple[Tile | None, Stamp]:
        """One tile of terrain, rows in the scheme of its layer.json, heights above the sea. Raises as `picture`."""
        tile, description, stamp = await self.in_thread(self.folder.tile, layer_id, zoom, column, row)
        return (tile if description.kind == "terrain" else None), stamp

    async def terrain_layers(self) -> list[Layer]:
        """The layers of terrain that can be read, the finest first."""
        found = [one for one in await self.layers() if one.description.kind == "terrain" and one.problem is None]
        return sorted(found, key=lambda one: -one.description.maximum_zoom)

    async def grid(self, layer_id: str, zoom: int, column: int, row: int) -> bytes | None:
        """The heights of one tile of terrain (`formats.quantized_mesh_reading`), rows from the south; None if there is
        none. Raises NotFoundError, or why it cannot be read."""
        return await self.in_thread(self.folder.grid, layer_id, zoom, column, row)

    async def description(self, layer_id: str) -> Description:
        """A layer's description. Raises NotFoundError, or why it cannot be read."""
        return await self.in_thread(self.folder.description, layer_id)

    async def datum(self, layer_id: str) -> Datum | None:
        """What a layer's heights count from; None: not known. Raises as `description`."""
        return await self.in_thread(self.folder.datum, layer_id)

    async def choose_datum(self, layer_id: str, datum: Datum) -> None:
        """Say what a layer's heights count from. Raises NotFoundError, ConflictError."""
        await self.in_thread(self.folder.choose_datum, layer_id, datum)

    async def remove(self, layer_id: str) -> None:
        """Take a map out of the list; it can be restored. Raises NotFoundError."""
        await self.in_thread(self.folder.remove, layer_id)

    async def delete(self, layer_id: str) -> None:
        """Delete a map's file for good. Raises NotFoundError, ConflictError."""
        try:
            await self.in_thread(self.folder.delete, layer_id)
        except OSError as error:
            raise not_deleted(layer_id, error) from error

    async def file_of(self, layer_id: str) -> Path:
        """The path of a layer's file. Raises NotFoundError if it is none, or no layer of a file."""
        path = None if self.online.has(layer_id) else await self.in_thread(self.folder.file_of, layer_id)
        if path is None:
            raise unknown(layer_id)
        return path

    async def restore(self, layer_id: str) -> None:
        """Bring a removed map back. Raises NotFoundError, ConflictError."""
        await self.in_thread(self.folder.restore, layer_id)

    async def close(self) -> None:
        """Close everything; waits for reads under way."""
        await self.online.close()
        await asyncio.to_thread(self._threads.shutdown)
        self.folder.close()

    def in_thread(self, work: Callable[..., T], /, *values: Any) -> Awaitable[T]:
        """Run blocking work on the maps' files in a thread of theirs."""
        return self._loop.run_in_executor(self._threads, work, *values)

    def _prepare(self) -> None:
        """Create the folder, so that people find where to put files, and delete leftovers."""
        try:
            self.folder.path.mkdir(parents=True, exist_ok=True)
            shutil.rmtree(self.folder.path / INCOMING, ignore_errors=True)
            self.folder.drop_orphans()
        except OSError:
            # Reported when the layers are listed.
            return

    def _tell(self, report: Callable[[GatewayError], None], error: GatewayError) -> None:
        if not self._loop.is_closed():
            self._loop.call_soon_threadsafe(report, error)
