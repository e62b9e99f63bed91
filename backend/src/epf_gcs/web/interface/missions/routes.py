"""The flight plans that the board holds."""

from __future__ import annotations

from fastapi import APIRouter

from epf_gcs.contract.shapes import PlanName
from epf_gcs.web.interface.deps import OperatorDep, VehicleDep
from epf_gcs.web.interface.missions.schemas import Mission, MissionInput
from epf_gcs.web.serving.problems import problems, reading_problems

router = APIRouter(prefix="/missions", tags=["missions"])


@router.get("/{plan}", responses=reading_problems(409, 502))
async def get_mission(plan: PlanName, vehicle: VehicleDep) -> Mission:
    """The plan as the board has it now."""
    return Mission.model_validate({"plan": plan, "waypoints": await vehicle.request("missions.read", plan=plan)})


@router.put("/{plan}", responses=problems(409, 502))
async def put_mission(plan: PlanName, body: MissionInput, vehicle: VehicleDep, operator: OperatorDep) -> Mission:
    """Replace a plan, whole or not at all; answers with what was read back."""
    waypoints = [waypoint.model_dump() for waypoint in body.waypoints]
    found = await vehicle.request("missions.write", operator, plan=plan, waypoints=waypoints)
    return Mission.model_validate({"plan": plan, "waypoints": found})
