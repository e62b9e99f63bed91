"""Converts a raster of heights to terrain tiles, in a separate process, so that neither its memory and CPU use nor a
crash of the library affects the station. `python -m epf_gcs.maps.terrain_worker`.

Prints a line of JSON for each percent, and one with the problem if it fails.
"""

from __future__ import annotations

import contextlib
import gzip
import math
import os
import sqlite3
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Final

from epf_gcs.errors import GatewayError
from epf_gcs.formats.quantized_mesh import CELLS, encode_tile, tile_nodes
from epf_gcs.maps import faults
from epf_gcs.maps.datum import METADATA_KEY
from epf_gcs.maps.layer import Bounds
from epf_gcs.system.limits import limit_memory, limit_time
from epf_gcs.system.priority import be_nice
from epf_gcs.workers.lines import tell, tell_fault

if TYPE_CHECKING:
    from epf_gcs.maps.heights import Heights

MOST_TILES: Final = 400_000
"""About 3 GB. Finer zoom levels are left out."""
_HIGHEST_ZOOM: Final = 18
_NICE: Final = 10
_MOST_MEMORY_BYTES: Final = 4_000_000_000
_MOST_CPU_S: Final = 4 * 3600
_PER_COMMIT: Final = 200
_PACKING: Final = 6


def main(arguments: list[str]) -> int:
    """Arguments: raster, output file, the raster's name for messages, and the file in an archive or an empty string."""
    raster, target, name, inside = arguments
    _be_modest()
    try:
        # GDAL's libraries need some of the system's, which small systems do not have (libexpat.so.1).
        import epf_gcs.maps.heights  # noqa: F401, PLC0415 - here for its failure alone
    except ImportError as error:
        problem = faults.not_converted(name, str(error))
        tell_fault(problem)
        return 1
    try:
        convert(Path(raster), Path(target), name, inside or None, lambda percent: tell({"percent": percent}))
    except GatewayError as error:
        tell_fault(error)
        return 1
    return 0


def convert(raster: Path, target: Path, name: str, inside: str | None, told: Callable[[int], None]) -> None:
    """Write the tiles; `target` appears only when it is complete. Raises GatewayError, OSError."""
    from epf_gcs.maps.heights import Heights  # noqa: PLC0415 - `main` tells of its failure

    heights = Heights(raster, name, inside)
    part = target.with_suffix(".part")
    part.unlink(missing_ok=True)
    try:
        with contextlib.closing(sqlite3.connect(part)) as output:
            _write(heights, output, told)
        with part.open("rb") as file:
            os.fsync(file.fileno())
        part.replace(target)
    finally:
        heights.close()
        part.unlink(missing_ok=True)


def highest_zoom(bounds: Bounds, pixel_deg: float) -> int:
    """The level whose spacing is nearest to the raster's, or the finest with at most MOST_TILES tiles."""
    zoom = min(_HIGHEST_ZOOM, max(0, round(math.log2(180.0 / CELLS / pixel_deg))))
    while zoom > 0 and math.prod(map(len, _touched_at(bounds, zoom))) > MOST_TILES:
        zoom -= 1
    return zoom


def _write(heights: Heights, output: sqlite3.Connection, told: Callable[[int], None]) -> None:
    output.executescript(
        "PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF;"
        "CREATE TABLE metadata (name TEXT, value TEXT);"
        "CREATE TABLE tiles (zoom_level INTEGER, tile_column INTEGER, tile_row INTEGER, tile_data BLOB,"
        " PRIMARY KEY (zoom_level, tile_column, tile_row)) WITHOUT ROWID;"
    )
    highest = highest_zoom(heights.bounds, heights.pixel_deg)
    # Cesium always requests both tiles of level 0, wherever the raster is.
    tiles = [(0, 0, 0), (0, 1, 0), *(tile for zoom in range(1, highest + 1) for tile in _level(heights.bounds, zoom))]
    percent = -1
    for index, (zoom, column, row) in enumerate(tiles):
        if index * 100 // len(tiles) > percent:
            percent = index * 100 // len(tiles)
            told(percent)
        data = gzip.compress(_tile(heights, zoom, column, row), _PACKING, mtime=0)
        output.execute("INSERT INTO tiles VALUES (?, ?, ?, ?)", (zoom, column, row, data))
        if index % _PER_COMMIT == 0:
            output.commit()
    metadata = {
        "format": "quantized-mesh-1.0",
        "bounds": ",".join(str(value) for value in heights.bounds),
        "minzoom": "0",
        "maxzoom": str(highest),
    }
    if heights.datum is not None:
        metadata[METADATA_KEY] = heights.datum
    output.executemany("INSERT INTO metadata VALUES (?, ?)", metadata.items())
    output.commit()


def _tile(heights: Heights, zoom: int, column: int, row: int) -> bytes:
    longitudes_deg, latitudes_deg = tile_nodes(zoom, column, row)
    step_deg = 180.0 / (1 << zoom) / CELLS
    found = heights.at(longitudes_deg, latitudes_deg, step_deg)
    return encode_tile(zoom, column, row, found, heights.known(longitudes_deg, latitudes_deg, step_deg))


def _level(bounds: Bounds, zoom: int) -> Iterator[tuple[int, int, int]]:
    """The tiles of a level that touch the raster."""
    columns, rows = _touched_at(bounds, zoom)
    return ((zoom, column, row) for column in columns for row in rows)


def _touched_at(bounds: Bounds, zoom: int) -> tuple[range, range]:
    """Columns, and rows from the south, of the tiles that touch these bounds."""
    size_deg = 180.0 / (1 << zoom)
    columns = _touched((bounds.west_deg + 180.0) / size_deg, (bounds.east_deg + 180.0) / size_deg, 2 << zoom)
    rows = _touched((bounds.south_deg + 90.0) / size_deg, (bounds.north_deg + 90.0) / size_deg, 1 << zoom)
    return columns, rows


def _touched(first: float, last: float, count: int) -> range:
    return range(max(0, math.floor(first)), min(count, max(math.floor(first) + 1, math.ceil(last))))


def _be_modest() -> None:
    be_nice(_NICE)
    limit_memory(_MOST_MEMORY_BYTES)
    limit_time(_MOST_CPU_S)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
