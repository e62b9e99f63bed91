"""The 17 gains and the flight plans: what the board holds."""

from __future__ import annotations

from dataclasses import asdict
from typing import Annotated

from fastapi import APIRouter, Body

from epf_gcs.codec.messages_gen import PARAMETERS
from epf_gcs.codec.tables import Waypoint
from epf_gcs.flight.station import Station
from epf_gcs.vehicle.journal import moves_as_dicts
from epf_gcs.vehicle.parameters import shown
from epf_gcs.web.deps import OperatorDep, StationDep
from epf_gcs.web.parameters.schemas import ParameterJournal, ParameterList, ParameterState
from epf_gcs.web.problems import problems, reading_problems
from epf_gcs.web.schemas import CommandOutcome, Mission, MissionInput, PlanName, WaypointModel

router = APIRouter()


@router.get("/parameters", tags=["parameters"], responses=reading_problems())
async def get_parameters(station: StationDep) -> ParameterList:
    """The gains as far as they are known; nothing is asked of the board."""
    return _parameters(station)


@router.post("/parameters/load", tags=["parameters"], responses=problems(409, 502))
async def load_parameters(station: StationDep, operator: OperatorDep) -> ParameterList:
    """Read the gains from the board; nothing is written."""
    await station.parameters.load(operator)
    return _parameters(station)


@router.patch("/parameters", tags=["parameters"], responses=problems(404, 409, 502))
async def patch_parameters(
    changes: Annotated[dict[str, float], Body(examples=[{"k_pitch": 2.5}], min_length=1, max_length=17)],
    station: StationDep,
    operator: OperatorDep,
) -> ParameterList:
    """Set some gains: one step of the journal. Answers after they were read back, `confirmed` or `rejected`."""
    await station.parameters.set(changes, operator)
    return _parameters(station)


@router.post("/parameters/undo", tags=["parameters"], responses=problems(409, 502))
async def undo_parameters(station: StationDep, operator: OperatorDep) -> ParameterList:
    """Take the newest step back; a write with read-back like any other."""
    await station.parameters.undo(operator)
    return _parameters(station)


@router.post("/parameters/redo", tags=["parameters"], responses=problems(409, 502))
async def redo_parameters(station: StationDep, operator: OperatorDep) -> ParameterList:
    """Do again what was undone last."""
    await station.parameters.redo(operator)
    return _parameters(station)


@router.get("/parameters/journal", tags=["parameters"], responses=reading_problems())
async def get_journal(station: StationDep) -> ParameterJournal:
    """Who wrote what when, newest first, over restarts; and what undo and redo would write now."""
    journal = station.parameters.journal
    return ParameterJournal.model_validate(
        {
            "entries": [entry.as_dict() for entry in journal.entries],
            "undo": moves_as_dicts(journal.steps.undo),
            "redo": moves_as_dicts(journal.steps.redo),
        }
    )


@router.post("/parameters/store", tags=["parameters"], responses=problems(409))
async def store_parameters(station: StationDep, operator: OperatorDep) -> CommandOutcome:
    """Write the board's gains to its card."""
    result = await station.parameters.store(operator)
    return CommandOutcome.model_validate(asdict(result))


@router.get("/missions/{plan}", tags=["missions"], responses=reading_problems(409, 502))
async def get_mission(plan: PlanName, station: StationDep) -> Mission:
    """The plan as the board has it now."""
    return _mission(plan, await station.missions.read(plan))


@router.put("/missions/{plan}", tags=["missions"], responses=problems(409, 502))
async def put_mission(plan: PlanName, body: MissionInput, station: StationDep, operator: OperatorDep) -> Mission:
    """Replace a plan, whole or not at all; answers with what was read back."""
    waypoints = [Waypoint(**waypoint.model_dump()) for waypoint in body.waypoints]
    return _mission(plan, await station.missions.write(plan, waypoints, operator))


def _parameters(station: Station) -> ParameterList:
    held = station.parameters.held
    return ParameterList(
        parameters=[
            ParameterState(
                name=parameter.name,
                group=parameter.group,
                value=_shown(parameter.name, held[parameter.name].value),
                loaded=_shown(parameter.name, held[parameter.name].loaded),
                state=held[parameter.name].state,
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


def _shown(name: str, value: float | None) -> float | None:
    return None if value is None else shown(name, value)


def _mission(plan: PlanName, waypoints: list[Waypoint]) -> Mission:
    return Mission(
        plan=plan,
        waypoints=[
            WaypointModel(
                latitude_deg=waypoint.latitude_deg,
                longitude_deg=waypoint.longitude_deg,
                altitude_ft=waypoint.altitude_ft,
                speed_kt=waypoint.speed_kt,
            )
            for waypoint in waypoints
        ],
    )
