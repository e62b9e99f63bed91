"""Terrain above the ellipsoid becomes terrain above the sea, and nothing else of its tiles changes."""

from __future__ import annotations

import gzip

import numpy as np
import pytest

from epf_gcs.formats.quantized_mesh import CELLS, encode_tile, tile_nodes
from epf_gcs.formats.quantized_mesh_datum import above_sea
from epf_gcs.formats.quantized_mesh_reading import SIDE, read_grid
from epf_gcs.geoid import geoid_m
from tests.support.maps import decode_mesh

# Around Gran Canaria, where the sea is 40 m above the ellipsoid.
ZOOM, COLUMN, ROW = 8, 234, 167


def grid_of(tile: bytes) -> np.ndarray[tuple[int, ...], np.dtype[np.float32]]:
    return np.frombuffer(read_grid(tile), "<f4").reshape(SIDE, SIDE)


@pytest.mark.parametrize("pack", [bytes, gzip.compress])
def test_the_same_ground_over_both_datums_is_the_same_within_centimetres(pack: type[bytes]) -> None:
    longitude_deg, latitude_deg = np.meshgrid(*tile_nodes(ZOOM, COLUMN, ROW))
    sea_m = 900 + 800 * np.sin(longitude_deg * 20) * np.cos(latitude_deg * 20)
    known = longitude_deg > longitude_deg.mean()
    tile = encode_tile(ZOOM, COLUMN, ROW, sea_m + geoid_m(latitude_deg, longitude_deg), known)
    found = grid_of(above_sea(pack(tile), ZOOM, COLUMN, ROW))
    assert np.abs(found[known] - sea_m[known]).max() < 0.1
    assert np.isnan(found[~known]).all()
    mesh, before = decode_mesh(above_sea(tile, ZOOM, COLUMN, ROW)), decode_mesh(tile)
    assert np.array_equal(mesh.triangles, before.triangles)
    assert mesh.edges == before.edges
    # The header's centre and radius are of the new heights.
    expected = decode_mesh(encode_tile(ZOOM, COLUMN, ROW, sea_m, known))
    assert mesh.centre_m == pytest.approx(expected.centre_m, abs=0.5)
    assert mesh.radius_m == pytest.approx(expected.radius_m, abs=0.5)
    assert (mesh.lowest_m, mesh.highest_m) == pytest.approx((expected.lowest_m, expected.highest_m), abs=0.1)


def test_a_tile_of_the_web_maps_pyramid_lies_where_that_has_it() -> None:
    # Zoom 1, the north-eastern of four tiles: 0..180 E, 0..85.05 N; its south-western corner is 0 N 0 E.
    tile = encode_tile(0, 0, 0, np.full((CELLS + 1, CELLS + 1), 100.0))
    found = grid_of(above_sea(tile, 1, 1, 1, is_mercator=True))
    assert found[0, 0] == pytest.approx(100 - float(geoid_m(0, 0)), abs=0.1)
    assert found[CELLS, 0] == pytest.approx(100 - float(geoid_m(85.0511, 0)), abs=0.1)


@pytest.mark.parametrize("data", [b"", b"\0" * 88, b"\0" * 88 + b"\xff\0\0\0", b"\x1f\x8bxx", b"\xff" * 200])
def test_what_is_no_tile_is_refused(data: bytes) -> None:
    with pytest.raises(ValueError, match="terrain"):
        above_sea(data, 0, 0, 0)
