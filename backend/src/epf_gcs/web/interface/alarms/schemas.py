"""The shapes of the alarms."""

from __future__ import annotations

from epf_gcs.contract.answers import BatteryPack
from epf_gcs.contract.shapes import Output


class ThresholdState(Output):
    """One limit of an alarm; its unit stands in its name too, and is empty for a count."""

    name: str
    value: float
    default: float
    minimum: float
    maximum: float
    unit: str


class ThresholdList(Output):
    """All limits, and what the battery's alarm goes by; null while no voltage was measured."""

    thresholds: list[ThresholdState]
    battery: BatteryPack | None
