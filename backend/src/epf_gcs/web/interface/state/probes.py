"""/health and /metrics for monitoring programs, at their customary paths."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import orjson
from fastapi import APIRouter, Request
from fastapi.responses import Response

from epf_gcs.access.caller import Caller
from epf_gcs.contract.status import Status
from epf_gcs.web.interface.deps import caller_of
from epf_gcs.web.state.figures import Disk, WebFigures
from epf_gcs.web.state.health import health
from epf_gcs.web.state.metrics import MEDIA_TYPE, metrics

_FRESH = {"Cache-Control": "no-store"}


def probe_router(
    status: Callable[[], Status | None],
    web: Callable[[], WebFigures],
    disk: Callable[[], Disk | None],
    caller: Callable[[Request], Caller | None] = caller_of,
) -> APIRouter:
    """`status` returns None if the flight process does not answer. Include this router before the page."""
    router = APIRouter(include_in_schema=False)

    @router.get("/health")
    async def get_health(request: Request) -> Response:
        """Whether each part is well: 200, or 503 where one failed. A stranger hears that alone, and
        whether the processes answer: a container that is well is not started again because a cable was pulled."""
        code, body = health(status(), disk())
        told = body if caller(request) is not None else {"status": body.status, "processes": body.processes}
        return Response(orjson.dumps(told), code, media_type="application/json", headers=_FRESH)

    @router.get("/metrics")
    async def get_metrics() -> Response:
        """Figures for Prometheus."""
        return Response(metrics(status(), disk(), web()), media_type=MEDIA_TYPE, headers=_FRESH)

    return router


def disk_of(folder: Path) -> Disk | None:
    """Free and total space on the disk of this folder; None if the folder does not exist."""
    try:
        usage = shutil.disk_usage(folder)
    except OSError:
        return None
    return Disk(usage.free, usage.total)
