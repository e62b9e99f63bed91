"""What is: status, newest telemetry, and who has control."""

from __future__ import annotations

import asyncio
import contextlib
from dataclasses import asdict
from typing import Final

import orjson
from fastapi import APIRouter, Response
from pydantic import TypeAdapter

from epf_gcs.contract.answers import Sample
from epf_gcs.contract.requests import ReadStatus, ReadTelemetry
from epf_gcs.contract.status import Status
from epf_gcs.errors import ConflictError, InvalidInputError, UnavailableError
from epf_gcs.web.interface.deps import AdmittedDep, ControlDep, MirrorDep, StatusDep, VehicleDep
from epf_gcs.web.interface.state.schemas import ControlDetails, ControlInput
from epf_gcs.web.serving.problems import problems, reading_problems

router = APIRouter(tags=["state"])

_OWN_CHANGE_S: Final = 0.9

_TO_ANOTHER: Final = frozenset({"grant", "refuse", "hand_over"})


@router.get("/status", response_model=Status, responses=reading_problems())
async def get_status(status: StatusDep, vehicle: VehicleDep, mirror: MirrorDep) -> Response:
    """The whole state of the station."""
    # Ask the flight process, so that a caller sees its own last change. The answer is validated only in the tests.
    # Of one that is away or hangs, what is known is told, with its age.
    if vehicle.is_connected:
        with contextlib.suppress(TimeoutError, UnavailableError, ConflictError):
            async with asyncio.timeout(_OWN_CHANGE_S):
                mirror.learn(await vehicle.ask(ReadStatus()))
    return Response(status.text(), media_type="application/json")


@router.get("/telemetry", response_model=dict[str, Sample], responses=reading_problems(409))
async def get_telemetry(vehicle: VehicleDep) -> Response:
    """The newest sample of every topic, with its age."""
    return Response(orjson.dumps(await vehicle.ask(ReadTelemetry())), media_type="application/json")


@router.get("/control", responses=reading_problems())
async def get_control(control: ControlDep) -> ControlDetails:
    """Who may command, who asks for it, and who is there."""
    return TypeAdapter(ControlDetails).validate_python({**asdict(control.state()), "pages": control.pages()})


@router.post("/control", responses=problems(404, 409))
async def post_control(body: ControlInput, control: ControlDep, caller: AdmittedDep) -> ControlDetails:
    """Take control, give it back, ask for it, answer who asks, or hand it over."""
    client = control.own(caller, body.client)
    if body.to is None and body.action in _TO_ANOTHER:
        raise InvalidInputError(
            "invalid_request", f"'{body.action}' needs 'to': the id of the page that is meant.", field="to"
        )
    control.act(body.action, client, body.to or "", confirmed=body.confirm)
    return await get_control(control)
