"""The checklist before take-off: read by everybody, changed by those who fly."""

from __future__ import annotations

import asyncio

from fastapi import APIRouter

from epf_gcs.contract.events import ChecklistEvent
from epf_gcs.web.checklist.schemas import Checklist, ChecklistChange
from epf_gcs.web.interface.deps import ChecklistDep, HubDep
from epf_gcs.web.serving.problems import problems, reading_problems

"""The event that tells every page to read the list again."""

router = APIRouter(prefix="/checklist", tags=["checklist"])


@router.get("", responses=reading_problems(409))
async def get_checklist(kept: ChecklistDep) -> Checklist:
    """The lines to be gone through before take-off."""
    return await asyncio.to_thread(kept.read)


@router.put("", responses=problems(409))
async def put_checklist(change: ChecklistChange, kept: ChecklistDep, hub: HubDep) -> Checklist:
    """Replace the list; it is kept over restarts."""
    found = await asyncio.to_thread(kept.write, change)
    hub.event(ChecklistEvent())
    return found


@router.delete("", responses=problems(409))
async def delete_checklist(kept: ChecklistDep, hub: HubDep) -> Checklist:
    """Back to the page's own list."""
    found = await asyncio.to_thread(kept.write, None)
    hub.event(ChecklistEvent())
    return found
