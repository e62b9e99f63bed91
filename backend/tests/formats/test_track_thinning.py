"""A flown track keeps its shape in few points, and how far it is off is never more than what is told."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.earth import distance_m
from epf_gcs.formats.mission_file import Place, Point
from epf_gcs.formats.track_thinning import thinned


def at(latitude_deg: float, longitude_deg: float, altitude_ft: float | None = 500.0) -> Point:
    return Point(Place("trkpt", 1), latitude_deg, longitude_deg, altitude_ft, None)


def test_a_straight_line_is_its_ends_and_a_corner_stays() -> None:
    there = [at(28.0 + nth / 1000, -15.0) for nth in range(50)]
    found, deviation_m = thinned(there, 100)
    assert found == [there[0], there[-1]]
    assert deviation_m == pytest.approx(0.0, abs=0.01)
    back = [at(28.049, -15.0 + nth / 1000) for nth in range(1, 50)]
    found, _ = thinned([*there, *back], 100)
    assert found == [there[0], there[-1], back[-1]]


def test_a_climb_is_a_corner_too() -> None:
    track = [at(28.0 + nth / 1000, -15.0, 500.0 if nth < 25 else 500.0 + 100 * (nth - 24)) for nth in range(50)]
    assert track[24] in thinned(track, 100)[0]


def test_a_circle_over_the_date_line_differs_by_its_sagitta() -> None:
    turns = [2 * math.pi * nth / 720 for nth in range(721)]
    ring = [at(0.01 * math.cos(turn), (180.0 + 0.01 * math.sin(turn) + 180) % 360 - 180) for turn in turns]
    found, deviation_m = thinned(ring, 17)
    assert (len(found), found[0], found[-1]) == (17, ring[0], ring[-1])
    radius_m = distance_m(0.0, 0.0, 0.01, 0.0)
    assert deviation_m == pytest.approx(radius_m * (1 - math.cos(math.pi / 16)), rel=0.02)


@given(
    st.lists(st.tuples(st.floats(-0.05, 0.05), st.floats(-0.05, 0.05), st.floats(0, 5000)), min_size=1, max_size=60),
    st.integers(2, 20),
)
def test_never_more_than_asked_in_order_and_with_both_ends(places: list[tuple[float, float, float]], most: int) -> None:
    track = [at(28 + north, -15 + east, up) for north, east, up in places]
    found, deviation_m = thinned(track, most)
    assert len(found) <= max(2, most)
    assert (found[0], found[-1]) == (track[0], track[-1])
    remaining = iter(track)
    assert all(any(one is other for other in remaining) for one in found)
    assert deviation_m >= 0
    assert len(found) == most or deviation_m <= 5.0 or len(track) < 3
