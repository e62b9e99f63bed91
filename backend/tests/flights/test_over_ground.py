"""Metres over the ground between places of a flight."""

from __future__ import annotations

import numpy as np
import pytest

from epf_gcs.earth import M_PER_DEG
from epf_gcs.flights.over_ground import offsets_m, steps_m


def test_a_degree_is_shorter_to_the_east_the_farther_from_the_equator() -> None:
    latitude_deg, longitude_deg = np.array([0.0, 60.0]), np.array([10.0, 10.0])
    north_m, east_m = offsets_m(latitude_deg + 1.0, longitude_deg - 1.0, latitude_deg, longitude_deg)
    assert north_m == pytest.approx([M_PER_DEG, M_PER_DEG])
    assert east_m == pytest.approx([-M_PER_DEG, -M_PER_DEG / 2])


def test_the_date_line_is_no_step() -> None:
    found = steps_m(np.zeros(3), np.array([179.9, -179.9, 179.9]))
    assert found == pytest.approx([0.2 * M_PER_DEG] * 2)
