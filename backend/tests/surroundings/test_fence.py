"""How far places are from the border of a fence."""

from __future__ import annotations

import numpy as np
import pytest

from epf_gcs.earth import M_PER_DEG
from epf_gcs.surroundings.fence import inside_m

# An L: the north-east quarter is outside.
ELL = ((0.0, 0.0), (0.0, 0.02), (0.01, 0.02), (0.01, 0.01), (0.02, 0.01), (0.02, 0.0))


def of(north: float, east: float, corners: tuple[tuple[float, float], ...] = ELL) -> float:
    return float(inside_m(corners, np.array([north]), np.array([east]))[0])


def test_inside_is_positive_and_outside_negative_also_in_a_dent() -> None:
    assert of(0.005, 0.005) == pytest.approx(0.005 * M_PER_DEG, rel=0.01)
    assert of(0.015, 0.015) == pytest.approx(-0.005 * M_PER_DEG, rel=0.01)
    assert of(0.005, 0.021) == pytest.approx(-0.001 * M_PER_DEG, rel=0.01)


def test_the_direction_of_the_corners_does_not_matter() -> None:
    assert of(0.005, 0.012, ELL[::-1]) == pytest.approx(of(0.005, 0.012))


def test_a_fence_over_the_date_line_holds() -> None:
    corners = ((-0.01, 179.99), (-0.01, -179.99), (0.01, -179.99), (0.01, 179.99))
    assert of(0.0, -179.995, corners) == pytest.approx(0.005 * M_PER_DEG, rel=0.01)
    assert of(0.0, 179.98, corners) == pytest.approx(-0.01 * M_PER_DEG, rel=0.01)
