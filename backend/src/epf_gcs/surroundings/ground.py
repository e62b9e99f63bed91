"""The heights around the aircraft, from the station's terrain: a few tiles in memory, the others read when needed.

`heights` never waits: a tile that is not here yet is not known, and is asked for.
"""

from __future__ import annotations

import asyncio
import math
from collections import OrderedDict
from collections.abc import Iterable, Iterator, Sequence
from typing import Final, NamedTuple, Protocol

import numpy as np
import numpy.typing as npt

from epf_gcs.contract.surroundings import HeightSet
from epf_gcs.errors import GatewayError
from epf_gcs.formats.quantized_mesh import CELLS
from epf_gcs.formats.quantized_mesh_reading import SIDE
from epf_gcs.geoid import geoid_m
from epf_gcs.maps.layer import Datum, Layer
from epf_gcs.surroundings.motion import Vector

# Points 19 m apart at the equator: finer heights change no warning.
_FINEST: Final = 14
# A tile that is not there is looked for so many levels higher.
_PARENTS: Final = 6
_MOST_KEPT: Final = 128
_LAYERS_S: Final = 10.0
# A tile that could not be read is tried again after this long.
_AGAIN_S: Final = 15.0


class Tiles(Protocol):
    """Where the heights come from (`web.maps.maps.Maps`)."""

    async def terrain_layers(self) -> list[Layer]:
        """The layers of terrain, the finest first."""

    async def grid(self, layer_id: str, zoom: int, column: int, row: int) -> bytes | None:
        """The heights of one tile."""


class _Key(NamedTuple):
    layer: str
    zoom: int
    column: int
    row: int


class _GridEntry(NamedTuple):
    """`zoom` and so on: of the tile whose grid this is, the asked one or a parent. None: there is none."""

    grid: npt.NDArray[np.float32] | None
    zoom: int
    column: int
    row: int
    until_s: float


class Ground:
    """Belongs to the event loop."""

    def __init__(self, tiles: Tiles) -> None:
        self._tiles = tiles
        self._layers: list[Layer] = []
        self._held: OrderedDict[_Key, _GridEntry] = OrderedDict()
        self._wanted: dict[_Key, None] = {}
        self._awake = asyncio.Event()

    @property
    def has_heights(self) -> bool:
        """The station has heights of some ground."""
        return bool(self._layers)

    def heights(self, latitude_deg: Vector, longitude_deg: Vector) -> Vector:
        """Metres above the sea; NaN where not known, or not read yet."""
        found = np.full(latitude_deg.shape, np.nan)
        for _ in self._fill(found, latitude_deg, longitude_deg):
            pass
        return found

    def sets(self, latitude_deg: Vector, longitude_deg: Vector) -> list[HeightSet]:
        """The sets that the heights at these places are of, the finest first."""
        found = np.full(latitude_deg.shape, np.nan)
        return [
            HeightSet(layer.name, layer.datum, _farthest_geoid_m(latitude_deg[here], longitude_deg[here]))
            for layer, here in self._fill(found, latitude_deg, longitude_deg)
            if here.size
        ]

    def _fill(
        self, found: Vector, latitude_deg: Vector, longitude_deg: Vector
    ) -> Iterator[tuple[Layer, npt.NDArray[np.intp]]]:
        """Fill in the heights that are known, and say which places each layer gave."""
        now_s = asyncio.get_running_loop().time()
        for layer in self._layers:
            missing = np.flatnonzero(np.isnan(found) & _covered(layer, latitude_deg, longitude_deg))
            if missing.size:
                found[missing] = self._of_layer(layer, latitude_deg[missing], longitude_deg[missing], now_s)
                yield layer, missing[~np.isnan(found[missing])]

    async def read(self, latitude_deg: Vector, longitude_deg: Vector) -> Vector:
        """The same as `heights`, once the tiles below have been read; NaN where the station knows no height."""
        await self._look_for_layers()
        found = self.heights(latitude_deg, longitude_deg)
        # Each turn asks a coarser layer for what a finer one does not have.
        for _ in self._layers:
            if not self._wanted:
                break
            await self.read_wanted()
            found = self.heights(latitude_deg, longitude_deg)
        return found

    async def run(self) -> None:
        """Look for layers and read the tiles that are wanted, forever."""
        while True:
            await self._look_for_layers()
            until_s = asyncio.get_running_loop().time() + _LAYERS_S
            while (left_s := until_s - asyncio.get_running_loop().time()) > 0:
                try:
                    async with asyncio.timeout(left_s):
                        await self._awake.wait()
                except TimeoutError:
                    break
                self._awake.clear()
                await self.read_wanted()

    async def read_wanted(self) -> None:
        """Read all tiles that `heights` missed."""
        while self._wanted:
            wanted, self._wanted = list(self._wanted), {}
            for key in wanted:
                self._keep(key, await self._read(key))

    async def _look_for_layers(self) -> None:
        layers = await self._tiles.terrain_layers()
        if list(map(_identity, layers)) != list(map(_identity, self._layers)):
            self._held.clear()
        self._layers = layers

    def _of_layer(self, layer: Layer, latitude_deg: Vector, longitude_deg: Vector, now_s: float) -> Vector:
        zoom = min(_FINEST, layer.description.maximum_zoom)
        size_deg = 180.0 / (1 << zoom)
        columns = np.floor((longitude_deg + 180.0) / size_deg).astype(int).clip(0, (2 << zoom) - 1)
        rows = np.floor((latitude_deg + 90.0) / size_deg).astype(int).clip(0, (1 << zoom) - 1)
        found = np.full(latitude_deg.shape, np.nan)
        for column, row in sorted(set(zip(columns.tolist(), rows.tolist(), strict=True))):
            held = self._look_up(_Key(layer.id, zoom, column, row), now_s)
            if held is not None and held.grid is not None:
                here = (columns == column) & (rows == row)
                found[here] = _between(held, held.grid, latitude_deg[here], longitude_deg[here])
        return found

    def _look_up(self, key: _Key, now_s: float) -> _GridEntry | None:
        held = self._held.get(key)
        if held is None or held.until_s < now_s:
            self._wanted[key] = None
            self._awake.set()
        else:
            self._held.move_to_end(key)
        return held

    async def _read(self, key: _Key) -> _GridEntry:
        now_s = asyncio.get_running_loop().time()
        for zoom in _levels(key.zoom):
            column, row = key.column >> (key.zoom - zoom), key.row >> (key.zoom - zoom)
            try:
                data = await self._tiles.grid(key.layer, zoom, column, row)
            except GatewayError:
                break
            if data is not None:
                return _GridEntry(np.frombuffer(data, "<f4").reshape(SIDE, SIDE), zoom, column, row, math.inf)
        return _GridEntry(None, key.zoom, key.column, key.row, now_s + _AGAIN_S)

    def _keep(self, key: _Key, held: _GridEntry) -> None:
        self._held[key] = held
        while len(self._held) > _MOST_KEPT:
            self._held.popitem(last=False)


