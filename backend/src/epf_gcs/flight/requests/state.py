"""Requests that only read, and the alarms."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Any

from epf_gcs.bus.definition import Asker
from epf_gcs.flight.requests.client_names import Table
from epf_gcs.flight.state.inspection import InspectorSources, build_inspector, take_snapshot
from epf_gcs.vehicle.alarms import Alarms


def state_requests(
    status: Callable[[], dict[str, Any]], newest: Callable[[], dict[str, Any]], sources: InspectorSources
) -> Table:
    """status; telemetry: the newest sample of each topic with its age; inspector: every message, measured."""

    async def read_status(_: Asker, __: dict[str, Any]) -> dict[str, Any]:
        return status()

    async def read_telemetry(_: Asker, __: dict[str, Any]) -> dict[str, Any]:
        return newest()

    async def inspect(_: Asker, __: dict[str, Any]) -> dict[str, Any]:
        # Copy here, calculate in a thread, so that the HIL loop does not wait.
        snapshot = take_snapshot(sources)
        return await asyncio.to_thread(build_inspector, snapshot)

    return {"status": read_status, "telemetry": read_telemetry, "inspector": inspect}


def alarm_requests(alarms: Alarms) -> Table:
    """alarms.read; alarms.thresholds; alarms.choose {name: value}; alarms.acknowledge {id}."""

    async def read(_: Asker, __: dict[str, Any]) -> dict[str, Any]:
        return {
            "active": [alarm.as_dict() for alarm in alarms.active],
            "past": [alarm.as_dict() for alarm in alarms.past],
        }

    async def thresholds(_: Asker, __: dict[str, Any]) -> dict[str, float]:
        return dict(alarms.thresholds)

    async def choose(_: Asker, arguments: dict[str, Any]) -> dict[str, float]:
        alarms.choose(arguments)
        return dict(alarms.thresholds)

    async def acknowledge(_: Asker, arguments: dict[str, Any]) -> dict[str, Any]:
        return alarms.acknowledge(str(arguments["id"])).as_dict()

    return {
        "alarms.read": read,
        "alarms.thresholds": thresholds,
        "alarms.choose": choose,
        "alarms.acknowledge": acknowledge,
    }
