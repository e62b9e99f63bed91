"""A plan flown in a model before it is sent. Nothing here reaches the board."""

from __future__ import annotations

from fastapi import APIRouter

from epf_gcs.codec.tables import Waypoint
from epf_gcs.rehearsal.findings import Bounds
from epf_gcs.rehearsal.flight_model import Start, SteadyWind
from epf_gcs.rehearsal.rehearsals import RehearsalOrder
from epf_gcs.web.interface.deps import RehearsalsDep, SurroundingsDep
from epf_gcs.web.interface.missions.rehearsal_schemas import MissionRehearsal, RehearsalFinding, RehearsalInput
from epf_gcs.web.serving.problems import problems

router = APIRouter(prefix="/missions", tags=["missions"])


@router.post("/rehearsal", responses=problems(409))
async def rehearse_mission(
    body: RehearsalInput, rehearsals: RehearsalsDep, surroundings: SurroundingsDep
) -> MissionRehearsal:
    """Fly a plan in a model of the simulator's aircraft under the board's laws, and say what goes wrong on which leg.

    It takes seconds, and 409 says that the plan was not flown: that is no result.
    """
    choice = surroundings.choice
    bounds = Bounds(
        tuple((corner.latitude_deg, corner.longitude_deg) for corner in choice.corners),
        choice.ceiling_ft,
        choice.margin_ft if choice.terrain_on else 0.0,
        None if body.endurance_min is None else body.endurance_min * 60.0,
    )
    order = RehearsalOrder(
        [Waypoint(**waypoint.model_dump()) for waypoint in body.waypoints],
        body.first,
        None if body.start is None else Start(**body.start.model_dump()),
        SteadyWind(**body.wind.model_dump()),
        bounds,
    )
    done = await rehearsals.fly(order)
    return MissionRehearsal(
        time_s=done.time_s,
        last=done.last,
        ground=done.ground,
        heights=done.heights,
        fence=bool(choice.corners) or choice.ceiling_ft is not None,
        battery=body.endurance_min is not None,
        findings=[RehearsalFinding(**one._asdict()) for one in done.findings],
    )
