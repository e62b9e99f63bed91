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


def value_fault(name: str, value: float, minimum: float, maximum: float, *, is_integer: bool) -> str | None:
    """The same for a gain, which may have to be a whole number."""
    if is_integer and math.isfinite(value) and value != int(value):
        return f"{name} must be a whole number, not {value:g}."
    return limit_fault(name, value, minimum, maximum)
