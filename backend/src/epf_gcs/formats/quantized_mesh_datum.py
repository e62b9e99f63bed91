"""Turns a tile of terrain with heights above the ellipsoid into one with heights above the sea.

The tile may be a stranger's: as in `quantized_mesh_reading`, memory is bounded. Its triangles, normals and other
extensions stay as they are.
"""

from __future__ import annotations

import math
import struct
from typing import Final

import numpy as np
import numpy.typing as npt

from epf_gcs.formats.quantized_mesh import LARGEST, mesh_header, tile_bounds, zigzag
from epf_gcs.formats.quantized_mesh_reading import HEIGHTS, HEIGHTS_AT, VERTICES_AT, unpacked, unzigzag
from epf_gcs.geoid import geoid_m

_COUNT_BYTES: Final = 4

_Vectors = npt.NDArray[np.float64]


def above_sea(data: bytes, zoom: int, column: int, row: int, *, is_mercator: bool = False) -> bytes:
    """The tile, unpacked. `row` from the south; `is_mercator`: of the pyramid of web maps, one tile at zoom 0.

    Raises ValueError if it is no tile of terrain.
    """
    data = unpacked(data)
    try:
        lowest_m, highest_m = HEIGHTS.unpack_from(data, HEIGHTS_AT)
        (count,) = struct.unpack_from("<I", data, VERTICES_AT)
    except struct.error as error:
        raise ValueError("a tile of terrain is cut off") from error
    at = VERTICES_AT + _COUNT_BYTES
    if count == 0 or at + 6 * count > len(data):
        raise ValueError("a tile of terrain is cut off")
    if not (math.isfinite(lowest_m) and math.isfinite(highest_m)):
        raise ValueError("a tile of terrain has no heights")
    u, v, h = (unzigzag(data, at + 2 * count * which, count) / LARGEST for which in range(3))
    place = _mercator_places if is_mercator else _places
    longitude_deg, latitude_deg = place(u, v, zoom, column, row)
    heights_m = lowest_m + h * (highest_m - lowest_m) - geoid_m(latitude_deg, longitude_deg)
    lowest_m, highest_m = float(heights_m.min()), float(heights_m.max())
    scale = LARGEST / (highest_m - lowest_m) if highest_m > lowest_m else 0.0
    quantized = np.round((heights_m - lowest_m) * scale).astype(np.int64)
    header = mesh_header(longitude_deg, latitude_deg, heights_m)
    return b"".join((header, data[VERTICES_AT : at + 4 * count], zigzag(quantized), data[at + 6 * count :]))


def _places(u: _Vectors, v: _Vectors, zoom: int, column: int, row: int) -> tuple[_Vectors, _Vectors]:
    bounds = tile_bounds(zoom, column, row)
    longitude_deg = bounds.west_deg + u * (bounds.east_deg - bounds.west_deg)
    return longitude_deg, bounds.south_deg + v * (bounds.north_deg - bounds.south_deg)


def _mercator_places(u: _Vectors, v: _Vectors, zoom: int, column: int, row: int) -> tuple[_Vectors, _Vectors]:
    count = 1 << zoom
    from_south = (row + v) / count
    return (column + u) / count * 360.0 - 180.0, np.degrees(np.arctan(np.sinh(np.pi * (2.0 * from_south - 1.0))))
