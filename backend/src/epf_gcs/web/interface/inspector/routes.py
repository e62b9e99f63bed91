"""The message inspector: everything that goes over the lines, and advice."""

from __future__ import annotations

from fastapi import APIRouter, Response

from epf_gcs.contract.inspector import Inspector
from epf_gcs.web.interface.deps import InspectorDep
from epf_gcs.web.serving.problems import reading_problems

router = APIRouter(tags=["inspector"])


@router.get("/inspector", response_model=Inspector, responses=reading_problems(409))
async def get_inspector(inspector: InspectorDep) -> Response:
    """Every type of frame and row with rate, jitter, count and last values; the load of the lines; and advice."""
    return Response(await inspector.text(), media_type="application/json")
