"""Land and borders in each cell of a level."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import numpy as np
import numpy.typing as npt

from tools.world_map.cells import Cells
from tools.world_map.shapes import Points, Tolerance, cut_line, cut_ring, extent_m, read_shapes, simpler

POLAR_DEG: Final = 66.5
_POLAR_M: Final = 400.0
# Where the station's built-in routes are flown nothing of the source is left out that its own errors do not hide.
_HOME: Final = (-19.2, 26.8, -12.4, 30.2)
_HOME_M: Final = 8.0
# Shapes that would be seen as less than a dot at a level are left out: their extent in tolerances.
_LEAST_EXTENT: Final = 1.5


def coast_tolerance(usual_m: float) -> Tolerance:
    """The tolerance of a level: finer around the Canary Islands and coarser near the poles on the finest one."""

    def tolerance_m(points: Points) -> npt.NDArray[np.float64]:
        west, south, east, north = _HOME
        longitude, latitude = points[:, 0], points[:, 1]
        at_home = (longitude > west) & (longitude < east) & (latitude > south) & (latitude < north)
        polar = np.where(np.abs(latitude) > POLAR_DEG, max(_POLAR_M, usual_m), usual_m)
        return np.where(at_home, min(_HOME_M, usual_m), polar)

    return tolerance_m


def even_tolerance(usual_m: float) -> Tolerance:
    """The same tolerance everywhere."""
    return lambda points: np.full(len(points), usual_m)


class Source:
    """The package's shapes, read once: rings of land, lakes and islands in lakes; lines of borders."""

    def __init__(self, folder: Path) -> None:
        self._rings = read_shapes(folder, "gshhs")
        self._borders = read_shapes(folder, "countries")

    def fill(self, cells: Cells, *, tolerance: Tolerance, least_m: float) -> None:
        """Put into the cells all that reaches `least_m` or further."""
        rings = [ring for ring in self._rings if extent_m(ring) >= _LEAST_EXTENT * least_m]
        for ring in simpler(rings, tolerance):
            for cell, part in cut_ring(ring, cells.grid):
                cells.add_land(cell, part)
        for line in simpler(self._borders, tolerance, least=2):
            for cell, part in cut_line(line, cells.grid):
                cells.add_border(cell, part)
