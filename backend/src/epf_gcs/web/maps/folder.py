"""The maps' folder: what is in it, with the reason where something cannot be shown; its tiles; away and back again."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from threading import Lock
from typing import Final

from epf_gcs.errors import ConflictError, GatewayError, NotFoundError
from epf_gcs.web.maps import faults
from epf_gcs.web.maps.files import RASTERS, MapFile, folder_bytes, free_name, look_at
from epf_gcs.web.maps.layer import UNKNOWN, Description, Layer, Tile, TileSource
from epf_gcs.web.maps.mbtiles import MbTiles
from epf_gcs.web.maps.mesh_files import MeshFiles
from epf_gcs.web.maps.open_files import OpenFiles, Stamp
from epf_gcs.web.maps.pmtiles import PmTiles

REMOVED: Final = "removed"
TERRAIN: Final = ".terrain"
_MAX_ZOOM: Final = 30


class MapFolder:
    """Called from threads: it may wait for a disk. `report` hears once of each file that cannot be shown."""

    def __init__(self, path: Path, report: Callable[[GatewayError], None]) -> None:
        self.path = path
        # Why a raster is not terrain yet; set by who turns it into it.
        self.waiting: Callable[[MapFile], GatewayError] = lambda file: faults.converting(file.path.name, 0)
        self._report = report
        self._lock = Lock()
        self._opened = OpenFiles()
        self._files: dict[str, MapFile] = {}
        self._known: dict[str, tuple[Stamp, int, Description | GatewayError]] = {}

    def layers(self) -> list[Layer]:
        """Everything that looks like a map, by name. A raster without its terrain has a problem until it has."""
        with self._lock:
            self._files = {file.id: file for file in self._scan(self.path)}
            self._known = {key: known for key, known in self._known.items() if key in self._files}
            return [self._layer(file) for file in sorted(self._files.values(), key=lambda file: file.path.name)]

    def tile(self, layer_id: str, zoom: int, column: int, row: int) -> tuple[Tile | None, Description, Stamp]:
        """A tile, and what it belongs to. Raises NotFoundError, or why the file cannot be read."""
        file = self._find(layer_id)
        stamp = self._source_stamp(file)
        with self._opened.reading(layer_id, stamp, lambda: self._open(file)) as source:
            description = source.description
            wide = 2 if description.kind == "terrain" and description.projection == "EPSG:4326" else 1
            inside = 0 <= zoom <= _MAX_ZOOM and 0 <= column < wide << zoom and 0 <= row < 1 << zoom
            return (source.tile(zoom, column, row) if inside else None), description, stamp

    def description(self, layer_id: str) -> Description:
        """What a layer says of itself. Raises NotFoundError, or why the file cannot be read."""
        file = self._find(layer_id)
        with self._opened.reading(layer_id, self._source_stamp(file), lambda: self._open(file)) as source:
            return source.description

    def remove(self, layer_id: str) -> None:
        """Take a map out of the list; its file stays in a folder of its own."""
        file = self._find(layer_id)
        with self._lock:
            self._opened.forget(layer_id)
            removed = self.path / REMOVED
            removed.mkdir(exist_ok=True)
            older = removed / file.path.name
            if older.exists():
                older.rename(free_name(removed, file.path.name))
            file.path.rename(older)
            self._files.pop(layer_id, None)

    def restore(self, layer_id: str) -> None:
        """Bring back what was removed last under this id. Raises NotFoundError, ConflictError."""
        with self._lock:
            file = next((found for found in self._scan(self.path / REMOVED) if found.id == layer_id), None)
            if file is None:
                raise unknown(layer_id)
            target = self.path / file.path.name
            if target.exists():
                raise exists(file.path.name)
            file.path.rename(target)

    def terrain_of(self, file: MapFile) -> Path:
        """Where the tiles of a raster are kept; the name changes with the raster."""
        stamp = "-".join(f"{part:x}" for part in file.stamp)
        return self.path / TERRAIN / f"{file.id}-{stamp}.mbtiles"

    def unconverted(self) -> list[MapFile]:
        """Rasters whose terrain is not there yet."""
        with self._lock:
            files = self._scan(self.path)
        return [file for file in files if file.format in RASTERS and not self.terrain_of(file).exists()]

    def drop_orphans(self) -> None:
        """Delete terrain whose raster is gone for good. Raises OSError."""
        with self._lock:
            rasters = [*self._scan(self.path), *self._scan(self.path / REMOVED)]
        kept = {self.terrain_of(file) for file in rasters if file.format in RASTERS}
        for path in (self.path / TERRAIN).glob("*"):
            if path not in kept:
                path.unlink(missing_ok=True)

    def take_in(self, path: Path) -> MapFile:
        """Move a file that came from outside into the folder, if it can be shown. Raises why it cannot."""
        found = look_at(path)
        if found is None:
            raise faults.damaged(path.name, "?")
        if found.format not in RASTERS:
            _open_plain(found).close()
        with self._lock:
            target = self.path / path.name
            if target.exists():
                raise exists(path.name)
            path.rename(target)
        return found._replace(path=target)

    def discard(self, file: MapFile) -> None:
        """Delete a file that was taken in and turned out to be of no use. Raises OSError."""
        with self._lock:
            self._opened.forget(file.id)
            self._files.pop(file.id, None)
            file.path.unlink(missing_ok=True)

    def close(self) -> None:
        """Let all files go."""
        self._opened.close()

    def _scan(self, folder: Path) -> list[MapFile]:
        try:
            return [file for path in folder.iterdir() if path.name != REMOVED and (file := look_at(path)) is not None]
        except FileNotFoundError:
            return []
        except OSError as error:
            self._report(
                GatewayError(
                    "map_folder_unreadable",
                    f"The maps in {folder} cannot be read ({error.strerror or error}): correct its permissions.",
                    path=str(folder),
                )
            )
            return []

    def _layer(self, file: MapFile) -> Layer:
        if file.format in RASTERS and not self.terrain_of(file).exists():
            return Layer(file.id, file.path.name, file.format, _kind_of(file), file.size_bytes, self.waiting(file))
        stamp = self._source_stamp(file)
        known = self._known.get(file.id)
        if known is None or known[0] != stamp:
            known = (stamp, *self._describe(file))
            self._known[file.id] = known
            if isinstance(known[2], GatewayError):
                self._report(known[2])
        _, size_bytes, found = known
        if isinstance(found, GatewayError):
            return Layer(file.id, file.path.name, file.format, _kind_of(file), size_bytes, found)
        return Layer(file.id, found.title or file.path.stem, file.format, found, size_bytes)

    def _describe(self, file: MapFile) -> tuple[int, Description | GatewayError]:
        try:
            size_bytes = folder_bytes(file.path) if file.path.is_dir() else file.size_bytes
            with self._opened.reading(file.id, self._source_stamp(file), lambda: self._open(file)) as source:
                return size_bytes, source.description
        except GatewayError as error:
            return file.size_bytes, error
        except OSError as error:
            return file.size_bytes, faults.damaged(file.path.name, error.strerror or str(error))

    def _source_stamp(self, file: MapFile) -> Stamp:
        """A raster changes when its terrain comes."""
        return (*file.stamp, int(self.terrain_of(file).exists())) if file.format in RASTERS else file.stamp

    def _open(self, file: MapFile) -> TileSource:
        if file.format not in RASTERS:
            return _open_plain(file)
        terrain = self.terrain_of(file)
        if not terrain.exists():
            raise self.waiting(file)
        return MbTiles(terrain, file.path.name)

    def _find(self, layer_id: str) -> MapFile:
        file = self._files.get(layer_id)
        if file is None:
            file = next((found for found in self._scan(self.path) if found.id == layer_id), None)
            if file is None:
                raise unknown(layer_id)
            self._files[layer_id] = file
        now = look_at(file.path) if file.path.exists() else None
        if now is None:
            self._files.pop(layer_id, None)
            raise unknown(layer_id)
        return now


def unknown(layer_id: str) -> NotFoundError:
    """No such layer."""
    return NotFoundError(
        "map_layer_unknown",
        f"There is no map layer '{layer_id}': GET /api/v1/map/layers lists all of them.",
        layer=layer_id,
    )


def exists(name: str) -> ConflictError:
    """The name is taken."""
    return ConflictError(
        "map_exists", f"There is a map '{name}' already: remove it first, or give this one another name.", name=name
    )


def _open_plain(file: MapFile) -> TileSource:
    if file.format == "mbtiles":
        return MbTiles(file.path, file.path.name)
    if file.format == "pmtiles":
        return PmTiles(file.path, file.path.name)
    return MeshFiles(file.path, file.path.name)


def _kind_of(file: MapFile) -> Description:
    """What is said of a file that cannot be read: its kind as far as the name tells."""
    if file.format in ("mbtiles", "pmtiles"):
        return UNKNOWN
    return Description("", "terrain", UNKNOWN.bounds, 0, 0, "")
