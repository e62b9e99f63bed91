"""Whether a number lies within its limits."""

from __future__ import annotations

import math


def limit_fault(name: str, value: float, minimum: float, maximum: float) -> str | None:
    """Why this value is not allowed, in one sentence; None if it is allowed. Both limits are allowed values."""
    if not math.isfinite(value):
        return f"{name} must be a number."
    if not minimum <= value <= maximum:
        return f"{name} must be in {minimum:g}..{maximum:g}, not {value:g}."
    return None
