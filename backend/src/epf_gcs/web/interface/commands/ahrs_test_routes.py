"""The AHRS test: a stream of attitude alone, topic `ahrs_test`, in place of the board's frames."""

from __future__ import annotations

from fastapi import APIRouter

from epf_gcs.contract.answers import CommandOutcome
from epf_gcs.contract.requests import StartAhrsTest, StopAhrsTest
from epf_gcs.web.interface.deps import OperatorDep, VehicleDep
from epf_gcs.web.serving.problems import problems

router = APIRouter(tags=["commands"])


@router.post("/ahrs-test", responses=problems(409))
async def post_ahrs_test(vehicle: VehicleDep, operator: OperatorDep) -> CommandOutcome:
    """Begin the test; proved by its first record. Until it ends the board takes no command and sends nothing else."""
    return await vehicle.ask(StartAhrsTest(), operator)


@router.delete("/ahrs-test", responses=problems(409))
async def delete_ahrs_test(vehicle: VehicleDep, operator: OperatorDep) -> CommandOutcome:
    """End the test; proved by the board's next heartbeat, after which its streams are what they were."""
    return await vehicle.ask(StopAhrsTest(), operator)
