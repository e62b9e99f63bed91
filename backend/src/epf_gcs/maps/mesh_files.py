"""Terrain made by other programs: quantized-mesh tiles beside a layer.json, in a folder or in a zip file."""

from __future__ import annotations

import threading
import zipfile
from pathlib import Path, PurePosixPath
from typing import Any, Final, Protocol

import orjson

from epf_gcs.errors import GatewayError
from epf_gcs.formats.zip_faults import ZIP_FAULTS
from epf_gcs.maps import faults
from epf_gcs.maps.datum import stated_datum
from epf_gcs.maps.layer import MAX_TILE_BYTES, Bounds, Description, Range, Tile, checked_bounds, credit, mesh

LAYER_JSON: Final = "layer.json"
_FORMAT: Final = "quantized-mesh-1.0"
_MAX_JSON_BYTES: Final = 20_000_000
_MAX_ZOOM: Final = 30
_MOST_NAMES: Final = 1_000_000
# Other compressions are unpacked as a whole before the first byte is returned, so their size cannot be bounded.
_BOUNDED: Final = frozenset({zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED})
_KNOWN_EXTENSIONS: Final = frozenset({"octvertexnormals", "vertexnormals", "watermask", "metadata"})


class _Files(Protocol):
    def read(self, path: str, most_bytes: int) -> bytes | None: ...

    def close(self) -> None: ...


class _Folder:
    def __init__(self, path: Path) -> None:
        self._path = path

    def read(self, path: str, most_bytes: int) -> bytes | None:
        """`path` is made of numbers by the caller, so it cannot lead out of the folder."""
        try:
            with (self._path / path).open("rb") as file:
                data = file.read(most_bytes + 1)
        except (FileNotFoundError, NotADirectoryError, IsADirectoryError):
            return None
        return data if len(data) <= most_bytes else None

    def close(self) -> None:
        """Do nothing: no file stays open."""


class _Zip:
    def __init__(self, path: Path) -> None:
        self._lock = threading.Lock()
        self._archive = zipfile.ZipFile(path)
        names = (PurePosixPath(name) for name in self._archive.namelist())
        tops = sorted((name.parent for name in names if name.name == LAYER_JSON), key=lambda top: len(top.parts))
        # Many archives hold a single folder with everything in it.
        self._top = tops[0] if tops else PurePosixPath()

    def read(self, path: str, most_bytes: int) -> bytes | None:
        with self._lock:
            try:
                entry = self._archive.getinfo(str(self._top / path))
            except KeyError:
                return None
            if entry.file_size > most_bytes:
                return None
            if entry.compress_type not in _BOUNDED:
                raise ValueError("packed in a way that is not taken: use deflate")
            # The size in an entry's header may be false: `read` ends at the bound in any case.
            with self._archive.open(entry) as file:
                data = file.read(entry.file_size)
                file.read(1)  # reading past the end makes zipfile check the checksum
                return data

    def close(self) -> None:
        with self._lock:
            self._archive.close()


class MeshFiles:
    """An opened set of tiles. Rows in the scheme of its layer.json."""

    def __init__(self, path: Path, name: str) -> None:
        """Open the set. Raises GatewayError if it cannot be shown."""
        self._name = name
        try:
            self._files: _Files = _Folder(path) if path.is_dir() else _Zip(path)
        except ZIP_FAULTS as error:
            raise faults.damaged(name, str(error)) from error
        try:
            self.description = self._describe()
        except GatewayError:
            self._files.close()
            raise

    def tile(self, zoom: int, column: int, row: int) -> Tile | None:
        """One tile; None if there is none."""
        data = self._read(f"{zoom}/{column}/{row}.terrain", MAX_TILE_BYTES)
        return None if data is None else mesh(data)

    def close(self) -> None:
        """Close the files."""
        self._files.close()

    def _read(self, path: str, most_bytes: int) -> bytes | None:
        try:
            return self._files.read(path, most_bytes)
        except ZIP_FAULTS as error:
            raise faults.damaged(self._name, str(error)) from error

    def _describe(self) -> Description:
        data = self._read(LAYER_JSON, _MAX_JSON_BYTES)
        try:
            said = orjson.loads(data or b"")
        except orjson.JSONDecodeError as error:
            raise faults.no_layer_json(self._name) from error
        if not isinstance(said, dict):
            raise faults.no_layer_json(self._name)
        if said.get("format", _FORMAT) != _FORMAT:
            raise faults.not_mesh(self._name, str(said.get("format"))[:30])
        available = _available(said.get("available"))
        highest = said.get("maxzoom")
        if not isinstance(highest, int):
            highest = len(available) - 1 if available else 0
        extensions = said.get("extensions")
        return Description(
            title=str(said.get("name", "")),
            kind="terrain",
            bounds=_bounds(said.get("bounds")),
            minimum_zoom=0,
            maximum_zoom=min(max(0, highest), _MAX_ZOOM),
            attribution=credit(said.get("attribution", "")),
            scheme="slippyMap" if said.get("scheme") == "slippyMap" else "tms",
            projection="EPSG:3857" if said.get("projection") == "EPSG:3857" else "EPSG:4326",
            available=available,
            datum=stated_datum(said),
            extensions=tuple(
                name for name in (extensions if isinstance(extensions, list) else []) if name in _KNOWN_EXTENSIONS
            ),
        )


def _available(said: Any) -> tuple[tuple[Range, ...], ...] | None:
    """Rectangles of tiles for each level; None if the set states none, or in an unknown form."""
    try:
        levels = tuple(
            tuple(Range(*(int(one[key]) for key in ("startX", "startY", "endX", "endY"))) for one in level)
            for level in said
        )
    except (TypeError, ValueError, KeyError):
        return None
    return levels or None


def _bounds(said: Any) -> Bounds:
    try:
        west_deg, south_deg, east_deg, north_deg = (float(value) for value in said)
    except (TypeError, ValueError):
        return Bounds()
    return checked_bounds(west_deg, south_deg, east_deg, north_deg) or Bounds()


def is_mesh_zip(path: Path) -> bool:
    """Whether the archive holds terrain. Raises OSError and BadZipFile."""
    with zipfile.ZipFile(path) as archive:
        return any(PurePosixPath(name).name == LAYER_JSON for name in archive.namelist())


def only_raster(path: Path) -> str | None:
    """The name of the one raster of heights in an archive, the usual form of published elevation models."""
    with zipfile.ZipFile(path) as archive:
        rasters = [name for name in archive.namelist() if name.lower().endswith((".hgt", ".tif", ".tiff"))]
    return rasters[0] if len(rasters) == 1 else None
