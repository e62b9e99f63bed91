"""The flight plans that the board holds."""

from __future__ import annotations

from dataclasses import asdict

from fastapi import APIRouter

from epf_gcs.codec.tables import Waypoint
from epf_gcs.contract.base import PlanName
from epf_gcs.contract.requests import ReadPlan, WritePlan
from epf_gcs.web.interface.deps import OperatorDep, VehicleDep
from epf_gcs.web.interface.missions.schemas import Mission, MissionInput
from epf_gcs.web.serving.problems import problems, reading_problems

router = APIRouter(prefix="/missions", tags=["missions"])


@router.get("/{plan}", responses=reading_problems(409, 502))
async def get_mission(plan: PlanName, vehicle: VehicleDep) -> Mission:
    """The plan as the board has it now."""
    return _mission(plan, await vehicle.ask(ReadPlan(plan)))


@router.put("/{plan}", responses=problems(409, 502))
async def put_mission(plan: PlanName, body: MissionInput, vehicle: VehicleDep, operator: OperatorDep) -> Mission:
    """Replace a plan, whole or not at all; answers with what was read back."""
    waypoints = [Waypoint(**waypoint.model_dump()) for waypoint in body.waypoints]
    return _mission(plan, await vehicle.ask(WritePlan(plan, waypoints), operator))


def _mission(plan: PlanName, waypoints: list[Waypoint]) -> Mission:
    return Mission.model_validate({"plan": plan, "waypoints": [asdict(waypoint) for waypoint in waypoints]})