def merged(sets: Sequence[HeightSet]) -> list[HeightSet]:
    """One of each, with its geoid farthest from zero, in the order in which they came."""
    farthest: dict[tuple[str, Datum | None], HeightSet] = {}
    for one in sets:
        before = farthest.setdefault((one.name, one.datum), one)
        if abs(one.geoid_m) > abs(before.geoid_m):
            farthest[one.name, one.datum] = one
    return list(farthest.values())


def _farthest_geoid_m(latitude_deg: Vector, longitude_deg: Vector) -> float:
    heights_m = geoid_m(latitude_deg, longitude_deg)
    return round(float(heights_m[np.argmax(np.abs(heights_m))]), 1)


def _identity(layer: Layer) -> tuple[str, int, Datum | None]:
    """Another datum makes other heights of the same set."""
    return layer.id, layer.size_bytes, layer.datum


def _levels(zoom: int) -> Iterable[int]:
    return range(zoom, max(0, zoom - _PARENTS) - 1, -1)


def _covered(layer: Layer, latitude_deg: Vector, longitude_deg: Vector) -> npt.NDArray[np.bool_]:
    bounds = layer.description.bounds
    across = (longitude_deg >= bounds.west_deg) & (longitude_deg <= bounds.east_deg)
    return across & (latitude_deg >= bounds.south_deg) & (latitude_deg <= bounds.north_deg)


def _between(held: _GridEntry, grid: npt.NDArray[np.float32], latitude_deg: Vector, longitude_deg: Vector) -> Vector:
    """Bilinear between the four points around each place; not known if one of them is not."""
    step_deg = 180.0 / (1 << held.zoom) / CELLS
    x = np.clip((longitude_deg + 180.0) / step_deg - held.column * CELLS, 0.0, CELLS)
    y = np.clip((latitude_deg + 90.0) / step_deg - held.row * CELLS, 0.0, CELLS)
    left, low = np.minimum(x.astype(int), CELLS - 1), np.minimum(y.astype(int), CELLS - 1)
    east, north = x - left, y - low
    lower = grid[low, left] * (1 - east) + grid[low, left + 1] * east
    upper = grid[low + 1, left] * (1 - east) + grid[low + 1, left + 1] * east
    found: Vector = (lower * (1 - north) + upper * north).astype(np.float64)
    return found
