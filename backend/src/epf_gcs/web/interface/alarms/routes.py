"""The alarms: now, before, acknowledged, and from when on."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Body, Path

from epf_gcs.contract.answers import AlarmBook, AlarmLimits
from epf_gcs.contract.requests import AcknowledgeAlarm, ChooseThresholds, ReadAlarms, ReadThresholds
from epf_gcs.contract.status import AlarmState
from epf_gcs.vehicle.thresholds import THRESHOLDS
from epf_gcs.web.interface.alarms.schemas import ThresholdList, ThresholdState
from epf_gcs.web.interface.deps import OperatorDep, VehicleDep
from epf_gcs.web.serving.problems import problems, reading_problems

router = APIRouter(prefix="/alarms", tags=["alarms"])


@router.get("", responses=reading_problems())
async def get_alarms(vehicle: VehicleDep) -> AlarmBook:
    """What is wrong now, and what was wrong since the gateway started."""
    return await vehicle.ask(ReadAlarms())


@router.get("/thresholds", responses=reading_problems())
async def get_thresholds(vehicle: VehicleDep) -> ThresholdList:
    """From when on something is an alarm."""
    return _thresholds(await vehicle.ask(ReadThresholds()))


@router.put("/thresholds", responses=problems(404, 409))
async def put_thresholds(
    changes: Annotated[
        dict[str, float], Body(examples=[{"battery_low_v": 11.1}], min_length=1, max_length=len(THRESHOLDS))
    ],
    vehicle: VehicleDep,
    operator: OperatorDep,
) -> ThresholdList:
    """Change some limits; all of them or none. They are kept over restarts."""
    return _thresholds(await vehicle.ask(ChooseThresholds(changes), operator))


@router.post("/{alarm_id}/acknowledge", responses=problems(404, 409))
async def acknowledge_alarm(
    alarm_id: Annotated[str, Path(max_length=64, examples=["battery_low"])], vehicle: VehicleDep, operator: OperatorDep
) -> AlarmState:
    """The operator knows: the alarm is shown quietly until its cause goes."""
    return await vehicle.ask(AcknowledgeAlarm(alarm_id), operator)


def _thresholds(limits: AlarmLimits) -> ThresholdList:
    return ThresholdList(
        thresholds=[
            ThresholdState(
                name=threshold.name,
                value=limits.values[threshold.name],
                default=threshold.default,
                minimum=threshold.minimum,
                maximum=threshold.maximum,
                unit=threshold.unit,
            )
            for threshold in THRESHOLDS
        ],
        battery=limits.battery,
    )
