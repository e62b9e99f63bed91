"""Heights on a regular grid, from a terrain tile of any program (quantized-mesh 1.0).

The tile may be a stranger's: reading takes bounded memory, and runs in a process with limits of time.
"""

from __future__ import annotations

import struct
import zlib
from typing import Final

import numpy as np
import numpy.typing as npt

from epf_gcs.formats.quantized_mesh import CELLS, KNOWN_EXTENSION

SIDE: Final = CELLS + 1
"""Points along each side of the grid, on the tile's borders too."""

HEIGHTS: Final = struct.Struct("<2f")
"""The lowest and the highest height, metres."""
HEIGHTS_AT: Final = 24
VERTICES_AT: Final = 88
"""Where the number of vertices is."""

_MOST_BYTES: Final = 16_000_000
_MOST_TRIANGLES: Final = 200_000
_LARGEST: Final = 32767.0
_SHORT_INDICES: Final = 65_536
# A place on a common edge is in one of the triangles, whatever the rounding.
_EDGE: Final = -1e-9
_GZIP: Final = b"\x1f\x8b"
_EXTENSION: Final = struct.Struct("<BI")
_EDGES: Final = 4

_Numbers = npt.NDArray[np.int64]


def read_grid(data: bytes) -> bytes:
    """SIDE x SIDE heights in metres above the sea as f32, row by row from the south; NaN: not known.

    Raises ValueError if it is no tile of terrain, or one of too many triangles.
    """
    data = unpacked(data)
    try:
        return _grid(data).astype("<f4").tobytes()
    except (struct.error, IndexError) as error:
        raise ValueError("a tile of terrain is cut off") from error


def unpacked(data: bytes) -> bytes:
    """The tile without gzip. Raises ValueError if it is damaged or too large."""
    if not data.startswith(_GZIP):
        return data
    unpacking = zlib.decompressobj(wbits=31)
    try:
        found = unpacking.decompress(data, _MOST_BYTES)
    except zlib.error as error:
        raise ValueError("a tile of terrain cannot be unpacked") from error
    if not unpacking.eof:
        raise ValueError("a tile of terrain is too large")
    return found


def _grid(data: bytes) -> npt.NDArray[np.float64]:
    lowest_m, highest_m = HEIGHTS.unpack_from(data, HEIGHTS_AT)
    (count,) = struct.unpack_from("<I", data, VERTICES_AT)
    width = 4 if count > _SHORT_INDICES else 2
    at = VERTICES_AT + 4
    if count == 0 or at + 6 * count > len(data):
        raise ValueError("a tile of terrain is cut off")
    u, v, h = (unzigzag(data, at + 2 * count * which, count) for which in range(3))
    at += 6 * count
    at += -at % width
    (triangles,) = struct.unpack_from("<I", data, at)
    at += 4
    if triangles > _MOST_TRIANGLES:
        raise ValueError(f"a tile of terrain has {triangles} triangles")
    indices = _unmarked(_numbers(data, at, 3 * triangles, width))
    if indices.size and not (int(indices.min()) >= 0 and int(indices.max()) < count):
        raise ValueError("a tile of terrain has triangles without corners")
    at += 3 * triangles * width
    heights_m = lowest_m + h / _LARGEST * (highest_m - lowest_m)
    grid = _at_nodes(u / _LARGEST * CELLS, v / _LARGEST * CELLS, heights_m, indices.reshape(-1, 3))
    known = _known(data, at, width)
    if known is not None:
        grid[~known] = np.nan
    return grid


def _at_nodes(
    x: npt.NDArray[np.float64], y: npt.NDArray[np.float64], heights_m: npt.NDArray[np.float64], triangles: _Numbers
) -> npt.NDArray[np.float64]:
    """The mesh's height at each point of the grid; `x` and `y` of its vertices in cells."""
    grid = np.full((SIDE, SIDE), np.nan)
    column, row = np.round(x).astype(np.int64), np.round(y).astype(np.int64)
    # A node and a vertex at the same place, to the format's rounding.
    exact = (np.abs(x - column) < 2 * CELLS / _LARGEST) & (np.abs(y - row) < 2 * CELLS / _LARGEST)
    grid[row[exact], column[exact]] = heights_m[exact]
    if bool(exact.all()) and len(x) == SIDE * SIDE:
        return grid
    for corners in triangles:
        _fill(grid, x[corners], y[corners], heights_m[corners])
    return grid


def _fill(
    grid: npt.NDArray[np.float64],
    x: npt.NDArray[np.float64],
    y: npt.NDArray[np.float64],
    heights_m: npt.NDArray[np.float64],
) -> None:
    """The heights of the points in one triangle."""
    twice = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0])
    if twice == 0.0:
        return
    left, right = max(0, int(np.ceil(x.min() - 1e-9))), min(CELLS, int(np.floor(x.max() + 1e-9)))
    low, high = max(0, int(np.ceil(y.min() - 1e-9))), min(CELLS, int(np.floor(y.max() + 1e-9)))
    if left > right or low > high:
        return
    at_x, at_y = np.meshgrid(np.arange(left, right + 1), np.arange(low, high + 1))
    second = ((at_x - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (at_y - y[0])) / twice
    third = ((x[1] - x[0]) * (at_y - y[0]) - (at_x - x[0]) * (y[1] - y[0])) / twice
    inside = (second >= _EDGE) & (third >= _EDGE) & (second + third <= 1.0 - _EDGE)
    found = heights_m[0] * (1.0 - second - third) + heights_m[1] * second + heights_m[2] * third
    grid[at_y[inside], at_x[inside]] = found[inside]


def _known(data: bytes, at: int, width: int) -> npt.NDArray[np.bool_] | None:
    """Which points our own extension calls known; None without it."""
    for _ in range(_EDGES):
        (count,) = struct.unpack_from("<I", data, at)
        at += 4 + count * width
    while at + _EXTENSION.size <= len(data):
        number, length = _EXTENSION.unpack_from(data, at)
        at += _EXTENSION.size
        if number == KNOWN_EXTENSION and length == -(-SIDE * SIDE // 8) and at + length <= len(data):
            bits = np.unpackbits(np.frombuffer(data, np.uint8, length, at), count=SIDE * SIDE)
            return bits.astype(np.bool_).reshape(SIDE, SIDE)
        at += length
    return None


def unzigzag(data: bytes, at: int, count: int) -> _Numbers:
    """`count` numbers at this place, each kept as its difference from the one before."""
    codes = _numbers(data, at, count, 2)
    return np.cumsum((codes >> 1) ^ -(codes & 1))


def _unmarked(codes: _Numbers) -> _Numbers:
    """Each code is the distance below the next index that was not used before."""
    highest = np.concatenate([[0], np.cumsum(codes == 0)[:-1]]) if codes.size else codes
    return highest - codes


def _numbers(data: bytes, at: int, count: int, width: int) -> _Numbers:
    if at + count * width > len(data):
        raise ValueError("a tile of terrain is cut off")
    return np.frombuffer(data, "<u2" if width == 2 else "<u4", count, at).astype(np.int64)
