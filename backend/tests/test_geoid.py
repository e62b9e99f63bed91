"""The geoid: as published, to the date line and the poles."""

from __future__ import annotations

import numpy as np
import pytest

from epf_gcs.geoid import COLUMNS, ROWS, UNIT_M, geoid_m, grid_m, packed, unpacked_m


# The test points of NGA's programs for EGM96, and what they answer.
@pytest.mark.parametrize(
    ("latitude_deg", "longitude_deg", "published_m"),
    [
        (38.6281550, 269.7791550, -31.628),
        (-14.6212170, 305.0211140, -2.969),
        (46.8743190, 102.4487290, -43.575),
        (-23.6174460, 133.8747120, 15.871),
        (38.6254730, 359.9995000, 50.066),
        (-0.4667440, 0.0023000, 17.329),
    ],
)
def test_the_published_points(latitude_deg: float, longitude_deg: float, published_m: float) -> None:
    assert geoid_m(latitude_deg, longitude_deg) == pytest.approx(published_m, abs=0.1)
    assert geoid_m(latitude_deg, longitude_deg - 360.0) == pytest.approx(published_m, abs=0.1)


def test_points_of_the_published_grid_are_off_by_less_than_half_a_step() -> None:
    # Of NGA's file WW15MGH.GRD.
    assert geoid_m(90.0, 0.0) == pytest.approx(13.61, abs=UNIT_M / 2 + 1e-6)
    assert geoid_m(90.0, 123.0) == pytest.approx(13.61, abs=UNIT_M / 2 + 1e-6)
    assert geoid_m(-90.0, -77.0) == pytest.approx(-29.53, abs=UNIT_M / 2 + 1e-6)
    assert grid_m().shape == (ROWS, COLUMNS)
    assert grid_m().min() == pytest.approx(-106.99, abs=UNIT_M / 2 + 1e-6)
    assert grid_m().max() == pytest.approx(85.39, abs=UNIT_M / 2 + 1e-6)


def test_both_sides_of_the_date_line_agree() -> None:
    latitudes_deg = np.linspace(-90, 90, 50)
    west, east = geoid_m(latitudes_deg, np.full(50, -180.0)), geoid_m(latitudes_deg, np.full(50, 180.0))
    assert np.array_equal(west, east)
    assert geoid_m(10.0, 179.99999) == pytest.approx(float(geoid_m(10.0, -179.99999)), abs=0.01)
    assert geoid_m(10.0, -1e-20) == pytest.approx(float(geoid_m(10.0, 0.0)), abs=0.01)


def test_an_unknown_place_has_no_height() -> None:
    assert np.isnan(geoid_m(np.array([np.nan, 0.0]), np.array([0.0, 0.0]))).tolist() == [True, False]


def test_a_packed_grid_loses_less_than_half_a_step() -> None:
    heights_m = np.random.default_rng(0).uniform(-107, 86, (ROWS, COLUMNS))
    assert np.abs(unpacked_m(packed(heights_m)) - heights_m).max() <= UNIT_M / 2 + 1e-5
