"""The geoid EGM96: how high the mean sea is above the ellipsoid WGS 84, anywhere.

Height above the ellipsoid = height above the sea + `geoid_m`. `egm96.bin` is made by `tools/geoid.py`.
"""

from __future__ import annotations

import zlib
from functools import cache
from importlib.resources import files
from typing import Final

import numpy as np
import numpy.typing as npt

PER_DEG: Final = 4
"""Points of the grid in each degree."""
ROWS: Final = 180 * PER_DEG + 1
"""From the north pole to the south pole, both inclusive."""
COLUMNS: Final = 360 * PER_DEG
"""From Greenwich to the east."""
UNIT_M: Final = 0.05
"""Steps of the file's heights: what is lost of the published grid is 0.02 m."""

_FILE: Final = "egm96.bin"

Degrees = float | npt.NDArray[np.float64]


def geoid_m(latitude_deg: Degrees, longitude_deg: Degrees) -> npt.NDArray[np.float64]:
    """Height of the sea above the ellipsoid in metres, -107..86, in the arguments' common shape; NaN for NaN.

    Latitude -90..90, north positive, and any longitude, east positive. Bilinear in a grid of 15 minutes.
    """
    latitude = np.asarray(latitude_deg, dtype=np.float64)
    longitude = np.asarray(longitude_deg, dtype=np.float64)
    is_known = np.isfinite(latitude) & np.isfinite(longitude)
    from_north = np.clip((90.0 - np.where(is_known, latitude, 0.0)) * PER_DEG, 0.0, ROWS - 1.0)
    from_west = np.mod(np.where(is_known, longitude, 0.0) * PER_DEG, COLUMNS)
    # The last row is reached from the one above it, so that there is always a row below.
    row = np.minimum(from_north.astype(np.int64), ROWS - 2)
    column = np.minimum(from_west.astype(np.int64), COLUMNS - 1)
    south, east = from_north - row, from_west - column
    grid, next_column = grid_m(), (column + 1) % COLUMNS
    upper = grid[row, column] * (1.0 - east) + grid[row, next_column] * east
    lower = grid[row + 1, column] * (1.0 - east) + grid[row + 1, next_column] * east
    return np.where(is_known, upper * (1.0 - south) + lower * south, np.nan)


@cache
def grid_m() -> npt.NDArray[np.float32]:
    """All points, ROWS x COLUMNS in metres, row by row from the north; 4 MB, kept once it was read."""
    return unpacked_m(files(__package__).joinpath(_FILE).read_bytes())


def packed(heights_m: npt.NDArray[np.float64]) -> bytes:
    """The grid as its file: differences in both directions, low bytes before high ones, compressed."""
    steps = np.round(heights_m / UNIT_M).astype(np.int64)
    steps = np.diff(np.diff(steps, axis=0, prepend=0), axis=1, prepend=0)
    codes = ((steps << 1) ^ (steps >> 63)).astype("<u2")
    return zlib.compress(codes.ravel().view(np.uint8).reshape(-1, 2).T.tobytes(), 9)


def unpacked_m(data: bytes) -> npt.NDArray[np.float32]:
    """The grid of a file of `packed`."""
    codes = np.frombuffer(zlib.decompress(data), np.uint8).reshape(2, ROWS * COLUMNS).T.copy().view("<u2")
    codes = codes.reshape(ROWS, COLUMNS).astype(np.int64)
    steps = (codes >> 1) ^ -(codes & 1)
    return (np.cumsum(np.cumsum(steps, axis=1), axis=0) * UNIT_M).astype(np.float32)
