"""Rings and lines of the GSHHG as arrays: read, made simpler, and cut into the cells of a grid."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Final, NamedTuple

import numpy as np
import numpy.typing as npt

Points = npt.NDArray[np.float64]
"""Longitude and latitude in degrees, one row a point."""

Tolerance = Callable[[Points], npt.NDArray[np.float64]]
"""How far from the simpler line each point may lie, in metres."""

EARTH_M: Final = 6_371_000.0
_LEAST_OF_RING: Final = 4
_PASSES: Final = 40


class Grid(NamedTuple):
    """Square cells of `size_deg` over the world: columns from the date line east, rows from the south."""

    size_deg: float

    @property
    def columns(self) -> int:
        """Cells around the Earth."""
        return round(360 / self.size_deg)

    @property
    def rows(self) -> int:
        """Cells from pole to pole."""
        return round(180 / self.size_deg)

    def cell(self, longitude_deg: float, latitude_deg: float) -> tuple[int, int]:
        """Column and row of the cell that holds a place."""
        column = int((longitude_deg + 180) // self.size_deg) % self.columns
        return column, min(self.rows - 1, max(0, int((latitude_deg + 90) // self.size_deg)))


def read_shapes(folder: Path, name: str) -> list[Points]:
    """The shapes of one of the package's files (`gshhs`, `countries`), in full resolution."""
    values = np.fromfile(folder / f"{name}_f.dat", dtype="<f4").astype(np.float64)
    shapes = []
    for line in (folder / f"{name}meta_f.dat").read_text(encoding="ascii").splitlines():
        _kind, _area, count, _south, _north, first, _bytes, *_rest = line.split()
        start = int(first) // 4
        shapes.append(values[start : start + 2 * int(count)].reshape(-1, 2))
    return shapes


def extent_m(points: Points) -> float:
    """Roughly how far a shape reaches, in metres."""
    low, high = points.min(axis=0), points.max(axis=0)
    across = (high[0] - low[0]) * np.cos(np.radians((low[1] + high[1]) / 2))
    return float(np.radians(np.hypot(across, high[1] - low[1])) * EARTH_M)


def simpler(shapes: list[Points], tolerance_m: Tolerance, *, least: int = _LEAST_OF_RING) -> list[Points]:
    """The shapes without points that lie nearer than they may to the line between their neighbours.

    All shapes are worked on at once, in passes: in each, a point goes that lies nearer than both of its neighbours do.
    The first and the last point of each stay, and at least `least` points.
    """
    lengths = np.array([len(shape) for shape in shapes])
    points = np.concatenate(shapes)
    shape_of = np.repeat(np.arange(len(shapes)), lengths)
    for _ in range(_PASSES):
        away_m = _from_chord_m(points)
        is_end = np.ones(len(points), bool)
        is_end[1:-1] = (shape_of[1:-1] != shape_of[:-2]) | (shape_of[1:-1] != shape_of[2:])
        away_m[is_end] = np.inf
        away_m[np.bincount(shape_of, minlength=len(shapes))[shape_of] <= least] = np.inf
        goes = away_m < tolerance_m(points)
        # Of two neighbours the nearer goes first; of equals the earlier.
        goes[1:] &= away_m[1:] < away_m[:-1]
        goes[:-1] &= away_m[:-1] <= away_m[1:]
        if not goes.any():
            break
        points, shape_of = points[~goes], shape_of[~goes]
    ends = np.cumsum(np.bincount(shape_of, minlength=len(shapes)))
    return [part for part in np.split(points, ends[:-1]) if len(part) > 0]


def _from_chord_m(points: Points) -> npt.NDArray[np.float64]:
    """How far each point lies from the line between its neighbours, on a plane that touches the Earth there."""
    away = np.full(len(points), np.inf)
    before, here, after = points[:-2], points[1:-1], points[2:]
    scale = np.radians(1) * EARTH_M
    across = np.cos(np.radians(here[:, 1]))
    along_x, along_y = (after[:, 0] - before[:, 0]) * across, after[:, 1] - before[:, 1]
    from_x, from_y = (here[:, 0] - before[:, 0]) * across, here[:, 1] - before[:, 1]
    length = np.hypot(along_x, along_y)
    area = np.abs(along_x * from_y - along_y * from_x)
    near = np.hypot(from_x, from_y)
    away[1:-1] = scale * np.where(length > 0, area / np.where(length > 0, length, 1), near)
    return away


def cut_ring(ring: Points, grid: Grid) -> Iterator[tuple[tuple[int, int], Points]]:
    """The parts of a filled ring by the cell that holds them; edges that are made by cutting lie on the cell's border.

    Longitudes may lie beyond 180°, as the GSHHG has them.
    """
    for column, piece in _cut_axis(ring, 0, -180, grid.size_deg):
        shifted = piece - [360 * (column // grid.columns), 0] if not 0 <= column < grid.columns else piece
        for row, part in _cut_axis(shifted, 1, -90, grid.size_deg):
            if 0 <= row < grid.rows:
                yield (column % grid.columns, row), part


def cut_line(line: Points, grid: Grid) -> Iterator[tuple[tuple[int, int], Points]]:
    """The parts of a line by cell; neighbouring parts share the point between them."""
    cells = np.floor((line - [-180, -90]) / grid.size_deg).astype(int)
    breaks = np.flatnonzero((cells[1:] != cells[:-1]).any(axis=1)) + 1
    starts, ends = [0, *breaks], [*breaks, len(line)]
    for start, end in zip(starts, ends, strict=True):
        column, row = cells[start]
        part = line[start : min(len(line), end + 1)]
        shift = 360 * (column // grid.columns)
        if len(part) > 1:
            yield (int(column % grid.columns), min(grid.rows - 1, max(0, int(row)))), part - [shift, 0]


def _cut_axis(ring: Points, axis: int, origin: float, size: float) -> Iterator[tuple[int, Points]]:
    """The strips of a ring along an axis, halved until each lies in one."""
    first = int(np.floor((ring[:, axis].min() - origin) / size))
    last = int(np.ceil((ring[:, axis].max() - origin) / size)) - 1
    if last <= first:
        yield first, ring
        return
    middle = origin + size * ((first + last + 1) // 2)
    for is_low in (True, False):
        half = _half(ring, axis, middle, is_low=is_low)
        if len(half) >= _LEAST_OF_RING - 1 and np.ptp(half[:, axis]) > 0:
            yield from _cut_axis(half, axis, origin, size)


def _half(ring: Points, axis: int, at: float, *, is_low: bool) -> Points:
    """The part of a filled ring on one side of a straight line (Sutherland and Hodgman)."""
    values = ring[:, axis] if is_low else -ring[:, axis]
    limit = at if is_low else -at
    inside = values <= limit
    if inside.all():
        return ring
    before = np.roll(ring, 1, axis=0)
    crosses = inside != np.roll(inside, 1)
    places = np.cumsum(crosses.astype(int) + inside) - inside
    cut = np.empty((int(crosses.sum() + inside.sum()), 2))
    cut[places[inside]] = ring[inside]
    start, end = before[crosses], ring[crosses]
    share = (at - start[:, axis]) / (end[:, axis] - start[:, axis])
    crossing = start + share[:, None] * (end - start)
    crossing[:, axis] = at
    cut[places[crosses] - 1] = crossing
    return cut
