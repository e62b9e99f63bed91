"""Rasters of heights: asked for by place, whatever their projection, their pixels and their gaps."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from rasterio.warp import transform

from epf_gcs.errors import GatewayError
from epf_gcs.maps.heights import Heights
from tests.support.maps import write_hgt, write_raster

FINE_DEG = 1e-5


def plane(x: Any, y: Any) -> Any:
    """Metres: 2000 a degree to the east, 1000 a degree to the north of 27.6, and 50."""
    return 50 + 2000 * (x + 15.5) + 1000 * (y - 27.6)


def asked(heights: Heights, longitude_deg: float, latitude_deg: float, step_deg: float = FINE_DEG) -> float:
    return float(heights.at(np.array([longitude_deg]), np.array([latitude_deg]), step_deg)[0, 0])


@pytest.fixture
def flat(tmp_path: Path) -> Heights:
    return Heights(write_raster(tmp_path / "a.tif", plane), "a.tif")


def test_between_the_pixels_heights_are_between_theirs(flat: Heights) -> None:
    for longitude_deg, latitude_deg in ((-15.4, 27.9), (-15.2513, 27.7137), (-15.4004, 27.9008)):
        assert asked(flat, longitude_deg, latitude_deg) == pytest.approx(plane(longitude_deg, latitude_deg), abs=0.01)
    assert tuple(flat.bounds) == pytest.approx((-15.5, 27.6, -15.1, 28.0))
    assert flat.pixel_deg == pytest.approx(0.002)


def test_rows_go_to_the_north_and_columns_to_the_east(flat: Heights) -> None:
    found = flat.at(np.array([-15.4, -15.3]), np.array([27.7, 27.8, 27.9]), FINE_DEG)
    assert found.shape == (3, 2)
    assert found[2, 0] - found[0, 0] == pytest.approx(200, abs=0.1)
    assert found[0, 1] - found[0, 0] == pytest.approx(200, abs=0.1)


def test_outside_is_the_sea(flat: Heights) -> None:
    assert asked(flat, -15.5001, 27.8) == 0.0
    assert asked(flat, -15.3, 28.001) == 0.0
    assert asked(flat, 100.0, -80.0) == 0.0
    assert asked(flat, -15.4999, 27.8) == pytest.approx(plane(-15.499, 27.8), abs=0.1), "the outermost pixel counts"


def test_no_data_is_the_sea_and_takes_no_part_in_a_mean(tmp_path: Path) -> None:
    path = write_raster(tmp_path / "a.tif", lambda x, _: np.where(x < -15.3, -9999, 100.0), nodata=-9999)
    heights = Heights(path, "a.tif")
    assert (asked(heights, -15.4, 27.8), asked(heights, -15.2, 27.8)) == (0.0, 100.0)
    assert asked(heights, -15.2, 27.8, 0.05) == pytest.approx(100.0)
    with_nan = write_raster(tmp_path / "b.tif", lambda x, _: np.where(x < -15.3, np.nan, 100.0))
    assert asked(Heights(with_nan, "b.tif"), -15.4, 27.8) == 0.0


def test_from_far_away_the_mean_counts(tmp_path: Path) -> None:
    """Every second pixel a peak: taken as single points, a coarse level would be all peaks or none."""
    path = write_raster(tmp_path / "a.tif", lambda x, _: 200.0 * (np.round((x + 15.501) / 0.002) % 2))
    heights = Heights(path, "a.tif")
    found = heights.at(np.linspace(-15.4, -15.2, 9), np.linspace(27.7, 27.9, 9), 0.02)
    assert found == pytest.approx(np.full((9, 9), 100.0), abs=1.0)


def test_utm_is_asked_by_longitude_and_latitude(tmp_path: Path) -> None:
    path = write_raster(
        tmp_path / "utm.tif",
        lambda x, y: (x - 440_000) / 10 + (y - 3_080_000) / 20,
        west=440_000,
        north=3_100_000,
        step=100,
        crs="EPSG:32628",
    )
    heights = Heights(path, "utm.tif")
    for easting, northing in ((450_000, 3_090_000), (445_050, 3_085_050), (459_000, 3_099_000)):
        longitude, latitude = transform("EPSG:32628", "EPSG:4326", [easting], [northing])
        expected = (easting - 440_000) / 10 + (northing - 3_080_000) / 20
        assert asked(heights, longitude[0], latitude[0]) == pytest.approx(expected, abs=0.1)
    assert heights.bounds.west_deg == pytest.approx(-15.61, abs=0.02)


def test_a_shuttle_tile_says_by_its_name_where_it_is(tmp_path: Path) -> None:
    heights = Heights(write_hgt(tmp_path / "N27W016.hgt", plane), "N27W016.hgt")
    assert asked(heights, -15.4, 27.9) == pytest.approx(plane(-15.4, 27.9), abs=1.0)
    assert tuple(heights.bounds) == pytest.approx((-16, 27, -15, 28), abs=0.001)


@pytest.mark.parametrize("name", ["gran canaria.hgt", "N2W016.hgt"])
def test_a_shuttle_tile_without_its_name_is_told_what_it_lacks(tmp_path: Path, name: str) -> None:
    path = write_hgt(tmp_path / "N27W016.hgt", plane).rename(tmp_path / name)
    with pytest.raises(GatewayError) as caught:
        Heights(path, name)
    assert caught.value.code == "map_raster_no_place"
    assert "N28W016.hgt" in caught.value.detail


def test_a_shuttle_tile_that_was_cut_off_says_why_without_its_path(tmp_path: Path) -> None:
    path = write_hgt(tmp_path / "N27W016.hgt", plane)
    path.write_bytes(path.read_bytes()[:5000])
    with pytest.raises(GatewayError) as caught:
        Heights(path, path.name)
    assert caught.value.params["why"] == "not recognized as being in a supported file format"


@pytest.mark.parametrize(("unit", "factor"), [("metre", 1.0), ("", 1.0), ("ft", 0.3048), ("US survey foot", 0.3048006)])
def test_feet_become_metres(tmp_path: Path, unit: str, factor: float) -> None:
    path = write_raster(tmp_path / "a.tif", plane)
    import rasterio

    with rasterio.open(path, "r+") as file:
        file.units = (unit,)
    assert asked(Heights(path, "a.tif"), -15.4, 27.9) == pytest.approx(plane(-15.4, 27.9) * factor, abs=0.02)


@pytest.mark.parametrize(
    ("more", "code"),
    [
        ({"crs": None}, "map_raster_no_place"),
        ({"count": 3, "dtype": "uint8"}, "map_raster_not_height"),
        ({"dtype": "complex64"}, "map_raster_not_height"),
        ({"west": 400.0}, "map_raster_no_place"),
    ],
)
@pytest.mark.filterwarnings("ignore::rasterio.errors.NotGeoreferencedWarning")
def test_what_are_no_heights_with_a_place_is_refused_in_words(tmp_path: Path, more: dict[str, Any], code: str) -> None:
    path = write_raster(tmp_path / "a.tif", plane, **more)
    with pytest.raises(GatewayError) as caught:
        Heights(path, "a.tif")
    assert caught.value.code == code
    assert "'a.tif'" in caught.value.detail


@pytest.mark.parametrize("content", [b"", b"II*\x00", b"<VRTDataset/>", b"http://127.0.0.1:1/x.tif"])
def test_what_is_no_raster_is_refused_and_follows_no_reference(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "a.tif"
    path.write_bytes(content)
    with pytest.raises(GatewayError) as caught:
        Heights(path, "a.tif")
    assert caught.value.code == "map_file_damaged"
    assert str(tmp_path) not in caught.value.detail
