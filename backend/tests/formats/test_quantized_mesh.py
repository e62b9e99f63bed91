"""Terrain tiles: heights as they were given, triangles that face up, and no crack to the neighbour."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.formats.quantized_mesh import CELLS, earth_points, encode_tile, tile_bounds, tile_nodes
from tests.support.maps import Mesh, decode_mesh

GANDO = (12, 1875, 1342)
SIDE = CELLS + 1


def heights(tile: tuple[int, int, int]) -> Any:
    """Hills that depend on the place alone."""
    longitudes, latitudes = tile_nodes(*tile)
    x, y = np.meshgrid(longitudes, latitudes)
    return 500 + 400 * np.sin(x * 40) * np.cos(y * 55)


def decoded(tile: tuple[int, int, int]) -> Mesh:
    return decode_mesh(encode_tile(*tile, heights(tile)))


def points_m(tile: tuple[int, int, int], mesh: Mesh) -> Any:
    bounds = tile_bounds(*tile)
    longitude = bounds.west_deg + mesh.u * (bounds.east_deg - bounds.west_deg)
    latitude = bounds.south_deg + mesh.v * (bounds.north_deg - bounds.south_deg)
    return earth_points(longitude, latitude, mesh.height_m)


def test_every_height_is_where_it_was_to_the_format_s_own_step() -> None:
    mesh, given_m = decoded(GANDO), heights(GANDO)
    column = np.round(mesh.u * CELLS).astype(int)
    row = np.round(mesh.v * CELLS).astype(int)
    assert sorted(zip(row.tolist(), column.tolist(), strict=True)) == [(r, c) for r in range(SIDE) for c in range(SIDE)]
    step_m = (mesh.highest_m - mesh.lowest_m) / 32767
    assert np.abs(mesh.height_m - given_m[row, column]).max() < step_m
    assert (mesh.lowest_m, mesh.highest_m) == pytest.approx((given_m.min(), given_m.max()), abs=1e-3)
    assert np.abs(mesh.u * CELLS - column).max() < 0.01


@pytest.mark.parametrize("tile", [GANDO, (0, 0, 0), (0, 1, 0), (3, 7, 0), (5, 60, 31)])
def test_every_triangle_faces_up_and_they_cover_the_tile(tile: tuple[int, int, int]) -> None:
    mesh = decoded(tile)
    a, b, c = (np.stack([mesh.u, mesh.v], axis=1)[mesh.triangles[:, corner]] for corner in range(3))
    areas = ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2
    assert areas.min() > 0, "anticlockwise seen from above"
    assert areas.sum() == pytest.approx(1.0)
    assert len(mesh.triangles) == 2 * CELLS * CELLS


@pytest.mark.parametrize(("edge", "across", "axis"), [(2, (0, 1, 0), "v"), (3, (0, 0, 1), "u")])
def test_neighbours_agree_on_the_edge_they_share(edge: int, across: tuple[int, int, int], axis: str) -> None:
    other = (GANDO[0], GANDO[1] + across[1], GANDO[2] + across[2])
    here, there = decoded(GANDO), decoded(other)
    ours, theirs = here.edges[edge], there.edges[edge - 2]
    assert getattr(here, axis)[ours].tolist() == getattr(there, axis)[theirs].tolist()
    step_m = max(mesh.highest_m - mesh.lowest_m for mesh in (here, there)) / 32767
    assert np.abs(here.height_m[ours] - there.height_m[theirs]).max() <= step_m
    assert points_m(GANDO, here)[ours] == pytest.approx(points_m(other, there)[theirs], abs=2 * step_m + 0.5)


def test_the_edges_are_named_by_where_they_are() -> None:
    mesh = decoded(GANDO)
    west, south, east, north = mesh.edges
    assert set(mesh.u[west]) == {0.0}
    assert set(mesh.v[south]) == {0.0}
    assert set(mesh.u[east]) == {1.0}
    assert set(mesh.v[north]) == {1.0}
    assert [len(edge) for edge in mesh.edges] == [SIDE] * 4


def tiles_of(zoom: int) -> st.SearchStrategy[tuple[int, int, int]]:
    return st.tuples(st.just(zoom), st.integers(0, 2 ** (zoom + 1) - 1), st.integers(0, 2**zoom - 1))


def is_seen(point: Any, eye: Any) -> Any:
    """Over the horizon of the eye, or beside the Earth's shadow; all where the Earth is a sphere of radius 1."""
    beyond, towards = eye @ eye - 1.0, point - eye
    depth = -(towards @ eye)
    return ~((depth > beyond) & (depth * depth > beyond * (towards * towards).sum(axis=-1)))


@pytest.mark.uncounted
@given(st.integers(0, 14).flatmap(tiles_of))
def test_the_sphere_holds_the_tile_and_the_hiding_point_hides_no_part_that_is_seen(tile: tuple[int, int, int]) -> None:
    mesh = decoded(tile)
    points = points_m(tile, mesh)
    assert np.linalg.norm(points - np.array(mesh.centre_m), axis=1).max() <= mesh.radius_m * (1 + 1e-4) + 1.0
    hiding = np.array(mesh.hiding)
    scaled = points / np.array([6378137.0, 6378137.0, 6356752.314245179])
    rng = np.random.default_rng(1)
    eyes = rng.normal(size=(100, 3))
    eyes *= (rng.uniform(1.001, 6.0, size=100) / np.linalg.norm(eyes, axis=1))[:, None]
    for eye in eyes:
        assert is_seen(hiding, eye) or not is_seen(scaled, eye).any()


def test_a_small_tile_behind_the_earth_is_hidden() -> None:
    """What is never hidden would be drawn for nothing."""
    mesh = decoded(GANDO)
    opposite = -3.0 * np.array(mesh.centre_m) / np.linalg.norm(mesh.centre_m)
    assert not is_seen(np.array(mesh.hiding), opposite)


def test_flat_sea_is_a_tile_too() -> None:
    mesh = decode_mesh(encode_tile(*GANDO, np.zeros((SIDE, SIDE))))
    assert (mesh.lowest_m, mesh.highest_m) == (0.0, 0.0)
    assert set(mesh.height_m.tolist()) == {0.0}
