"""What is: status, newest telemetry, and who has control."""

from __future__ import annotations

from collections.abc import Callable

import orjson
from fastapi import APIRouter, Response

from epf_gcs.flight.station import Station
from epf_gcs.flight.status import build_status
from epf_gcs.web.deps import StationDep
from epf_gcs.web.problems import problems, reading_problems
from epf_gcs.web.schemas import ControlInput, ControlState, Sample, Status

router = APIRouter(tags=["state"])


def status_json(station: Station) -> bytes:
    """The status as JSON; not validated again, the tests do that."""
    return orjson.dumps(build_status(station))


def status_message(station: Station) -> Callable[[], bytes]:
    """What the stream sends."""
    return lambda: b'{"type":"status","data":%b}' % status_json(station)


@router.get("/status", response_model=Status, responses=reading_problems())
async def get_status(station: StationDep) -> Response:
    """The whole state of the station."""
    return Response(status_json(station), media_type="application/json")


@router.get("/telemetry", response_model=dict[str, Sample], responses=reading_problems())
async def get_telemetry(station: StationDep) -> Response:
    """The newest sample of every topic, with its age."""
    return Response(orjson.dumps(station.telemetry.snapshot()), media_type="application/json")


@router.get("/control", responses=reading_problems())
async def get_control(station: StationDep) -> ControlState:
    """Who may command."""
    holder = station.control.holder
    return ControlState(client=holder.id if holder else None, name=holder.name if holder else None)


@router.post("/control", responses=problems(404, 409))
async def post_control(body: ControlInput, station: StationDep) -> ControlState:
    """Take control where nobody has it, or give it back."""
    if body.action == "take":
        station.control.take(body.client)
    else:
        station.control.release(body.client)
    return await get_control(station)
