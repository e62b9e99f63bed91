"""The shapes of the alarms."""

from __future__ import annotations

from epf_gcs.contract.shapes import Output


class ThresholdState(Output):
    """One limit of an alarm; its unit stands in its name too."""

    name: str
    value: float
    default: float
    minimum: float
    maximum: float
    unit: str


class ThresholdList(Output):
    """All limits."""

    thresholds: list[ThresholdState]
