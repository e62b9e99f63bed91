"""Makes small valid map files for tests, of the usual formats."""

from __future__ import annotations

import sqlite3
import struct
import zlib
from collections.abc import Callable, Mapping
from contextlib import closing
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
import rasterio
from pmtiles.tile import Compression, TileType, zxy_to_tileid
from pmtiles.writer import Writer
from rasterio.transform import from_origin

Key = tuple[int, int, int]


def png(grey: int) -> bytes:
    """One grey pixel."""

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">IIBBBBB", 1, 1, 8, 0, 0, 0, 0)
    pixel = zlib.compress(bytes((0, grey)))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", pixel) + chunk(b"IEND", b"")


def write_mbtiles(path: Path, tiles: Mapping[Key, bytes], **metadata: str) -> Path:
    """Tiles by zoom, column and row from the south, as the format has them."""
    with closing(sqlite3.connect(path)) as file:
        file.execute("CREATE TABLE metadata (name TEXT, value TEXT)")
        file.execute("CREATE TABLE tiles (zoom_level INTEGER, tile_column INTEGER, tile_row INTEGER, tile_data BLOB)")
        file.executemany("INSERT INTO metadata VALUES (?, ?)", metadata.items())
        file.executemany("INSERT INTO tiles VALUES (?, ?, ?, ?)", [(*key, data) for key, data in tiles.items()])
        file.commit()
    return path


def write_pmtiles(path: Path, tiles: Mapping[Key, bytes], kind: TileType = TileType.PNG) -> Path:
    """Tiles by zoom, column and row from the north."""
    with path.open("wb") as file:
        writer: Any = Writer(file)  # type: ignore[no-untyped-call]
        for tile_id, data in sorted((zxy_to_tileid(*key), data) for key, data in tiles.items()):
            writer.write_tile(tile_id, data)
        header = {
            "tile_type": kind,
            "tile_compression": Compression.NONE,
            "min_zoom": min(key[0] for key in tiles),
            "max_zoom": max(key[0] for key in tiles),
            "min_lon_e7": -180_000_000,
            "min_lat_e7": 275_000_000,
            "max_lon_e7": -130_000_000,
            "max_lat_e7": 290_000_000,
            "center_zoom": 0,
            "center_lon_e7": 0,
            "center_lat_e7": 0,
        }
        writer.finalize(header, {"name": "Canarias", "attribution": "© someone"})
    return path


def write_raster(
    path: Path,
    height_m: Callable[[Any, Any], Any],
    *,
    west: float = -15.5,
    north: float = 28.0,
    step: float = 0.002,
    size: int = 200,
    crs: str | None = "EPSG:4326",
    **more: Any,
) -> Path:
    """A GeoTIFF whose pixels are `height_m(x, y)` at their centres; x, y in the units of its coordinate system."""
    places = (np.arange(size) + 0.5) * step
    x, y = np.meshgrid(west + places, north - places)
    about: dict[str, Any] = {"driver": "GTiff", "width": size, "height": size, "count": 1, "dtype": "float32", **more}
    if crs is not None:
        about |= {"crs": crs, "transform": from_origin(west, north, step, step)}
    with rasterio.open(path, "w", **about) as file:
        for band in range(1, about["count"] + 1):
            file.write(np.asarray(height_m(x, y)).astype(about["dtype"]), band)
    return path


def write_hgt(path: Path, height_m: Callable[[Any, Any], Any], size: int = 1201) -> Path:
    """An SRTM tile (.hgt); its file name gives its position."""
    south, west = int(path.stem[1:3]), int(path.stem[4:7]) * (-1 if path.stem[3] in "Ww" else 1)
    places = np.arange(size) / (size - 1)
    x, y = np.meshgrid(west + places, south + 1 - places)
    path.write_bytes(np.asarray(height_m(x, y)).astype(">i2").tobytes())
    return path


class Mesh(NamedTuple):
    """A decoded tile. Positions in the tile 0..1, heights in metres; `edges`: west, south, east, north."""

    centre_m: tuple[float, float, float]
    lowest_m: float
    highest_m: float
    radius_m: float
    hiding: tuple[float, float, float]
    u: npt.NDArray[np.float64]
    v: npt.NDArray[np.float64]
    height_m: npt.NDArray[np.float64]
    triangles: npt.NDArray[np.int64]
    edges: list[list[int]]


def decode_mesh(data: bytes) -> Mesh:
    """Decode as the format's specification says, number by number; fails if bytes are left over."""
    *centre, lowest, highest = struct.unpack_from("<3d2f", data)
    *_, radius, hiding_x, hiding_y, hiding_z = struct.unpack_from("<4d3d", data, 32)
    at = 88

    def numbers(kind: str, count: int) -> tuple[int, ...]:
        nonlocal at
        found = struct.unpack_from(f"<{count}{kind}", data, at)
        at += struct.calcsize(f"<{count}{kind}")
        return found

    (count,) = numbers("I", 1)
    columns = []
    for _ in range(3):
        value, column = 0, []
        for code in numbers("H", count):
            value += (code >> 1) ^ -(code & 1)
            column.append(value)
        columns.append(np.array(column) / 32767.0)
    (triangle_count,) = numbers("I", 1)
    next_new, indices = 0, []
    for code in numbers("H", 3 * triangle_count):
        indices.append(next_new - code)
        next_new += code == 0
    edges = [list(numbers("H", numbers("I", 1)[0])) for _ in range(4)]
    if at < len(data):
        # Our own extension: which heights are known.
        assert numbers("B", 1) + numbers("I", 1) == (100, 529)
        numbers("B", 529)
    assert at == len(data), "something is left over"
    return Mesh(
        (centre[0], centre[1], centre[2]),
        lowest,
        highest,
        radius,
        (hiding_x, hiding_y, hiding_z),
        columns[0],
        columns[1],
        lowest + columns[2] * (highest - lowest),
        np.array(indices).reshape(-1, 3),
        edges,
    )
