"""The maps' folder: its layers, each with the reason if it cannot be shown; their tiles; removing and restoring."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from threading import Lock
from typing import Final

from epf_gcs.errors import ConflictError, GatewayError, NotFoundError
from epf_gcs.maps import faults
from epf_gcs.maps.datum import DATUM_OF_FORMAT, DatumChoices
from epf_gcs.maps.files import FIELD_SETS, RASTERS, MapFile, folder_bytes, free_name, look_at, sets_of
from epf_gcs.maps.layer import UNKNOWN, Datum, Description, Layer, LayerFormat, Tile
from epf_gcs.maps.open_files import Stamp
from epf_gcs.maps.reader import Reader, is_too_costly

REMOVED: Final = "removed"
TERRAIN: Final = ".terrain"
_MAX_ZOOM: Final = 30
_MOST_ARCHIVES: Final = 200
# What a set of tiles says that the file of a field does not have.
_ABSENT: Final = "map_file_empty"


_DATUM_STAMP: Final = {None: 0, "orthometric": 1, "ellipsoidal": 2}

# 2: tiles say which heights the raster has.
_MADE: Final = 2


class MapFolder:
    """Blocks on the disk: call it in threads. `report` is called once for each file that cannot be shown.

    Files of tiles are never opened in this process: `Reader` does that, in processes with limits.
    """

    def __init__(self, path: Path, report: Callable[[GatewayError], None], reader: Reader | None = None) -> None:
        self.path = path
        # The reason why a raster has no terrain yet; replaced by `TerrainJobs`.
        self.waiting: Callable[[MapFile], GatewayError] = lambda file: faults.converting(file.path.name, 0)
        self._report = report
        self._lock = Lock()
        self._reader = Reader() if reader is None else reader
        self._datums = DatumChoices(path)
        self._files: dict[str, MapFile] = {}
        self._known: dict[str, tuple[Stamp, int, Description | GatewayError]] = {}
        self._inside: dict[tuple[Path, Stamp], str | None] = {}

    def layers(self) -> list[Layer]:
        """Everything that looks like a map, by name. A raster has a problem as long as its terrain is missing."""
        with self._lock:
            self._files = {one.id: one for file in self._scan(self.path) for one in sets_of(file)}
            self._known = {key: known for key, known in list(self._known.items()) if key in self._files}
            found = [self._layer(file) for file in sorted(self._files.values(), key=lambda file: file.path.name)]
        return [layer for layer in found if not _is_absent_set(layer)]

    def tile(self, layer_id: str, zoom: int, column: int, row: int) -> tuple[Tile | None, Description, Stamp]:
        """A tile, and its layer's description and stamp; terrain has heights above the sea. Raises
        NotFoundError, or why the file cannot be read."""
        file = self._find(layer_id)
        stamp = self._source_stamp(file)
        description = self._description(file, stamp)
        if not _is_inside(description, zoom, column, row):
            return None, description, stamp
        path, form = self._tiles_of(file)
        datum = self._datum(file, description)
        tile = self._reader.tile(path, file.path.name, form, stamp, (zoom, column, row), datum)
        # Another datum makes other tiles of the same file.
        return tile, description, (*stamp, _DATUM_STAMP[datum])

    def grid(self, layer_id: str, zoom: int, column: int, row: int) -> bytes | None:
        """The heights above the sea of a tile of terrain (`formats.quantized_mesh_reading`); None if there is no
        such tile. Rows from the south. Raises NotFoundError, or why the file cannot be read."""
        file = self._find(layer_id)
        stamp = self._source_stamp(file)
        description = self._description(file, stamp)
        if description.kind != "terrain" or description.projection != "EPSG:4326":
            return None
        at_row = row if description.scheme == "tms" else (1 << zoom) - 1 - row
        if not _is_inside(description, zoom, column, at_row):
            return None
        path, form = self._tiles_of(file)
        datum = self._datum(file, description)
        return self._reader.grid(path, file.path.name, form, stamp, (zoom, column, at_row), datum)

    def description(self, layer_id: str) -> Description:
        """A layer's description. Raises NotFoundError, or why the file cannot be read."""
        file = self._find(layer_id)
        return self._description(file, self._source_stamp(file))

    def datum(self, layer_id: str) -> Datum | None:
        """What a layer's heights count from; None: not known, and taken for the sea. Raises as `description`."""
        file = self._find(layer_id)
        return self._datum(file, self._description(file, self._source_stamp(file)))

    def choose_datum(self, layer_id: str, datum: Datum) -> None:
        """Say what a layer's heights count from, until its file changes. Raises NotFoundError, ConflictError."""
        file = self._find(layer_id)
        with self._lock:
            self._datums.put(file.id, file.stamp, datum)

    def remove(self, layer_id: str) -> None:
        """Take a map out of the list; its file is moved to the folder of removed maps."""
        file = self._find(layer_id)
        with self._lock:
            self._reader.forget(file.path)
            removed = self.path / REMOVED
            removed.mkdir(exist_ok=True)
            older = removed / file.path.name
            if older.exists():
                older.rename(free_name(removed, file.path.name))
            file.path.rename(older)
            self._files = {key: one for key, one in self._files.items() if one.path != file.path}

    def delete(self, layer_id: str) -> None:
        """Delete a map's file for good. Raises NotFoundError, OSError."""
        self.discard(self._find(layer_id))

    def file_of(self, layer_id: str) -> Path | None:
        """The path of a layer's one file; None for a folder of files. Raises NotFoundError."""
        path = self._find(layer_id).path
        return None if path.is_dir() else path

    def restore(self, layer_id: str) -> None:
        """Bring back the map removed last under this id. Raises NotFoundError, ConflictError."""
        with self._lock:
            removed = [one for found in self._scan(self.path / REMOVED) for one in sets_of(found)]
            file = next((found for found in removed if found.id == layer_id), None)
            if file is None:
                raise unknown(layer_id)
            target = self.path / file.path.name
            if target.exists():
                raise exists(file.path.name)
            file.path.rename(target)

    def terrain_of(self, file: MapFile) -> Path:
        """The file of a raster's terrain tiles; its name changes when the raster changes, or how tiles are made."""
        stamp = "-".join(f"{part:x}" for part in file.stamp)
        return self.path / TERRAIN / f"{file.id}-{stamp}-{_MADE}.mbtiles"

    def unconverted(self) -> list[MapFile]:
        """Rasters without terrain."""
        with self._lock:
            files = self._scan(self.path)
        return [file for file in files if file.format in RASTERS and not self.terrain_of(file).exists()]

    def drop_orphans(self) -> None:
        """Delete terrain whose raster is neither in the folder nor among the removed maps. Raises OSError."""
        with self._lock:
            rasters = [*self._scan(self.path), *self._scan(self.path / REMOVED)]
        kept = {self.terrain_of(file) for file in rasters if file.format in RASTERS}
        for path in (self.path / TERRAIN).glob("*"):
            if path not in kept:
                path.unlink(missing_ok=True)

    def take_in(self, path: Path) -> MapFile:
        """Move an uploaded file into the folder, if it can be shown. Raises why it cannot."""
        found = look_at(path, self._inside_of)
        if found is None:
            raise faults.damaged(path.name, "?")
        if found.format not in RASTERS:
            found = self._first_shown(found)
            self._reader.forget(found.path)
        with self._lock:
            target = self.path / path.name
            if target.exists():
                raise exists(path.name)
            path.rename(target)
        return found._replace(path=target)

    def discard(self, file: MapFile) -> None:
        """Delete a file whose import was cancelled or failed after `take_in`. Raises OSError."""
        with self._lock:
            self._reader.forget(file.path)
            self._files = {key: one for key, one in self._files.items() if one.path != file.path}
            file.path.unlink(missing_ok=True)

    def close(self) -> None:
        """Close all files."""
        self._reader.close()

    def _scan(self, folder: Path) -> list[MapFile]:
        try:
            return [
                file for path in folder.iterdir() if path.name != REMOVED and (file := look_at(path, self._inside_of))
            ]
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
        size_bytes, found = self._look_up(file, stamp)
        if isinstance(found, GatewayError):
            return Layer(file.id, file.path.name, file.format, _kind_of(file), size_bytes, found)
        return Layer(
            file.id, found.title or file.path.stem, file.format, found, size_bytes, None, self._datum(file, found)
        )

    def _datum(self, file: MapFile, description: Description) -> Datum | None:
        if description.kind != "terrain":
            return None
        stated = description.datum or DATUM_OF_FORMAT.get(file.format)
        return self._datums.of(file.id, file.stamp) or stated

    def _first_shown(self, file: MapFile) -> MapFile:
        """The first of the file's sets of tiles that can be shown. Raises why there is none."""
        problem: GatewayError | None = None
        for one in sets_of(file):
            try:
                self._reader.describe(one.path, one.path.name, one.format, one.stamp)
            except GatewayError as error:
                problem = error if problem is None or error.code != _ABSENT else problem
            else:
                return one
        raise problem or faults.empty(file.path.name)

    def _describe(self, file: MapFile) -> tuple[int, Description | GatewayError]:
        try:
            size_bytes = folder_bytes(file.path) if file.path.is_dir() else file.size_bytes
            path, form = self._tiles_of(file)
            return size_bytes, self._reader.describe(path, file.path.name, form, self._source_stamp(file))
        except GatewayError as error:
            return file.size_bytes, error
        except OSError as error:
            return file.size_bytes, faults.damaged(file.path.name, error.strerror or str(error))

    def _source_stamp(self, file: MapFile) -> Stamp:
        """The file's stamp; a raster's also changes when its terrain is made."""
        return (*file.stamp, int(self.terrain_of(file).exists())) if file.format in RASTERS else file.stamp

    def _tiles_of(self, file: MapFile) -> tuple[Path, LayerFormat]:
        """The file that holds its tiles. Raises why there is none yet."""
        if file.format not in RASTERS:
            return file.path, file.format
        terrain = self.terrain_of(file)
        if not terrain.exists():
            raise self.waiting(file)
        return terrain, "mbtiles"

    def _description(self, file: MapFile, stamp: Stamp) -> Description:
        """The file's description. Raises GatewayError if it cannot be shown."""
        _, found = self._look_up(file, stamp)
        if isinstance(found, GatewayError):
            raise found
        return found

    def _look_up(self, file: MapFile, stamp: Stamp) -> tuple[int, Description | GatewayError]:
        """Size and description, cached until the file changes; a file that took too long is tried again."""
        known = self._known.get(file.id)
        if known is not None and known[0] == stamp and not is_too_costly(known[2]):
            return known[1:]
        is_new = known is None or known[0] != stamp
        size_bytes, found = self._describe(file)
        self._known[file.id] = (stamp, size_bytes, found)
        if is_new and isinstance(found, GatewayError) and not (file.format in FIELD_SETS and found.code == _ABSENT):
            self._report(found)
        return size_bytes, found

    def _inside_of(self, path: Path, stamp: Stamp) -> str | None:
        """The raster in an archive, cached until the archive changes, for every request of a tile needs it."""
        key = (path, stamp)
        if key not in self._inside:
            if len(self._inside) >= _MOST_ARCHIVES:
                self._inside.clear()
            self._inside[key] = self._reader.raster_inside(path, stamp)
        return self._inside[key]

    def _find(self, layer_id: str) -> MapFile:
        file = self._files.get(layer_id)
        if file is None:
            found = (one for scanned in self._scan(self.path) for one in sets_of(scanned))
            file = next((one for one in found if one.id == layer_id), None)
            if file is None:
                raise unknown(layer_id)
            self._files[layer_id] = file
        seen = look_at(file.path, self._inside_of) if file.path.exists() else None
        now = None if seen is None else next((one for one in sets_of(seen) if one.id == layer_id), None)
        if now is None:
            self._files.pop(layer_id, None)
            raise unknown(layer_id)
        return now


