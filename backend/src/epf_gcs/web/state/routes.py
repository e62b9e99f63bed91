"""What is: status, newest telemetry, and who has control."""

from __future__ import annotations

import orjson
from fastapi import APIRouter, Response

from epf_gcs.bus.definition import client_fields
from epf_gcs.web.deps import ControlDep, MirrorDep, StatusDep, VehicleDep
from epf_gcs.web.problems import problems, reading_problems
from epf_gcs.web.state.schemas import ControlInput, ControlState, Sample, Status

router = APIRouter(tags=["state"])


@router.get("/status", response_model=Status, responses=reading_problems())
async def get_status(status: StatusDep, vehicle: VehicleDep, mirror: MirrorDep) -> Response:
    """The whole state of the station."""
    # Ask the flight process, so that a caller sees its own last change. The answer is validated only in the tests.
    if vehicle.is_connected:
        mirror.learn(await vehicle.request("status"))
    return Response(status.text(), media_type="application/json")


@router.get("/telemetry", response_model=dict[str, Sample], responses=reading_problems(409))
async def get_telemetry(vehicle: VehicleDep) -> Response:
    """The newest sample of every topic, with its age."""
    return Response(orjson.dumps(await vehicle.request("telemetry")), media_type="application/json")


@router.get("/control", responses=reading_problems())
async def get_control(control: ControlDep) -> ControlState:
    """Who may command."""
    return ControlState.model_validate(client_fields(control.holder))


@router.post("/control", responses=problems(404, 409))
async def post_control(body: ControlInput, control: ControlDep) -> ControlState:
    """Take control where nobody has it, or give it back."""
    if body.action == "take":
        control.take(body.client)
    else:
        control.release(body.client)
    return await get_control(control)
