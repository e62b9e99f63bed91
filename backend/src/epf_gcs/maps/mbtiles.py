"""MBTiles: tiles of pictures or terrain in an SQLite file. Opened read-only, without journal files beside it."""

from __future__ import annotations

import math
import sqlite3
import threading
import time
from pathlib import Path
from typing import Final
from urllib.parse import quote

from epf_gcs.maps import faults
from epf_gcs.maps.confined_sqlite import confine
from epf_gcs.maps.datum import stated_datum
from epf_gcs.maps.layer import (
    Bounds,
    Description,
    LayerKind,
    Range,
    Tile,
    checked_bounds,
    credit,
    mesh,
    picture,
    vector,
)

_MESH_FORMATS: Final = ("quantized-mesh", "terrain")
_PICTURE_FORMATS: Final = frozenset({"png", "jpg", "jpeg", "webp", "image/png", "image/jpeg", "image/webp"})
# An untrusted file can make a query endless; a normal tile takes microseconds.
_LONGEST_S: Final = 5.0
_LONGEST_LISTING_S: Final = 20.0
_STEPS_BETWEEN_LOOKS: Final = 10_000
_MAX_ZOOM: Final = 30
_MAX_ROWS: Final = 200
_MAX_META_LENGTH: Final = 20_000
_METADATA: Final = f"SELECT substr(name, 1, 64), substr(value, 1, {_MAX_META_LENGTH}) FROM {{prefix}}metadata"  # noqa: S608


class MbTiles:
    """One opened file. Its rows count from the south; callers give the row of a picture from the north."""

    def __init__(self, path: Path, name: str, prefix: str = "", *, is_vector: bool = False) -> None:
        """Open the file. Raises GatewayError if it cannot be shown.

        `prefix` stands before the names of its tables, in a file of several sets; it is one of ours. `is_vector`: its
        tiles are roads, rivers and buildings (MVT).
        """
        self._name = name
        self._prefix = prefix
        self._is_vector = is_vector
        self._lock = threading.Lock()
        self._longest_s = _LONGEST_LISTING_S
        self._until_s = 0.0
        try:
            # Immutable: SQLite creates no lock files beside a file on somebody's memory stick.
            self._connection = sqlite3.connect(
                f"file:{quote(str(path.absolute()))}?mode=ro&immutable=1", uri=True, check_same_thread=False
            )
        except sqlite3.Error as error:
            raise faults.damaged(name, str(error)) from error
        try:
            confine(self._connection)
            self._connection.set_progress_handler(self._is_too_long, _STEPS_BETWEEN_LOOKS)
            self.description = self._describe()
            self._longest_s = _LONGEST_S
        except sqlite3.Error as error:
            self._connection.close()
            raise faults.damaged(name, str(error)) from error
        except BaseException:
            self._connection.close()
            raise

    def tile(self, zoom: int, column: int, row: int) -> Tile | None:
        """One tile; rows from the north for pictures, from the south for terrain."""
        is_mesh = self.description.kind == "terrain"
        try:
            data = self._blob(zoom, column, row if is_mesh else (1 << zoom) - 1 - row)
        except sqlite3.Error as error:
            raise faults.damaged(self._name, str(error)) from error
        if data is None:
            return None
        return {"terrain": mesh, "imagery": picture, "vector": vector}[self.description.kind](data)

    def close(self) -> None:
        """Close the file."""
        with self._lock:
            self._connection.close()

    def _blob(self, zoom: int, column: int, row: int) -> bytes | None:
        sql = f"SELECT tile_data FROM {self._prefix}tiles WHERE zoom_level = ? AND tile_column = ? AND tile_row = ?"  # noqa: S608
        found = self._rows(sql, (zoom, column, row))
        data = found[0][0] if found else None
        return data if isinstance(data, bytes) else None

    def _rows(self, sql: str, values: tuple[int, ...] = ()) -> list[tuple[object, ...]]:
        with self._lock:
            self._until_s = time.monotonic() + self._longest_s
            return self._connection.execute(sql, values).fetchmany(_MAX_ROWS)

    def _is_too_long(self) -> bool:
        return time.monotonic() > self._until_s

    def _describe(self) -> Description:
        meta = {str(key): str(value) for key, value in self._rows(_METADATA.format(prefix=self._prefix))}
        kind = self._kind(meta.get("format", "").lower())
        bounds, zooms = _bounds(meta.get("bounds", "")), _zooms(meta)
        available: tuple[tuple[Range, ...], ...] | None = None
        # Scanning all tiles of a large file takes long: do it only if the metadata is incomplete.
        if kind == "terrain" or bounds is None or zooms is None:
            levels = self._levels()
            zooms = (min(levels), max(levels))
            bounds = bounds or _covered(kind, zooms[1], levels[zooms[1]])
            if kind == "terrain":
                none: tuple[Range, ...] = ()
                available = tuple((levels[zoom],) if zoom in levels else none for zoom in range(zooms[1] + 1))
        return Description(
            title=meta.get("name", ""),
            kind=kind,
            bounds=bounds,
            minimum_zoom=zooms[0],
            maximum_zoom=zooms[1],
            attribution=credit(meta.get("attribution", "")),
            available=available,
            datum=stated_datum(meta) if kind == "terrain" else None,
        )

    def _levels(self) -> dict[int, Range]:
        """The bounding rectangle of the tiles of each level."""
        sizes = "min(tile_column), min(tile_row), max(tile_column), max(tile_row)"
        rows = self._rows(f"SELECT zoom_level, {sizes} FROM {self._prefix}tiles GROUP BY zoom_level")  # noqa: S608
        levels = {
            int(str(zoom)): Range(*(int(str(value)) for value in rest))
            for zoom, *rest in rows
            if 0 <= int(str(zoom)) <= _MAX_ZOOM
        }
        if not levels:
            raise faults.empty(self._name)
        return levels

    def _kind(self, said: str) -> LayerKind:
        first = self._rows(f"SELECT tile_data FROM {self._prefix}tiles LIMIT 1")  # noqa: S608
        if not first:
            raise faults.empty(self._name)
        if self._is_vector:
            return "vector"
        if any(word in said for word in _MESH_FORMATS):
            return "terrain"
        # Decide by the tile's content, not by the format that the metadata states.
        data = first[0][0]
        if isinstance(data, bytes) and picture(data) is not None:
            return "imagery"
        raise faults.vector(self._name, said if said and said not in _PICTURE_FORMATS else "?")