def _is_inside(description: Description, zoom: int, column: int, row: int) -> bool:
    wide = 2 if description.kind == "terrain" and description.projection == "EPSG:4326" else 1
    return 0 <= zoom <= _MAX_ZOOM and 0 <= column < wide << zoom and 0 <= row < 1 << zoom


def unknown(layer_id: str) -> NotFoundError:
    """The error for an unknown layer."""
    return NotFoundError(
        "map_layer_unknown",
        f"There is no map layer '{layer_id}': GET /api/v1/map/layers lists all of them.",
        layer=layer_id,
    )


def _is_absent_set(layer: Layer) -> bool:
    return layer.format in FIELD_SETS and layer.problem is not None and layer.problem.code == _ABSENT


def not_deleted(layer_id: str, error: OSError) -> ConflictError:
    """The error for a file that the system does not delete."""
    why = error.strerror or str(error)
    return ConflictError(
        "map_not_written",
        f"'{layer_id}' could not be deleted ({why}): correct the permissions of the maps' folder.",
        name=layer_id,
        why=why,
    )


def exists(name: str) -> ConflictError:
    """The error for a name that is taken."""
    return ConflictError(
        "map_exists", f"There is a map '{name}' already: remove it first, or give this one another name.", name=name
    )


def _kind_of(file: MapFile) -> Description:
    """The description of an unreadable file: its kind, as far as the format tells."""
    if file.format in ("mbtiles", "pmtiles"):
        return UNKNOWN
    return Description("", "imagery" if file.format in FIELD_SETS else "terrain", UNKNOWN.bounds, 0, 0, "")
