"""Conversions between the units of aviation and the metre. Said once: no other module writes these factors."""

from __future__ import annotations

from typing import Final

M_PER_FT: Final = 0.3048
"""Metres of an international foot; exact."""
M_PER_NM: Final = 1852.0
"""Metres of a nautical mile; exact."""
MPS_PER_KT: Final = M_PER_NM / 3600.0
"""Metres a second of a knot."""
FT_MIN_PER_FT_S: Final = 60.0
"""Feet a minute of a foot a second; exact."""


def ft_from_m(metres: float) -> float:
    """Feet."""
    return metres / M_PER_FT


def m_from_ft(feet: float) -> float:
    """Metres."""
    return feet * M_PER_FT


def kt_from_mps(metres_per_second: float) -> float:
    """Knots."""
    return metres_per_second / MPS_PER_KT


def mps_from_kt(knots: float) -> float:
    """Metres a second."""
    return knots * MPS_PER_KT
