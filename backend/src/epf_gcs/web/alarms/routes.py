"""The alarms: now, before, acknowledged, and from when on."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Body, Path

from epf_gcs.flight.station import Station
from epf_gcs.vehicle.thresholds import THRESHOLDS
from epf_gcs.web.alarms.schemas import AlarmBook, PastAlarm, ThresholdList, ThresholdState
from epf_gcs.web.deps import OperatorDep, StationDep
from epf_gcs.web.problems import problems, reading_problems
from epf_gcs.web.schemas import AlarmState

router = APIRouter(prefix="/alarms", tags=["alarms"])


@router.get("", responses=reading_problems())
async def get_alarms(station: StationDep) -> AlarmBook:
    """What is wrong now, and what was wrong since the gateway started."""
    return AlarmBook(
        active=[AlarmState.model_validate(alarm.as_dict()) for alarm in station.alarms.active],
        past=[PastAlarm.model_validate({**alarm.as_dict(), "until_s": alarm.until_s}) for alarm in station.alarms.past],
    )


@router.get("/thresholds", responses=reading_problems())
async def get_thresholds(station: StationDep) -> ThresholdList:
    """From when on something is an alarm."""
    return _thresholds(station)


@router.put("/thresholds", responses=problems(404, 409))
async def put_thresholds(
    changes: Annotated[
        dict[str, float], Body(examples=[{"battery_low_v": 11.1}], min_length=1, max_length=len(THRESHOLDS))
    ],
    station: StationDep,
    _: OperatorDep,
) -> ThresholdList:
    """Change some limits; all of them or none. They are kept over restarts."""
    station.alarms.choose(changes)
    return _thresholds(station)


@router.post("/{alarm_id}/acknowledge", responses=problems(404, 409))
async def acknowledge_alarm(
    alarm_id: Annotated[str, Path(max_length=64, examples=["battery_low"])], station: StationDep, _: OperatorDep
) -> AlarmState:
    """The operator knows: the alarm is shown quietly until its cause goes."""
    return AlarmState.model_validate(station.alarms.acknowledge(alarm_id).as_dict())


def _thresholds(station: Station) -> ThresholdList:
    return ThresholdList(
        thresholds=[
            ThresholdState(
                name=threshold.name,
                value=station.alarms.thresholds[threshold.name],
                default=threshold.default,
                minimum=threshold.minimum,
                maximum=threshold.maximum,
                unit=threshold.unit,
            )
            for threshold in THRESHOLDS
        ]
    )
