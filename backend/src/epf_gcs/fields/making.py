"""What is made of the heights that arrived: one raster, terrain for the globe, a shaded relief for both maps."""

from __future__ import annotations

import math
import sqlite3
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, Final

import numpy as np
import numpy.typing as npt
import rasterio
from rasterio.errors import NotGeoreferencedWarning, RasterioError
from rasterio.io import MemoryFile
from rasterio.merge import merge
from rasterio.transform import from_origin
from rasterio.windows import Window

from epf_gcs.earth import M_PER_DEG
from epf_gcs.errors import ConflictError
from epf_gcs.fields.order import Order, Part, Place
from epf_gcs.fields.part_file import PartFile
from epf_gcs.maps.heights import Heights
from epf_gcs.maps.terrain_worker import convert

LOWEST_RELIEF_ZOOM: Final = 5
_RELIEF_OF_DEGREES_ZOOM: Final = 12
_SIDE: Final = 256
_UNKNOWN_M: Final = -32768.0
_EARTH_M: Final = 20037508.342789244
# Light from the north-west, halfway up, as on paper maps.
_LIGHT: Final = np.array([-0.5, 0.5, math.sqrt(0.5)])
_TINT_M: Final = (0.0, 100.0, 400.0, 900.0, 1600.0, 2500.0, 4000.0)
_TINTS: Final = (
    (172, 204, 148),
    (190, 212, 154),
    (224, 218, 164),
    (214, 188, 132),
    (188, 150, 110),
    (206, 196, 188),
    (244, 244, 244),
)

Grid = npt.NDArray[np.float64]


class BadPieceError(Exception):
    """A piece that looked whole and cannot be read: it is to be fetched again."""

    def __init__(self, place: Place) -> None:
        super().__init__(str(place))
        self.place = place


def write_raster(part: Part, order: Order, arrived: PartFile, path: Path) -> None:
    """All heights in one GeoTIFF; what no piece covers is unknown.

    Terrarium has the sea's floor, too: what lies below the sea's level is taken as 0. Raises BadPieceError, OSError,
    and ConflictError if there is nothing.
    """
    try:
        if part.is_of_degrees:
            _write_degrees(order, arrived, path)
        else:
            _write_tiles(part, order, arrived, path)
    except RasterioError as error:
        raise OSError(str(error)) from error


def make_terrain(raster: Path, target: Path, told: Callable[[int], None]) -> None:
    """Terrain tiles of the raster in an MBTiles file. `told`: percent. Raises GatewayError, OSError."""
    convert(raster, target, raster.name, None, told)


def relief_zooms(part: Part) -> range:
    """The levels of the relief."""
    highest = _RELIEF_OF_DEGREES_ZOOM if part.is_of_degrees else part.maximum_zoom
    return range(min(LOWEST_RELIEF_ZOOM, highest), highest + 1)


def relief(raster: Path, order: Order, part: Part) -> Iterator[tuple[Place, bytes]]:
    """Shaded and tinted pictures (PNG), rows from the north; transparent at the sea's level and where nothing is known.

    Places without land are left out. Raises GatewayError.
    """
    heights = Heights(raster, raster.name)
    try:
        for zoom in relief_zooms(part):
            for column, row in order.area.tiles(zoom):
                picture = _relief_tile(heights, zoom, int(column), int(row))
                if picture is not None:
                    yield Place(zoom, int(column), int(row)), picture
    finally:
        heights.close()