def _bounds(text: str) -> Bounds | None:
    try:
        west_deg, south_deg, east_deg, north_deg = (float(part) for part in text.split(","))
    except ValueError:
        return None
    return checked_bounds(west_deg, south_deg, east_deg, north_deg)


def _zooms(meta: dict[str, str]) -> tuple[int, int] | None:
    try:
        lowest, highest = int(meta["minzoom"]), int(meta["maxzoom"])
    except (KeyError, ValueError):
        return None
    return (lowest, highest) if 0 <= lowest <= highest <= _MAX_ZOOM else None


def _covered(kind: LayerKind, zoom: int, tiles: Range) -> Bounds:
    """The bounds of these tiles, for a file that does not state its bounds."""
    if kind == "terrain":
        size_deg = 180.0 / (1 << zoom)
        return Bounds(
            tiles.start_x * size_deg - 180.0,
            tiles.start_y * size_deg - 90.0,
            (tiles.end_x + 1) * size_deg - 180.0,
            (tiles.end_y + 1) * size_deg - 90.0,
        )
    size_deg = 360.0 / (1 << zoom)
    return Bounds(
        tiles.start_x * size_deg - 180.0,
        _mercator_deg(tiles.start_y / (1 << zoom)),
        (tiles.end_x + 1) * size_deg - 180.0,
        _mercator_deg((tiles.end_y + 1) / (1 << zoom)),
    )


def _mercator_deg(from_south: float) -> float:
    """Latitude of a place on the Mercator map, 0 at its southern edge and 1 at its northern."""
    return math.degrees(math.atan(math.sinh(math.pi * (2.0 * from_south - 1.0))))
