"""Terrain tiles as Cesium reads them (quantized-mesh 1.0), from a regular grid of heights.

A regular grid instead of a simplified mesh: neighbouring tiles of one level have the same points on their common edge,
so there are no cracks between them; and the indices are the same for every tile and are packed once.
"""

from __future__ import annotations

import struct
from functools import cache
from typing import Final, NamedTuple

import numpy as np
import numpy.typing as npt

CELLS: Final = 64
"""Cells along each side of a tile, which has one point more."""

LARGEST: Final = 32767
"""Positions and heights are shares of this."""

KNOWN_EXTENSION: Final = 100
"""Our own extension of the format, which other readers skip: a bit for each point of the grid, row by row from the
south, set where the source knows the height."""

Heights = npt.NDArray[np.float64]
Known = npt.NDArray[np.bool_]
_Vectors = npt.NDArray[np.float64]

# WGS 84, in metres.
_RADII_M: Final = np.array([6378137.0, 6378137.0, 6356752.314245179])
_HEADER: Final = struct.Struct("<3d2f3dd3d")
# Used as distance of the occlusion point for tiles so wide that no such point exists: they are never culled.
_NEVER_HIDDEN: Final = 1e3


class TileBounds(NamedTuple):
    """The rectangle of a tile."""

    west_deg: float
    south_deg: float
    east_deg: float
    north_deg: float


class _Grid(NamedTuple):
    """What all tiles have in common. `order`: index in the grid (row by row from the south) of each vertex."""

    order: npt.NDArray[np.int64]
    positions: bytes
    indices: bytes


def tile_bounds(zoom: int, column: int, row: int) -> TileBounds:
    """The rectangle of a tile; zoom 0 has two tiles side by side, rows count from the south."""
    size_deg = 180.0 / (1 << zoom)
    return TileBounds(
        column * size_deg - 180.0, row * size_deg - 90.0, (column + 1) * size_deg - 180.0, (row + 1) * size_deg - 90.0
    )


def tile_nodes(zoom: int, column: int, row: int) -> tuple[_Vectors, _Vectors]:
    """Longitudes from the west and latitudes from the south of the grid's points, in degrees.

    A point on a common edge has exactly the same coordinates, to the last bit, in both tiles.
    """
    step_deg = 180.0 / (1 << zoom) / CELLS
    places = np.arange(CELLS + 1, dtype=np.float64)
    return (column * CELLS + places) * step_deg - 180.0, (row * CELLS + places) * step_deg - 90.0


def encode_tile(zoom: int, column: int, row: int, heights_m: Heights, known: Known | None = None) -> bytes:
    """The tile as a file. `heights_m`: one row of CELLS + 1 numbers for each latitude, from the south.

    `known`: which of them the source has; None: all. The others are drawn too, but are no heights.
    """
    grid = _grid()
    longitude, latitude = np.meshgrid(*tile_nodes(zoom, column, row))
    lowest_m, highest_m = float(heights_m.min()), float(heights_m.max())
    span_m = highest_m - lowest_m
    scale = LARGEST / span_m if span_m > 0 else 0.0
    quantized = np.round((heights_m.ravel()[grid.order] - lowest_m) * scale).astype(np.int64)
    return b"".join(
        (
            mesh_header(longitude.ravel(), latitude.ravel(), heights_m.ravel()),
            struct.pack("<I", grid.order.size),
            grid.positions,
            zigzag(quantized),
            grid.indices,
            b"" if known is None or bool(known.all()) else _extension(KNOWN_EXTENSION, np.packbits(known).tobytes()),
        )
    )


def _extension(number: int, data: bytes) -> bytes:
    return struct.pack("<BI", number, len(data)) + data


def mesh_header(longitude_deg: _Vectors, latitude_deg: _Vectors, height_m: _Vectors) -> bytes:
    """The header of a tile with these vertices."""
    points_m = earth_points(longitude_deg, latitude_deg, height_m)
    centre_m = (points_m.min(axis=0) + points_m.max(axis=0)) / 2.0
    radius_m = float(np.sqrt(((points_m - centre_m) ** 2).sum(axis=1)).max())
    hiding = _hiding_point(points_m, centre_m)
    return _HEADER.pack(*centre_m, float(height_m.min()), float(height_m.max()), *centre_m, radius_m, *hiding)


