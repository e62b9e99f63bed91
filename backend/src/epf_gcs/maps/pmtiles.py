"""PMTiles: tiles in one file with a directory. Read, not memory-mapped: a pulled stick then raises an error."""

from __future__ import annotations

import os
import zlib
from collections import OrderedDict
from pathlib import Path
from threading import Lock
from typing import Any, Final

import orjson
from pmtiles.tile import Compression, TileType, deserialize_header, find_tile, zxy_to_tileid

from epf_gcs.errors import GatewayError
from epf_gcs.maps import faults
from epf_gcs.maps.layer import MAX_TILE_BYTES, Bounds, Description, Tile, checked_bounds, credit, picture
from epf_gcs.maps.pmtiles_directory import read_directory, unpacked
from epf_gcs.system.files import read_at

_PICTURES: Final = frozenset({TileType.PNG, TileType.JPEG, TileType.WEBP})
_KEPT_ENTRIES: Final = 300_000
_MAX_DIRECTORY_BYTES: Final = 4_000_000
_MAX_METADATA_BYTES: Final = 4_000_000
_MAX_DEPTH: Final = 4
_HEADER_BYTES: Final = 127
_MAX_ZOOM: Final = 30
_DEG: Final = 1e-7
_CUT_OFF: Final = "cut off"


class PmTiles:
    """One opened file."""

    def __init__(self, path: Path, name: str) -> None:
        """Open the file. Raises GatewayError if it cannot be shown."""
        self._name = name
        self._lock = Lock()
        self._directories: OrderedDict[tuple[int, int], Any] = OrderedDict()
        try:
            self._file: int | None = os.open(path, os.O_RDONLY)
        except OSError as error:
            raise faults.damaged(name, error.strerror or str(error)) from error
        try:
            self.description = self._describe()
        except GatewayError:
            self.close()
            raise
        except Exception as error:
            self.close()
            raise faults.damaged(name, _words(error)) from error

    def tile(self, zoom: int, column: int, row: int) -> Tile | None:
        """One tile; rows from the north, as in the file."""
        try:
            data = self._find(zxy_to_tileid(zoom, column, row))
        except (EOFError, OSError, ValueError, IndexError, zlib.error) as error:
            raise faults.damaged(self._name, _words(error)) from error
        return None if data is None else picture(data)

    def close(self) -> None:
        """Close the file."""
        with self._lock:
            file, self._file = self._file, None
            if file is not None:
                os.close(file)

    def _describe(self) -> Description:
        self._header = header = deserialize_header(self._read(0, _HEADER_BYTES))
        kind = header["tile_type"]
        if kind not in _PICTURES or header["tile_compression"] not in (Compression.NONE, Compression.UNKNOWN):
            raise faults.vector(self._name, kind.name.lower())
        if header["max_zoom"] < header["min_zoom"] or header["max_zoom"] > _MAX_ZOOM:
            raise faults.damaged(self._name, f"zoom {header['min_zoom']}..{header['max_zoom']}")
        metadata = self._metadata()
        # An interrupted copy has the directory, which comes first, but not all tiles.
        if os.fstat(self._open_file()).st_size < header["tile_data_offset"] + header["tile_data_length"]:
            raise faults.damaged(self._name, _CUT_OFF)
        self._directory(header["root_offset"], header["root_length"])
        west_e7, south_e7 = header["min_lon_e7"], header["min_lat_e7"]
        east_e7, north_e7 = header["max_lon_e7"], header["max_lat_e7"]
        bounds = checked_bounds(west_e7 * _DEG, south_e7 * _DEG, east_e7 * _DEG, north_e7 * _DEG)
        return Description(
            title=str(metadata.get("name", "")),
            kind="imagery",
            bounds=bounds or Bounds(),
            minimum_zoom=header["min_zoom"],
            maximum_zoom=header["max_zoom"],
            attribution=credit(metadata.get("attribution", "")),
        )

    def _metadata(self) -> dict[str, Any]:
        header = self._header
        if not 0 < header["metadata_length"] <= _MAX_METADATA_BYTES:
            return {}
        data = self._read(header["metadata_offset"], header["metadata_length"])
        if header["internal_compression"] == Compression.GZIP:
            data = unpacked(data, _MAX_METADATA_BYTES)
        found = orjson.loads(data)
        return found if isinstance(found, dict) else {}

    def _find(self, tile_id: int) -> bytes | None:
        header = self._header
        offset, length = header["root_offset"], header["root_length"]
        for _ in range(_MAX_DEPTH):
            entry = find_tile(self._directory(offset, length), tile_id)
            if entry is None:
                return None
            if entry.run_length:
                if entry.length > MAX_TILE_BYTES:
                    return None
                return self._read(header["tile_data_offset"] + entry.offset, entry.length, MAX_TILE_BYTES)
            offset, length = header["leaf_directory_offset"] + entry.offset, entry.length
        return None

    def _directory(self, offset: int, length: int) -> Any:
        """A directory, from a cache of those used last: the library would unpack it anew for each tile."""
        key = (offset, length)
        with self._lock:
            if key in self._directories:
                self._directories.move_to_end(key)
                return self._directories[key]
        found = read_directory(self._read(offset, length))
        with self._lock:
            self._directories[key] = found
            while sum(map(len, self._directories.values())) > _KEPT_ENTRIES:
                self._directories.popitem(last=False)
        return found

    def _read(self, offset: int, length: int, most_bytes: int = _MAX_DIRECTORY_BYTES) -> bytes:
        if not 0 <= length <= most_bytes or offset < 0:
            raise ValueError("a length that no part of a file has")
        with self._lock:
            data = read_at(self._open_file(), length, offset)
        if len(data) < length:
            raise EOFError(_CUT_OFF)
        return data

    def _open_file(self) -> int:
        if self._file is None:
            raise OSError("closed")
        return self._file


def _words(error: Exception) -> str:
    return str(error) or type(error).__name__
