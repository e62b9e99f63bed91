"""The shapes of the alarms."""

from __future__ import annotations

from typing import Literal

from epf_gcs.contract.shapes import Output, ParamValue
from epf_gcs.vehicle.alarm_ids import AlarmId
from epf_gcs.web.interface.state.schemas import AlarmState


class PastAlarm(Output):
    """Something that was wrong; Unix times."""

    id: AlarmId
    level: Literal["warning", "critical"]
    text: str
    params: dict[str, ParamValue]
    since_s: float
    until_s: float
    acknowledged: bool


class AlarmBook(Output):
    """What is wrong now, oldest first, and the 200 that went last, newest first."""

    active: list[AlarmState]
    past: list[PastAlarm]


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
