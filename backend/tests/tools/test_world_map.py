"""The tool that makes the map's files: nothing is lost at the borders of cells, and what is left out stays small."""

from __future__ import annotations

import gzip
import io
import json

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tools.world_map.airfields import surface_of
from tools.world_map.cells import UNITS, Cells, variable_length
from tools.world_map.coast import coast_tolerance, even_tolerance
from tools.world_map.places import Place, largest_around
from tools.world_map.shapes import Grid, Points, cut_line, cut_ring, simpler

FIVE = Grid(5)


def area(ring: Points) -> float:
    x, y = ring[:, 0], ring[:, 1]
    return abs(float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))) / 2


def star(longitude: float, latitude: float, reach: float, corners: int) -> Points:
    """A ring with bays, around a place."""
    angles = np.linspace(0, 2 * np.pi, corners, endpoint=False)
    radius = reach * np.where(np.arange(corners) % 2 == 0, 1, 0.45)
    return np.column_stack([longitude + radius * np.cos(angles), latitude + radius * np.sin(angles)])


@given(
    st.floats(-170, 170),
    st.floats(-70, 70),
    st.floats(0.01, 15),
    st.integers(3, 40).map(lambda half: 2 * half),
)
def test_a_ring_that_is_cut_covers_what_it_covered(longitude: float, latitude: float, reach: float, n: int) -> None:
    ring = star(longitude, latitude, reach, n)
    parts = list(cut_ring(ring, FIVE))
    assert sum(area(part) for _, part in parts) == pytest.approx(area(ring), rel=1e-6, abs=1e-9)
    for (column, row), part in parts:
        low, high = np.array([column * 5 - 180, row * 5 - 90]), np.array([column * 5 - 175, row * 5 - 85])
        east = np.round((part.mean(axis=0)[0] - low[0]) / 360) * 360
        assert (part - [east, 0] >= low - 1e-9).all()
        assert (part - [east, 0] <= high + 1e-9).all()


def test_a_ring_beyond_the_date_line_comes_round_to_the_west() -> None:
    cells = {cell for cell, _ in cut_ring(star(180, 2, 2, 8), FIVE)}
    assert {column for column, _ in cells} == {71, 0}


def test_a_line_that_is_cut_has_no_gap_at_the_border() -> None:
    line = np.array([[1.0, 1.0], [4.0, 1.0], [6.0, 2.0], [9.0, 6.0]])
    parts = list(cut_line(line, FIVE))
    assert [cell for cell, _ in parts] == [(36, 18), (37, 18)]
    assert parts[0][1][-1].tolist() == parts[1][1][0].tolist()


def test_points_that_are_left_out_lie_near_the_simpler_line() -> None:
    angles = np.linspace(0, 2 * np.pi, 4000)
    rough = 1 + 1e-4 * np.sin(977 * angles)
    ring = np.column_stack([rough * np.cos(angles), rough * np.sin(angles) + 40])
    (kept,) = simpler([ring], even_tolerance(100))
    assert 20 < len(kept) < 1000
    assert kept[0].tolist() == ring[0].tolist()
    # What a circle loses to its polygon is the height of its arcs: some tolerances at most, for passes add up.
    assert area(kept) == pytest.approx(area(ring), rel=0.004)


def test_home_is_finer_and_the_poles_are_coarser() -> None:
    places = np.array([[-15.4, 28.0], [10.0, 45.0], [20.0, 80.0]])
    assert coast_tolerance(140)(places).tolist() == [8, 140, 400]


def test_a_cell_holds_its_shapes_and_tables_as_the_page_reads_them() -> None:
    cells = Cells(FIVE)
    cells.add_land((36, 18), np.array([[0.0, 0.0], [5.0, 0.0], [5.0, 5.0]]))
    cells.add_thing("places", 2.5, 1.25, ["Mitad", 77])
    made = io.BytesIO(b"...")
    made.seek(3)
    assert cells.write(made) == {"36-18": (3, len(made.getvalue()) - 3)}
    data = gzip.decompress(made.getvalue()[3:])
    end = 4 + int.from_bytes(data[:4], "little")
    assert json.loads(data[4:end]) == {"places": [["Mitad"]]}
    assert np.frombuffer(data[end : end + 4], "<u2").tolist() == [32768, 16384]
    assert data[end + 4] == 77
    steps = [0, 0, UNITS, 0, 0, UNITS]
    assert data[end + 5 :] == variable_length([1, 3, *(2 * step for step in steps), 0])


def test_no_land_is_empty_of_names_and_large_towns_are_never_left_out() -> None:
    crowd = [Place(f"Large {n}", 40.1, -3.9, 1_000_000 - n, "ES") for n in range(9)]
    alone = [Place("Alone", 27.1, -12.9, 600, "EH"), Place("Smaller", 27.2, -12.8, 550, "EH")]
    chosen = largest_around([*crowd, *alone], least=30_000, of_each=1, around_deg=0.5)
    assert chosen == [*crowd, alone[0]]


@pytest.mark.parametrize(
    ("text", "surface"),
    [("ASPH-G", "asphalt"), ("PEM", "concrete"), ("GRS", "grass"), ("Turf-F", "grass"), ("GRVL", "gravel"), ("", "")],
)
def test_a_surface_is_understood_as_pilots_write_it(text: str, surface: str) -> None:
    assert surface_of(text) == surface
