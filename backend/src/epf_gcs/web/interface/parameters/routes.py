"""The 17 gains: what the board holds."""

from __future__ import annotations

from typing import Annotated, Any

from fastapi import APIRouter, Body

from epf_gcs.codec.messages_gen import PARAMETERS
from epf_gcs.web.interface.commands.schemas import CommandOutcome
from epf_gcs.web.interface.deps import OperatorDep, VehicleDep
from epf_gcs.web.interface.parameters.schemas import ParameterJournal, ParameterList, ParameterState
from epf_gcs.web.serving.problems import problems, reading_problems

router = APIRouter(prefix="/parameters", tags=["parameters"])


@router.get("", responses=reading_problems(409))
async def get_parameters(vehicle: VehicleDep) -> ParameterList:
    """The gains as far as they are known; nothing is asked of the board."""
    return _parameters(await vehicle.request("parameters.read"))


@router.post("/load", responses=problems(409, 502))
async def load_parameters(vehicle: VehicleDep, operator: OperatorDep) -> ParameterList:
    """Read the gains from the board; nothing is written."""
    return _parameters(await vehicle.request("parameters.load", operator))


@router.patch("", responses=problems(404, 409, 502))
async def patch_parameters(
    changes: Annotated[dict[str, float], Body(examples=[{"k_pitch": 2.5}], min_length=1, max_length=17)],
    vehicle: VehicleDep,
    operator: OperatorDep,
) -> ParameterList:
    """Set some gains: one step of the journal. Answers after they were read back, `confirmed` or `rejected`."""
    return _parameters(await vehicle.request("parameters.set", operator, **changes))


@router.post("/undo", responses=problems(409, 502))
async def undo_parameters(vehicle: VehicleDep, operator: OperatorDep) -> ParameterList:
    """Take the newest step back; a write with read-back like any other."""
    return _parameters(await vehicle.request("parameters.undo", operator))


@router.post("/redo", responses=problems(409, 502))
async def redo_parameters(vehicle: VehicleDep, operator: OperatorDep) -> ParameterList:
    """Do again what was undone last."""
    return _parameters(await vehicle.request("parameters.redo", operator))


@router.get("/journal", responses=reading_problems(409))
async def get_journal(vehicle: VehicleDep) -> ParameterJournal:
    """Who wrote what when, newest first, over restarts; and what undo and redo would write now."""
    return ParameterJournal.model_validate(await vehicle.request("parameters.journal"))


@router.post("/store", responses=problems(409))
async def store_parameters(vehicle: VehicleDep, operator: OperatorDep) -> CommandOutcome:
    """Write the board's gains to its card."""
    return CommandOutcome.model_validate(await vehicle.request("parameters.store", operator))


def _parameters(held: dict[str, Any]) -> ParameterList:
    return ParameterList(
        parameters=[
            ParameterState(
                name=parameter.name,
                group=parameter.group,
                **held[parameter.name],
                unit="1",
                minimum=parameter.minimum,
                maximum=parameter.maximum,
                step=parameter.step,
                default=parameter.default,
                is_integer=parameter.is_integer,
                doc=parameter.doc,
            )
            for parameter in PARAMETERS
        ]
    )
