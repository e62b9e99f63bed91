"""Whether a number lies where it may."""

from __future__ import annotations

import math


def limit_fault(name: str, value: float, minimum: float, maximum: float) -> str | None:
    """Why this value is not allowed, in a clear sentence; None where it is. Both limits are allowed values."""
    if not math.isfinite(value):
        return f"{name} must be a number."
    if not minimum <= value <= maximum:
        return f"{name} must be in {minimum:g}..{maximum:g}, not {value:g}."
    return None
