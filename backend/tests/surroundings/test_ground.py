"""The heights around the aircraft, from a file of terrain in the maps' folder through its worker process."""

from __future__ import annotations

import asyncio
import contextlib
import sqlite3
from pathlib import Path

import numpy as np

from epf_gcs.formats.quantized_mesh import CELLS, encode_tile
from epf_gcs.maps.folder import MapFolder
from epf_gcs.maps.layer import Layer
from epf_gcs.surroundings.ground import Ground
from tests.support.waiting import DEADLINE_S

ZOOM, COLUMN, ROW = 8, 234, 167
SIZE_DEG = 180.0 / (1 << ZOOM)
SOUTH, WEST = ROW * SIZE_DEG - 90.0, COLUMN * SIZE_DEG - 180.0


def write_terrain(path: Path) -> None:
    """One tile that rises to the north, 10 m a cell; its eastern half is not known."""
    heights_m = np.repeat(np.arange(CELLS + 1)[:, None] * 10.0, CELLS + 1, axis=1)
    known = np.ones(heights_m.shape, dtype=bool)
    known[:, CELLS // 2 + 1 :] = False
    with contextlib.closing(sqlite3.connect(path)) as output:
        output.execute("CREATE TABLE metadata (name TEXT, value TEXT)")
        output.execute("CREATE TABLE tiles (zoom_level INTEGER, tile_column INTEGER, tile_row INTEGER, tile_data BLOB)")
        bounds = f"{WEST},{SOUTH},{WEST + SIZE_DEG},{SOUTH + SIZE_DEG}"
        output.executemany(
            "INSERT INTO metadata VALUES (?, ?)",
            [("format", "quantized-mesh-1.0"), ("bounds", bounds), ("minzoom", "0"), ("maxzoom", str(ZOOM))],
        )
        tile = encode_tile(ZOOM, COLUMN, ROW, heights_m, known)
        output.execute("INSERT INTO tiles VALUES (?, ?, ?, ?)", (ZOOM, COLUMN, ROW, tile))
        output.commit()


class FolderTiles:
    """The folder as the maps give it; waits where they use a thread."""

    def __init__(self, folder: MapFolder) -> None:
        self._folder = folder

    async def terrain_layers(self) -> list[Layer]:
        return [one for one in self._folder.layers() if one.problem is None]

    async def grid(self, layer_id: str, zoom: int, column: int, row: int) -> bytes | None:
        return self._folder.grid(layer_id, zoom, column, row)


def test_heights_come_when_they_were_read_and_unknown_ones_never(tmp_path: Path) -> None:
    write_terrain(tmp_path / "field.mbtiles")
    folder = MapFolder(tmp_path, lambda _: None)
    north = np.array([SOUTH + SIZE_DEG / 2, SOUTH + SIZE_DEG / 4, SOUTH + SIZE_DEG / 2, SOUTH - 1.0])
    east = np.array([WEST + SIZE_DEG / 4, WEST + SIZE_DEG / 8, WEST + SIZE_DEG * 0.75, WEST])

    async def look() -> None:
        ground = Ground(FolderTiles(folder))
        assert np.isnan(ground.heights(north, east)).all()
        reading = asyncio.create_task(ground.run())
        async with asyncio.timeout(DEADLINE_S):
            while np.isnan(ground.heights(north, east)).all():  # noqa: ASYNC110 - nobody tells when a tile was read
                await asyncio.sleep(0.02)
        assert ground.has_heights
        found = ground.heights(north, east)
        np.testing.assert_allclose(found[:2], [320.0, 160.0], atol=0.1)
        assert np.isnan(found[2:]).all()
        reading.cancel()

    try:
        asyncio.run(look())
    finally:
        folder.close()
