"""Requests that only read, and the alarms."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Mapping

from epf_gcs.bus.definition import Asker
from epf_gcs.bus.vehicle_end import Handlers
from epf_gcs.contract.answers import AlarmBook, AlarmLimits, BatteryPack, Sample
from epf_gcs.contract.inspector import Inspector
from epf_gcs.contract.requests import (
    AcknowledgeAlarm,
    ChooseThresholds,
    ReadAlarms,
    ReadInspector,
    ReadStatus,
    ReadTelemetry,
    ReadThresholds,
)
from epf_gcs.contract.status import AlarmState, Status
from epf_gcs.flight.state.inspection import build_inspector, take_snapshot
from epf_gcs.flight.state.sources import StateSources
from epf_gcs.vehicle.alarms import Alarms


def state_requests(
    status: Callable[[], Status], newest: Callable[[], dict[str, Sample]], sources: StateSources
) -> Handlers:
    """Status, the newest samples, and every message measured."""

    async def read_status(_: ReadStatus, __: Asker) -> Status:
        return status()

    async def read_telemetry(_: ReadTelemetry, __: Asker) -> dict[str, Sample]:
        return newest()

    async def inspect(_: ReadInspector, __: Asker) -> Inspector:
        # Copy here, calculate in a thread, so that the HIL loop does not wait.
        snapshot = take_snapshot(sources)
        return await asyncio.to_thread(build_inspector, snapshot)

    return {ReadStatus: read_status, ReadTelemetry: read_telemetry, ReadInspector: inspect}


def alarm_requests(
    alarms: Alarms,
    battery: Callable[[Mapping[str, float]], BatteryPack | None],
    on_limits: Callable[[Mapping[str, float]], None],
) -> Handlers:
    """The alarms and their thresholds; `battery` tells what its alarm goes by with these, `on_limits` hears of new
    ones."""

    def limits() -> AlarmLimits:
        return AlarmLimits(dict(alarms.thresholds), battery(alarms.thresholds))

    async def read(_: ReadAlarms, __: Asker) -> AlarmBook:
        return AlarmBook([alarm.state for alarm in alarms.active], [alarm.past_state for alarm in alarms.past])

    async def read_thresholds(_: ReadThresholds, __: Asker) -> AlarmLimits:
        return limits()

    async def choose(request: ChooseThresholds, _: Asker) -> AlarmLimits:
        alarms.choose(dict(request.values))
        on_limits(alarms.thresholds)
        return limits()

    async def acknowledge(request: AcknowledgeAlarm, _: Asker) -> AlarmState:
        return alarms.acknowledge(request.id).state

    return {
        ReadAlarms: read,
        ReadThresholds: read_thresholds,
        ChooseThresholds: choose,
        AcknowledgeAlarm: acknowledge,
    }