def earth_points(longitude_deg: _Vectors, latitude_deg: _Vectors, height_m: _Vectors) -> _Vectors:
    """Earth-fixed x (through Greenwich), y, z (through the pole) in metres; heights are above the ellipsoid."""
    longitude, latitude = np.radians(longitude_deg), np.radians(latitude_deg)
    flat = 1.0 - (_RADII_M[2] / _RADII_M[0]) ** 2
    normal_m = _RADII_M[0] / np.sqrt(1.0 - flat * np.sin(latitude) ** 2)
    across_m = (normal_m + height_m) * np.cos(latitude)
    up_m = (normal_m * (1.0 - flat) + height_m) * np.sin(latitude)
    return np.stack([across_m * np.cos(longitude), across_m * np.sin(longitude), up_m], axis=1)


def _hiding_point(points_m: _Vectors, centre_m: _Vectors) -> _Vectors:
    """The horizon occlusion point, in radii of the ellipsoid: if it is below the horizon, so is the whole tile."""
    scaled = points_m / _RADII_M
    towards = centre_m / _RADII_M
    length = float(np.linalg.norm(towards))
    if length < 1e-9:
        return np.array([0.0, 0.0, _NEVER_HIDDEN])
    towards = towards / length
    size = np.linalg.norm(scaled, axis=1)
    direction = scaled / size[:, None]
    size = np.maximum(size, 1.0)
    cos_alpha = direction @ towards
    sin_alpha = np.linalg.norm(np.cross(direction, towards), axis=1)
    cos_beta = 1.0 / size
    sin_beta = np.sqrt(size * size - 1.0) * cos_beta
    share = cos_alpha * cos_beta - sin_alpha * sin_beta
    least = float(share.min())
    far = min(1.0 / least, _NEVER_HIDDEN) if least > 0 else _NEVER_HIDDEN
    hiding: _Vectors = towards * far
    return hiding


@cache
def _grid() -> _Grid:
    """Two triangles per cell, anticlockwise seen from above. Vertices are numbered in the order of their first use,
    which the format's high-water-mark encoding of indices requires."""
    side = CELLS + 1
    corner = (np.arange(CELLS)[:, None] * side + np.arange(CELLS)[None, :]).ravel()
    south_west, south_east, north_west, north_east = corner, corner + 1, corner + side, corner + side + 1
    triangles = np.stack([south_west, south_east, north_east, south_west, north_east, north_west], axis=1).ravel()
    places, first_use = np.unique(triangles, return_index=True)
    order = places[np.argsort(first_use)]
    number = np.empty(side * side, dtype=np.int64)
    number[order] = np.arange(order.size)
    u = np.round(order % side * (LARGEST / CELLS)).astype(np.int64)
    v = np.round(order // side * (LARGEST / CELLS)).astype(np.int64)
    along = np.arange(side)
    edges = (along * side, along, along * side + CELLS, CELLS * side + along)  # west, south, east, north
    packed_edges = [struct.pack("<I", side) + number[edge].astype("<u2").tobytes() for edge in edges]
    indices = struct.pack("<I", triangles.size // 3) + _below_highest(number[triangles]) + b"".join(packed_edges)
    return _Grid(order, zigzag(u) + zigzag(v), indices)


def zigzag(values: npt.NDArray[np.int64]) -> bytes:
    """Differences of neighbouring values in zigzag encoding: the sign is in the lowest bit."""
    steps = np.diff(values, prepend=0)
    return ((steps << 1) ^ (steps >> 63)).astype("<u2").tobytes()


def _below_highest(indices: npt.NDArray[np.int64]) -> bytes:
    """High-water-mark encoding: each index as its distance below the next index not used so far."""
    is_new = np.zeros(indices.size, dtype=np.int64)
    is_new[np.unique(indices, return_index=True)[1]] = 1
    next_new = np.concatenate([[0], np.cumsum(is_new)[:-1]])
    return (next_new - indices).astype("<u2").tobytes()
