"""The gains that the board holds: the 17, and those that it describes itself."""

from __future__ import annotations

from typing import Annotated, Final

from fastapi import APIRouter, Body

from epf_gcs.codec.messages_gen import PARAMETERS
from epf_gcs.contract.answers import CommandOutcome, ParameterJournal, ParameterState
from epf_gcs.contract.own_gains import MOST_ROWS, AllGains
from epf_gcs.contract.requests import (
    LoadParameters,
    ReadJournal,
    ReadParameters,
    RedoParameters,
    SetParameters,
    StoreParameters,
    UndoParameters,
)
from epf_gcs.web.interface.deps import OperatorDep, VehicleDep
from epf_gcs.web.interface.parameters.schemas import ParameterList
from epf_gcs.web.serving.problems import problems, reading_problems

router = APIRouter(prefix="/parameters", tags=["parameters"])

_MOST_CHANGES: Final = len(PARAMETERS) + MOST_ROWS


@router.get("", responses=reading_problems(409))
async def get_parameters(vehicle: VehicleDep) -> ParameterList:
    """The gains as far as they are known; nothing is asked of the board."""
    return _parameters(await vehicle.ask(ReadParameters()))


@router.post("/load", responses=problems(409, 502))
async def load_parameters(vehicle: VehicleDep, operator: OperatorDep) -> ParameterList:
    """Read the gains from the board; nothing is written."""
    return _parameters(await vehicle.ask(LoadParameters(), operator))


@router.patch("", responses=problems(404, 409, 502))
async def patch_parameters(
    changes: Annotated[dict[str, float], Body(examples=[{"k_pitch": 2.5}], min_length=1, max_length=_MOST_CHANGES)],
    vehicle: VehicleDep,
    operator: OperatorDep,
) -> ParameterList:
    """Set some gains by name: one step of the journal, and one more for the board's own. Answers after they were read
    back, `confirmed` or `rejected`."""
    return _parameters(await vehicle.ask(SetParameters(changes), operator))


@router.post("/undo", responses=problems(409, 502))
async def undo_parameters(vehicle: VehicleDep, operator: OperatorDep) -> ParameterList:
    """Take the newest step back; a write with read-back like any other."""
    return _parameters(await vehicle.ask(UndoParameters(), operator))


@router.post("/redo", responses=problems(409, 502))
async def redo_parameters(vehicle: VehicleDep, operator: OperatorDep) -> ParameterList:
    """Do again what was undone last."""
    return _parameters(await vehicle.ask(RedoParameters(), operator))


@router.get("/journal", responses=reading_problems(409))
async def get_journal(vehicle: VehicleDep) -> ParameterJournal:
    """Who wrote what when, newest first, over restarts; and what undo and redo would write now."""
    return await vehicle.ask(ReadJournal())


@router.post("/store", responses=problems(409))
async def store_parameters(vehicle: VehicleDep, operator: OperatorDep) -> CommandOutcome:
    """Write the board's gains to its card."""
    return await vehicle.ask(StoreParameters(), operator)


def _parameters(known: AllGains) -> ParameterList:
    built_in = [ParameterState.of(gain, known.built_in[gain.name]) for gain in PARAMETERS]
    return ParameterList(parameters=built_in, own=known.own)
