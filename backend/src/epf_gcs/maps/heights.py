"""A raster of heights, sampled by longitude and latitude. Only the worker process imports rasterio."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Any, Final, Literal

import numpy as np
import numpy.typing as npt
import rasterio
from rasterio.enums import ColorInterp
from rasterio.errors import RasterioError
from rasterio.warp import transform, transform_bounds
from rasterio.windows import Window

from epf_gcs.maps import faults
from epf_gcs.maps.datum import DATUM_OF_FORMAT, datum_in
from epf_gcs.maps.layer import Bounds, Datum
from epf_gcs.units import M_PER_FT

# Allow no other drivers: some of the library's follow references to other files and hosts.
_DRIVERS: Final = {".hgt": "SRTMHGT"}
_OTHER_DRIVER: Final = "GTiff"
_EARTH: Final = "EPSG:4326"
_M_PER_UNIT: Final = {
    "ft": M_PER_FT,
    "foot": M_PER_FT,
    "feet": M_PER_FT,
    "us-ft": 1200 / 3937,
    "us survey foot": 1200 / 3937,
}
_PLACE_IN_NAME: Final = re.compile(r"[NS]\d\d[EW]\d{3}", re.IGNORECASE)
# The name of the vertical part, and of its datum.
_VERTICAL: Final = re.compile(r"\b(?:VERT_CS|VERTCRS|VERTICALCRS)\[(.*)", re.DOTALL)
_EARTH_3D: Final = 4979
_QUOTED_PATH: Final = re.compile(r"^'[^']*'\s*")
# Margin, as a share of the size: a projected edge bends beyond the points that the bounds are calculated from.
_BEYOND_BOUNDS: Final = 0.02
_MOST_BLOCK_PIXELS: Final = 16_000_000
_MOST_BLOCK_SIDE: Final = 64

# Less than the whole by no more than rounding.
_WHOLLY: Final = 0.99

Grid = npt.NDArray[np.float64]
_Of = Literal["height", "known"]


class Heights:
    """An opened raster. Places outside it or without data have height 0, sea level."""

    def __init__(self, path: Path, name: str, inside: str | None = None) -> None:
        """`inside`: the file in an archive. Raises InvalidInputError if it is no georeferenced raster of heights."""
        self._name = name
        where = str(path) if inside is None else f"/vsizip/{path}/{inside}"
        driver = _DRIVERS.get(Path(where).suffix.lower(), _OTHER_DRIVER)
        if driver != _OTHER_DRIVER and _PLACE_IN_NAME.match(Path(where).name) is None:
            raise faults.no_place(name)
        try:
            self._raster: Any = rasterio.open(where, driver=driver)
        except RasterioError as error:
            raise faults.damaged(name, _words(error)) from error
        raster = self._raster
        if raster.count != 1 or raster.colorinterp[0] == ColorInterp.palette or raster.dtypes[0].startswith("complex"):
            raise faults.not_height(name, raster.count)
        if raster.crs is None or raster.transform.is_identity:
            raise faults.no_place(name)
        try:
            west, south, east, north = transform_bounds(raster.crs, _EARTH, *raster.bounds, densify_pts=51)
        except RasterioError as error:
            raise faults.no_place(name) from error
        self.bounds = Bounds(max(-180.0, west), max(-90.0, south), min(180.0, east), min(90.0, north))
        finite = all(map(math.isfinite, self.bounds))
        if not finite or west >= east or self.bounds.west_deg >= self.bounds.east_deg or south >= north:
            raise faults.no_place(name)
        self._to_metres = _M_PER_UNIT.get((raster.units[0] or "").strip().lower(), 1.0)
        self._is_geographic = raster.crs.to_epsg() == 4326
        self.datum = DATUM_OF_FORMAT["hgt"] if driver != _OTHER_DRIVER else _stated_datum(where)

    @property
    def pixel_deg(self) -> float:
        """The smaller side of a pixel, in degrees of latitude or longitude."""
        bounds, raster = self.bounds, self._raster
        down_deg = (bounds.north_deg - bounds.south_deg) / raster.height
        across_deg = (bounds.east_deg - bounds.west_deg) / raster.width
        return float(min(down_deg, across_deg))

    def at(self, longitudes_deg: Grid, latitudes_deg: Grid, step_deg: float) -> Grid:
        """Heights in metres above sea level on the grid of these coordinates, a row for each latitude.

        `step_deg`: the spacing of the grid; finer pixels are averaged. Each height depends only on its own position
        and the step, so that neighbouring grids agree at their common edge. Raises InvalidInputError.
        """
        return self._at(longitudes_deg, latitudes_deg, step_deg, of="height")

    def known(self, longitudes_deg: Grid, latitudes_deg: Grid, step_deg: float) -> npt.NDArray[np.bool_]:
        """Whether the raster has data at the places of `at`: in all that each height is made of."""
        return self._at(longitudes_deg, latitudes_deg, step_deg, of="known") >= _WHOLLY

    def close(self) -> None:
        """Close the file."""
        self._raster.close()

    def _at(self, longitudes_deg: Grid, latitudes_deg: Grid, step_deg: float, of: _Of) -> Grid:
        longitude, latitude = np.meshgrid(longitudes_deg, latitudes_deg)
        columns, rows = self._pixels(longitude.ravel(), latitude.ravel())
        size = 1
        while 2 * size * self.pixel_deg <= step_deg:
            size *= 2
        # Coordinates in blocks of size x size pixels, 0 at the centre of the first block.
        found = self._between(columns / size - 0.5, rows / size - 0.5, size, of)
        inside = (columns >= 0) & (columns <= self._raster.width) & (rows >= 0) & (rows <= self._raster.height)
        return np.where(inside, found, 0.0).reshape(longitude.shape)

    def _pixels(self, longitude: Grid, latitude: Grid) -> tuple[Grid, Grid]:
        """Fractional columns and rows; -1e9 for places that the projection cannot represent."""
        x, y = longitude, latitude
        if not self._is_geographic:
            x, y = self._projected(longitude, latitude)
        inverse = ~self._raster.transform
        columns = inverse.a * x + inverse.b * y + inverse.c
        rows = inverse.d * x + inverse.e * y + inverse.f
        reached = np.isfinite(columns) & np.isfinite(rows)
        return np.where(reached, columns, -1e9), np.where(reached, rows, -1e9)

    def _projected(self, longitude: Grid, latitude: Grid) -> tuple[Grid, Grid]:
        """The raster's own coordinates; NaN far from the raster, where many projections fail with an error."""
        bounds = self.bounds
        wide_deg = (bounds.east_deg - bounds.west_deg) * _BEYOND_BOUNDS
        high_deg = (bounds.north_deg - bounds.south_deg) * _BEYOND_BOUNDS
        near = (longitude >= bounds.west_deg - wide_deg) & (longitude <= bounds.east_deg + wide_deg)
        near &= (latitude >= bounds.south_deg - high_deg) & (latitude <= bounds.north_deg + high_deg)
        x, y = np.full(longitude.shape, np.nan), np.full(latitude.shape, np.nan)
        if near.any():
            found = transform(_EARTH, self._raster.crs, longitude[near].tolist(), latitude[near].tolist())
            x[near], y[near] = found[0], found[1]
        return x, y

    def _between(self, columns: Grid, rows: Grid, size: int, of: _Of) -> Grid:
        """Bilinear interpolation between the four blocks around each place."""
        last_column = math.ceil(self._raster.width / size) - 1
        last_row = math.ceil(self._raster.height / size) - 1
        column, row = np.clip(columns, 0, last_column), np.clip(rows, 0, last_row)
        left, top = np.floor(column).astype(int), np.floor(row).astype(int)
        right, bottom = np.minimum(left + 1, last_column), np.minimum(top + 1, last_row)
        base_column, base_row = int(left.min()), int(top.min())
        blocks = self._blocks(base_column, base_row, int(right.max()) + 1, int(bottom.max()) + 1, size, of)

        def block(at_row: npt.NDArray[np.int64], at_column: npt.NDArray[np.int64]) -> Grid:
            chosen: Grid = blocks[at_row - base_row, at_column - base_column]
            return chosen

        east, south = column - left, row - top
        upper = block(top, left) * (1 - east) + block(top, right) * east
        lower = block(bottom, left) * (1 - east) + block(bottom, right) * east
        between: Grid = upper * (1 - south) + lower * south
        return between

    def _blocks(self, left: int, top: int, right: int, bottom: int, size: int, of: _Of) -> Grid:
        """The mean of each block in this rectangle of blocks, read in strips to bound the memory."""
        found = np.zeros((bottom - top, right - left))
        side = min(size, _MOST_BLOCK_SIDE)
        at_once = max(1, _MOST_BLOCK_PIXELS // (side * side * (right - left)))
        for first in range(top, bottom, at_once):
            last = min(first + at_once, bottom)
            found[first - top : last - top] = self._means(left, first, right, last, size, of)
        return found

    def _means(self, left: int, top: int, right: int, bottom: int, size: int, of: _Of) -> Grid:
        raster = self._raster
        x0, y0 = left * size, top * size
        width, height = min(right * size, raster.width) - x0, min(bottom * size, raster.height) - y0
        # In a very large block sample only some pixels: all of them would not fit into memory.
        skip = max(1, size // _MOST_BLOCK_SIDE)
        kept = (math.ceil(height / skip), math.ceil(width / skip))
        try:
            read = raster.read(1, window=Window(x0, y0, width, height), out_shape=kept, masked=True)
        except RasterioError as error:
            raise faults.damaged(self._name, _words(error)) from error
        known = ~np.ma.getmaskarray(read) & np.isfinite(read.data)
        values: Grid
        if of == "known":
            values = known.astype(np.float64)
            known = np.ones_like(known)
        else:
            values = np.where(known, read.data.astype(np.float64) * raster.scales[0] + raster.offsets[0], 0.0)
            values *= self._to_metres
        side = size // skip
        if side == 1:
            return values
        pad = ((0, (bottom - top) * side - kept[0]), (0, (right - left) * side - kept[1]))
        shape = (bottom - top, side, right - left, side)
        total: Grid = np.pad(values, pad).reshape(shape).sum(axis=(1, 3))
        count: Grid = np.pad(known.astype(np.float64), pad).reshape(shape).sum(axis=(1, 3))
        return total / np.maximum(count, 1.0)


def _stated_datum(where: str) -> Datum | None:
    """The datum of a GeoTIFF's vertical coordinate system; None if it has none, or one that is not known."""
    # Files of GeoTIFF 1.0 say it too, but the library passes it on only if it is asked to.
    with rasterio.Env(GTIFF_REPORT_COMPD_CS=True), rasterio.open(where, driver=_OTHER_DRIVER) as raster:
        found = _VERTICAL.search(raster.crs.to_wkt())
        is_3d = raster.crs.to_epsg() == _EARTH_3D
    if found is None:
        return "ellipsoidal" if is_3d else None
    return datum_in(found[1].lower())


def _words(error: Exception) -> str:
    """The library's reason without the path, which clients need not know."""
    return _QUOTED_PATH.sub("", str(error)).rpartition("/")[2].rstrip(".")[:120] or type(error).__name__
