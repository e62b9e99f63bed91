"""The limits beyond which an alarm is raised, as far as the operator may choose them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final

from epf_gcs.vehicle.limits import limit_fault


@dataclass(frozen=True, slots=True)
class Threshold:
    """One limit; `unit` is the unit of its value, which is in the name too; empty for a count."""

    name: str
    default: float
    minimum: float
    maximum: float
    unit: str


THRESHOLDS: Final = (
    # 0: by the cells.
    Threshold("battery_low_v", 0.0, 0.0, 60.0, "V"),
    # 0: as many as the voltage tells.
    Threshold("battery_cells", 0.0, 0.0, 24.0, ""),
    Threshold("battery_cell_low_v", 3.5, 2.0, 4.3, "V"),
    # Of these five, 0 is no limit.
    Threshold("altitude_high_ft", 0.0, 0.0, 60000.0, "ft"),
    Threshold("airspeed_low_kt", 0.0, 0.0, 500.0, "kt"),
    Threshold("airspeed_high_kt", 0.0, 0.0, 500.0, "kt"),
    Threshold("distance_far_m", 0.0, 0.0, 100000.0, "m"),
    Threshold("satellites_few", 0.0, 0.0, 30.0, ""),
    Threshold("cpu_high_percent", 90.0, 1.0, 100.0, "%"),
    Threshold("frames_damaged_percent", 1.0, 0.1, 100.0, "%"),
    Threshold("heartbeat_lost_s", 1.0, 0.5, 30.0, "s"),
    Threshold("hil_lost_s", 0.5, 0.2, 10.0, "s"),
)
# Until version 1.1 the default, for a pack of three cells; it was written with every other choice.
_EARLIER_BATTERY_LOW_V: Final = 10.5
BY_NAME: Final[Mapping[str, Threshold]] = {threshold.name: threshold for threshold in THRESHOLDS}


def threshold_fault(threshold: Threshold, value: float) -> str | None:
    """Why this value is not allowed, in one sentence; None if it is allowed."""
    return limit_fault(threshold.name, value, threshold.minimum, threshold.maximum)


def chosen(kept: Mapping[str, Any]) -> dict[str, float]:
    """All limits: the chosen value if it is still allowed, else the default."""
    if "battery_cells" not in kept and kept.get("battery_low_v") == _EARLIER_BATTERY_LOW_V:
        kept = {name: value for name, value in kept.items() if name != "battery_low_v"}
    return {
        name: float(value)
        if isinstance(value := kept.get(name), int | float)
        and not isinstance(value, bool)
        and threshold_fault(threshold, value) is None
        else threshold.default
        for name, threshold in BY_NAME.items()
    }
