"""The file that ships: one after the other the cells of a level's grid in which there is anything.

A cell is gzip of
1. the length of the text, 4 bytes; all numbers of several bytes are little endian;
2. the text (JSON, UTF-8): of each table its columns, without the places;
3. for each table of the text in turn the x of all its rows, then their y, 2 bytes each: shares of the cell's side in
   65535ths, from west and south; of `places` also the size of each, 1 byte: eight times the binary logarithm of the
   people;
4. the shapes as variable-length numbers: the count of rings, of each ring the count of its points and their steps in
   x and y from the point before (the first from 0, 0), in 32768ths of the cell's side; then the same for the lines of
   borders. Rings are filled by the even-odd rule; edges on the cell's border are no coast.
"""

from __future__ import annotations

import gzip
import json
from collections import defaultdict
from typing import Any, BinaryIO, Final

import numpy as np
import numpy.typing as npt

from tools.world_map.shapes import Grid, Points

UNITS: Final = 32_768
_PLACE_UNITS: Final = 65_535
_LEAST_OF_RING: Final = 3
_LEAST_OF_LINE: Final = 2

PLACES: Final = "places"

Cell = tuple[int, int]
Whole = npt.NDArray[np.int64]


class Cells:
    """What lies in each cell of one level."""

    def __init__(self, grid: Grid) -> None:
        self.grid = grid
        self._land: defaultdict[Cell, list[Whole]] = defaultdict(list)
        self._borders: defaultdict[Cell, list[Whole]] = defaultdict(list)
        self._things: defaultdict[Cell, dict[str, list[Any]]] = defaultdict(dict)

    def add_land(self, cell: Cell, ring: Points) -> None:
        """A part of a filled ring that lies in this cell."""
        self._add(self._land, cell, ring, _LEAST_OF_RING)

    def add_border(self, cell: Cell, line: Points) -> None:
        """A part of a border that begins in this cell."""
        self._add(self._borders, cell, line, _LEAST_OF_LINE)

    def add_thing(self, kind: str, longitude_deg: float, latitude_deg: float, thing: list[Any]) -> None:
        """A row of the table `kind` in the cell of its place."""
        column, row = cell = self.grid.cell(longitude_deg, latitude_deg)
        size_deg = self.grid.size_deg
        x = (longitude_deg + 180 - column * size_deg) / size_deg
        y = (latitude_deg + 90 - row * size_deg) / size_deg
        place = [round(min(1.0, max(0.0, share)) * _PLACE_UNITS) for share in (x, y)]
        self._things[cell].setdefault(kind, []).append([*place, *thing])

    def write(self, file: BinaryIO) -> dict[str, tuple[int, int]]:
        """Append all cells; returns by `COLUMN-ROW` the first byte and how many."""
        filled = {}
        for column, row in sorted({*self._land, *self._borders, *self._things}):
            packed = self._packed((column, row))
            filled[f"{column}-{row}"] = file.tell(), len(packed)
            file.write(packed)
        return filled

    def _add(self, shapes: defaultdict[Cell, list[Whole]], cell: Cell, points: Points, least: int) -> None:
        west, south = cell[0] * self.grid.size_deg - 180, cell[1] * self.grid.size_deg - 90
        whole = np.rint((points - [west, south]) / self.grid.size_deg * UNITS).astype(np.int64)
        moved = np.ones(len(whole), bool)
        moved[1:] = (whole[1:] != whole[:-1]).any(axis=1)
        whole = whole[moved]
        if len(whole) >= least:
            shapes[cell].append(whole)

    def _packed(self, cell: Cell) -> bytes:
        text: dict[str, list[list[Any]]] = {}
        places = b""
        for kind, rows in self._things.get(cell, {}).items():
            # Columns pack better than rows.
            x, y, *columns = zip(*rows, strict=True)
            places += np.array([x, y], "<u2").tobytes()
            if kind == PLACES:
                places += bytes(columns.pop())
            text[kind] = [list(column) for column in columns]
        packed = json.dumps(text, ensure_ascii=False, separators=(",", ":")).encode()
        numbers = [*_numbers(self._land.get(cell, [])), *_numbers(self._borders.get(cell, []))]
        return gzip.compress(len(packed).to_bytes(4, "little") + packed + places + variable_length(numbers), 9, mtime=0)


def _numbers(shapes: list[Whole]) -> list[int]:
    numbers = [len(shapes)]
    for shape in shapes:
        numbers.append(len(shape))
        steps = np.diff(shape, axis=0, prepend=[[0, 0]]).ravel()
        # Small numbers of either sign become small ones without.
        numbers.extend(np.where(steps < 0, -2 * steps - 1, 2 * steps).tolist())
    return numbers


def variable_length(numbers: list[int]) -> bytes:
    """Each number in groups of seven bits, the lowest first; all groups but its last have the eighth bit set."""
    packed = bytearray()
    for number in numbers:
        rest = number
        while rest > 0x7F:
            packed.append(0x80 | rest & 0x7F)
            rest >>= 7
        packed.append(rest)
    return bytes(packed)
