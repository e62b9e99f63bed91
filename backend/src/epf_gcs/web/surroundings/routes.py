"""Ground and fence: read by everybody, chosen by those who fly. What is seen now stands in the status."""

from __future__ import annotations

from fastapi import APIRouter

from epf_gcs.web.deps import HubDep, SurroundingsDep
from epf_gcs.web.problems import problems, reading_problems
from epf_gcs.web.surroundings.schemas import SurroundingsChange, SurroundingsChoice

CHANGED = "surroundings"
"""The event that tells every page to read the choice again."""

router = APIRouter(prefix="/surroundings", tags=["surroundings"])


@router.get("", responses=reading_problems())
async def get_surroundings(surroundings: SurroundingsDep) -> SurroundingsChoice:
    """Whether ground and fence are watched, with which margins, and the fence."""
    return SurroundingsChoice(**surroundings.choice.model_dump())


@router.put("", responses=problems(409))
async def put_surroundings(
    change: SurroundingsChange, surroundings: SurroundingsDep, hub: HubDep
) -> SurroundingsChoice:
    """Choose; it is kept over restarts. The warnings are advice: nothing is ever commanded by them."""
    await surroundings.choose(change)
    hub.event(CHANGED, {})
    return SurroundingsChoice(**change.model_dump())
