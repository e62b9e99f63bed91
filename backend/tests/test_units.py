"""Feet, knots, miles and the earth: the factors are in two modules, and nobody else writes them."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest

from epf_gcs.earth import M_PER_DEG, RADIUS_M
from epf_gcs.units import MPS_PER_KT, ft_from_m, kt_from_mps, m_from_ft, mps_from_kt

SOURCES = Path(__file__).parents[1] / "src" / "epf_gcs"
FACTORS = re.compile(r"\b(0\.3048|3\.28\d*|1852|0\.5144\d*|1\.943\d*|111_?[0-9]{3}(\.\d+)?|6_?371_?\d{3})\b")


def test_feet_and_knots_go_there_and_back() -> None:
    assert ft_from_m(0.3048) == pytest.approx(1.0)
    assert m_from_ft(ft_from_m(123.4)) == pytest.approx(123.4)
    assert mps_from_kt(1.0) == MPS_PER_KT == pytest.approx(0.514444, rel=1e-6)
    assert kt_from_mps(mps_from_kt(60.0)) == pytest.approx(60.0)


def test_a_degree_is_of_the_same_sphere_as_the_radius() -> None:
    assert pytest.approx(math.radians(1.0) * RADIUS_M, rel=1e-6) == M_PER_DEG


def test_no_other_module_writes_a_factor() -> None:
    files = [file for file in SOURCES.rglob("*.py") if not file.name.endswith("_gen.py")]
    having = {str(file.relative_to(SOURCES)) for file in files if FACTORS.search(file.read_text())}
    assert having == {"earth.py", "units.py"}
