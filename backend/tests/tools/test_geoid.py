"""The tool that makes the geoid's file finds the grid in the package's script."""

from __future__ import annotations

import base64

import numpy as np
import pytest

from epf_gcs.geoid import COLUMNS, ROWS
from tools.geoid import published_m


def test_the_grid_is_read_in_centimetres_from_the_north() -> None:
    centimetres = np.zeros((ROWS, COLUMNS), ">i2")
    centimetres[0, 0], centimetres[ROWS - 1, COLUMNS - 1] = 1361, -2953
    found_m = published_m(b'var data = "' + base64.b64encode(centimetres.tobytes()) + b'";')
    assert (found_m[0, 0], found_m[-1, -1]) == pytest.approx((13.61, -29.53))


def test_a_script_without_the_grid_is_refused() -> None:
    with pytest.raises(ValueError, match="no grid"):
        published_m(b"var data = [];")
