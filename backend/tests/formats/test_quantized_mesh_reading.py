"""Heights on a grid from terrain tiles: our own, those of other programs, and rubbish."""

from __future__ import annotations

import contextlib
import gzip
import random
import struct

import numpy as np
import pytest

from epf_gcs.formats.quantized_mesh import CELLS, encode_tile
from epf_gcs.formats.quantized_mesh_reading import SIDE, read_grid

PLACE = (10, 936, 671)


def grid_of(data: bytes) -> np.ndarray:
    return np.frombuffer(read_grid(data), "<f4").reshape(SIDE, SIDE)


def slope() -> np.ndarray:
    """Rises to the north by 10 m a cell and to the east by 1 m a cell."""
    return np.arange(SIDE)[:, None] * 10.0 + np.arange(SIDE)[None, :] * 1.0


@pytest.mark.parametrize("packed", [False, True])
def test_what_was_written_is_read_to_the_formats_rounding(packed: bool) -> None:
    data = encode_tile(*PLACE, slope())
    found = grid_of(gzip.compress(data) if packed else data)
    assert np.abs(found - slope()).max() < 0.02


def test_what_the_source_does_not_know_is_not_known() -> None:
    known = np.ones((SIDE, SIDE), dtype=bool)
    known[3, 5] = False
    found = grid_of(encode_tile(*PLACE, slope(), known))
    assert np.isnan(found[3, 5])
    assert int(np.isnan(found).sum()) == 1


def a_mesh(vertices: list[tuple[int, int, int]], triangles: list[int], lowest_m: float, highest_m: float) -> bytes:
    """A tile as another program may write it."""

    def zigzag(values: list[int]) -> bytes:
        steps = [value - before for before, value in zip([0, *values], values, strict=False)]
        return b"".join(struct.pack("<H", (step << 1) ^ (step >> 31)) for step in steps)

    highest, codes = 0, []
    for index in triangles:
        codes.append(highest - index)
        highest += index == highest
    header = struct.pack("<3d2f3dd3d", 0, 0, 0, lowest_m, highest_m, 0, 0, 0, 1, 0, 0, 0)
    columns = b"".join(zigzag([vertex[which] for vertex in vertices]) for which in range(3))
    edges = struct.pack("<I", 0) * 4
    return (
        header
        + struct.pack("<I", len(vertices))
        + columns
        + struct.pack("<I", len(triangles) // 3)
        + b"".join(struct.pack("<H", code) for code in codes)
        + edges
    )


def test_a_mesh_of_few_triangles_is_interpolated() -> None:
    square = [(0, 0, 0), (32767, 0, 0), (32767, 32767, 32767), (0, 32767, 32767)]
    found = grid_of(a_mesh(square, [0, 1, 2, 0, 2, 3], 100.0, 740.0))
    assert np.abs(found - (100.0 + np.arange(SIDE)[:, None] * 640.0 / CELLS)).max() < 0.05


def test_where_a_mesh_has_no_triangle_nothing_is_known() -> None:
    corner = [(0, 0, 0), (32767, 0, 0), (0, 32767, 0)]
    found = grid_of(a_mesh(corner, [0, 1, 2], 5.0, 5.0))
    assert found[0, 0] == 5.0
    assert np.isnan(found[CELLS, CELLS])


def test_rubbish_is_refused_and_never_read_beyond_its_end() -> None:
    data = encode_tile(*PLACE, slope())
    for end in range(0, len(data) - 1, 997):
        with pytest.raises(ValueError, match="tile of terrain"):
            read_grid(data[:end])
    chance = random.Random(1)
    for _ in range(200):
        damaged = bytearray(data)
        for _ in range(20):
            damaged[chance.randrange(88, len(damaged))] = chance.randrange(256)
        with contextlib.suppress(ValueError):
            assert len(read_grid(bytes(damaged))) == SIDE * SIDE * 4


def test_too_many_triangles_and_a_bomb_are_refused() -> None:
    data = bytearray(encode_tile(*PLACE, slope()))
    struct.pack_into("<I", data, 88 + 4 + 6 * SIDE * SIDE, 3_000_000)
    with pytest.raises(ValueError, match="triangles"):
        read_grid(bytes(data))
    with pytest.raises(ValueError, match="too large"):
        read_grid(gzip.compress(bytes(20_000_000)))