def _write_tiles(part: Part, order: Order, arrived: PartFile, path: Path) -> None:
    places = order.area.tiles(part.maximum_zoom)
    # Across the date line the columns go on, so that the raster is one piece.
    count = 1 << part.maximum_zoom
    columns = places[:, 0].copy()
    if columns.max() - columns.min() > count // 2:
        columns[columns < count // 2] += count
    west, north = int(columns.min()), int(places[:, 1].min())
    side = None
    raster: Any = None
    try:
        for place, data in arrived.pieces("heights"):
            found = _terrarium(place, data)
            if side is None:
                side = found.shape[0]
                step_m = 2 * _EARTH_M / count / side
                wide, high = int(columns.max()) - west + 1, int(places[:, 1].max()) - north + 1
                raster = rasterio.open(
                    path,
                    "w",
                    driver="GTiff",
                    width=wide * side,
                    height=high * side,
                    count=1,
                    dtype="float32",
                    crs="EPSG:3857",
                    transform=from_origin(
                        west * side * step_m - _EARTH_M, _EARTH_M - north * side * step_m, step_m, step_m
                    ),
                    nodata=_UNKNOWN_M,
                    tiled=True,
                    blockxsize=256,
                    blockysize=256,
                    compress="deflate",
                    bigtiff="if_safer",
                    sparse_ok=True,
                )
            elif found.shape[0] != side:
                raise BadPieceError(place)
            column = place.column - west if place.column >= west else place.column + count - west
            raster.write(found, 1, window=Window(column * side, (place.row - north) * side, side, side))
    finally:
        if raster is not None:
            raster.close()
    if raster is None:
        raise nothing_there(part)


def _terrarium(place: Place, data: bytes) -> npt.NDArray[np.float32]:
    try:
        with warnings.catch_warnings(), MemoryFile(data) as file:
            warnings.simplefilter("ignore", NotGeoreferencedWarning)  # a picture lies nowhere by itself
            with file.open(driver="PNG") as picture:
                red, green, blue = picture.read((1, 2, 3)).astype(np.float32)
    except (RasterioError, ValueError, IndexError) as error:
        raise BadPieceError(place) from error
    metres: npt.NDArray[np.float32] = np.maximum(red * 256.0 + green + blue / 256.0 - 32768.0, 0.0)
    return metres


def _write_degrees(order: Order, arrived: PartFile, path: Path) -> None:
    heights = next(part for part in order.parts if part.kind == "heights")
    kept: list[Path] = []
    try:
        for number, (place, data) in enumerate(arrived.pieces("heights")):
            piece = path.with_name(f"{path.stem}-{number}.tif")
            piece.write_bytes(data)
            kept.append(piece)
            try:
                with rasterio.open(piece, driver="GTiff") as raster:
                    if raster.count != 1 or max(raster.shape) > 20_000:
                        raise BadPieceError(place)
                    raster.checksum(1)
            except RasterioError as error:
                raise BadPieceError(place) from error
        if not kept:
            raise nothing_there(heights)
        merge(kept, bounds=tuple(order.area.bounds), nodata=_UNKNOWN_M, dtype="float32", dst_path=path)
    finally:
        for piece in kept:
            piece.unlink(missing_ok=True)


def nothing_there(part: Part) -> ConflictError:
    """The error for a source that has not one piece of this area."""
    return ConflictError(
        "field_source_empty",
        f"'{part.name}' has nothing of this area: choose another source, or another level.",
        name=part.name,
    )


def _relief_tile(heights: Heights, zoom: int, column: int, row: int) -> bytes | None:
    count = 1 << zoom
    # One pixel more on each side: the light at the edge is that of the neighbour's.
    pixels = np.arange(-1, _SIDE + 1) + 0.5
    longitude_deg = (column + pixels / _SIDE) / count * 360.0 - 180.0
    mercator = np.pi * (1.0 - 2.0 * (row + pixels / _SIDE) / count)
    latitude_deg = np.degrees(np.arctan(np.sinh(mercator)))
    step_deg = 360.0 / count / _SIDE
    heights_m = heights.at(longitude_deg, latitude_deg, step_deg)
    inner = heights_m[1:-1, 1:-1]
    if not inner.any():
        return None
    step_m = step_deg * M_PER_DEG * np.cos(np.radians(latitude_deg[1:-1]))[:, np.newaxis]
    east = (heights_m[1:-1, 2:] - heights_m[1:-1, :-2]) / (2 * step_m)
    north = (heights_m[:-2, 1:-1] - heights_m[2:, 1:-1]) / (2 * step_m)
    light = (-east * _LIGHT[0] - north * _LIGHT[1] + _LIGHT[2]) / np.sqrt(east**2 + north**2 + 1.0)
    shade = 0.45 + 0.55 * np.clip(light / _LIGHT[2], 0.0, 1.25)
    channels = [np.interp(inner, _TINT_M, [tint[one] for tint in _TINTS]) * shade for one in range(3)]
    seen = np.where(inner == 0.0, 0, 255)
    return _png(np.clip(np.stack([*channels, seen]), 0, 255).astype(np.uint8))


def _png(channels: npt.NDArray[np.uint8]) -> bytes:
    with warnings.catch_warnings(), MemoryFile() as file:
        warnings.simplefilter("ignore", NotGeoreferencedWarning)
        with file.open(driver="PNG", width=_SIDE, height=_SIDE, count=4, dtype="uint8") as picture:
            picture.write(channels)
        return bytes(file.read())


def terrain_tiles(path: Path) -> Iterator[tuple[Place, bytes]]:
    """The tiles of a file of `make_terrain`, in order, rows from the south."""
    file = sqlite3.connect(path)
    try:
        sql = "SELECT zoom_level, tile_column, tile_row, tile_data FROM tiles ORDER BY 1, 2, 3"
        for zoom, column, row, data in file.execute(sql):
            yield Place(zoom, column, row), data
    finally:
        file.close()
