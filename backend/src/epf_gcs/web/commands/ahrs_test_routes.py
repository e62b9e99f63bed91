"""The AHRS test: a stream of attitude alone, topic `ahrs_test`, in place of the board's frames."""

from __future__ import annotations

from dataclasses import asdict

from fastapi import APIRouter

from epf_gcs.web.deps import OperatorDep, StationDep
from epf_gcs.web.problems import problems
from epf_gcs.web.schemas import CommandOutcome

router = APIRouter(tags=["commands"])


@router.post("/ahrs-test", responses=problems(409))
async def post_ahrs_test(station: StationDep, _: OperatorDep) -> CommandOutcome:
    """Begin the test; proved by its first record. Until it ends the board takes no command and sends nothing else."""
    return CommandOutcome.model_validate(asdict(await station.ahrs_test.start()))


@router.delete("/ahrs-test", responses=problems(409))
async def delete_ahrs_test(station: StationDep, _: OperatorDep) -> CommandOutcome:
    """End the test; proved by the board's next heartbeat, after which its streams are what they were."""
    return CommandOutcome.model_validate(asdict(await station.ahrs_test.stop()))
