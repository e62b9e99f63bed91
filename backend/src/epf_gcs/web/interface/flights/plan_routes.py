"""A flight that was flown as a plan. Nothing here reaches the board: a plan is uploaded by itself."""

from __future__ import annotations

from typing import Literal

import msgspec
from fastapi import APIRouter

from epf_gcs.contract.flight_questions import PathQuestion
from epf_gcs.contract.flights import FlownPath
from epf_gcs.formats.mission_file import MAX_WAYPOINTS
from epf_gcs.formats.recognise import plan_of_path, settle_plan
from epf_gcs.web.interface.deps import FlightsDep, QueriesDep
from epf_gcs.web.interface.flights.data_routes import FlightName, which
from epf_gcs.web.interface.missions.file_schemas import MissionImport, Thinned
from epf_gcs.web.serving.problems import reading_problems

router = APIRouter(prefix="/flights", tags=["flights"])


@router.get("/{flight_id}/plan", responses=reading_problems(404, 409))
async def get_flight_plan(
    flight_id: FlightName,
    flights: FlightsDep,
    queries: QueriesDep,
    source: Literal["flight", "hil"] = "hil",
    thin: Thinned = False,  # noqa: FBT002 - a query parameter
) -> MissionImport:
    """The flown track as a plan of few waypoints, as if it were read from a file.

    The refusal `mission_file_track` is a question: it has the figures, and wants `thin`.
    """
    flight, growing = await which(flight_id, flights)
    answer = await queries.ask(PathQuestion(flight, growing, source, MAX_WAYPOINTS))
    path = msgspec.json.decode(answer, type=FlownPath)
    return MissionImport.of(settle_plan(flight, plan_of_path(flight, path, thin=thin)), [])
