"""The limits beyond which an alarm is raised, as far as the operator may choose them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final

from epf_gcs.vehicle.limits import limit_fault


@dataclass(frozen=True, slots=True)
class Threshold:
    """One limit; `unit` is the unit of its value, which is in the name too."""

    name: str
    default: float
    minimum: float
    maximum: float
    unit: str


THRESHOLDS: Final = (
    Threshold("battery_low_v", 10.5, 0.0, 60.0, "V"),
    Threshold("cpu_high_percent", 90.0, 1.0, 100.0, "%"),
    Threshold("frames_damaged_percent", 1.0, 0.1, 100.0, "%"),
    Threshold("heartbeat_lost_s", 1.0, 0.5, 30.0, "s"),
    Threshold("hil_lost_s", 0.5, 0.2, 10.0, "s"),
)
BY_NAME: Final[Mapping[str, Threshold]] = {threshold.name: threshold for threshold in THRESHOLDS}


def threshold_fault(threshold: Threshold, value: float) -> str | None:
    """Why this value is not allowed, in one sentence; None if it is allowed."""
    return limit_fault(threshold.name, value, threshold.minimum, threshold.maximum)


def chosen(kept: Mapping[str, Any]) -> dict[str, float]:
    """All limits: the chosen value if it is still allowed, else the default."""
    return {
        name: float(value)
        if isinstance(value := kept.get(name), int | float)
        and not isinstance(value, bool)
        and threshold_fault(threshold, value) is None
        else threshold.default
        for name, threshold in BY_NAME.items()
    }
