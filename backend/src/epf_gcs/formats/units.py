"""Conversions between the files' units and ours. The only place in the backend that converts units of files."""

from __future__ import annotations

from typing import Final

_M_PER_FT: Final = 0.3048
_M_S_PER_KT: Final = 1852.0 / 3600.0


def ft_from_m(metres: float) -> float:
    """Feet."""
    return metres / _M_PER_FT


def m_from_ft(feet: float) -> float:
    """Metres."""
    return feet * _M_PER_FT


def kt_from_m_s(metres_per_second: float) -> float:
    """Knots."""
    return metres_per_second / _M_S_PER_KT


def m_s_from_kt(knots: float) -> float:
    """Metres a second."""
    return knots * _M_S_PER_KT
