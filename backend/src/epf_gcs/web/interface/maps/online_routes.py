"""Online sources of maps: whether any is asked at all, which, and how much of what was seen is kept."""

from __future__ import annotations

from dataclasses import asdict

from fastapi import APIRouter

from epf_gcs.contract.maps import problem_parts
from epf_gcs.errors import InvalidInputError
from epf_gcs.maps.maps import Maps
from epf_gcs.maps.sources import OnlineChoice, Source
from epf_gcs.web.interface.deps import MapsDep, OperatorDep
from epf_gcs.web.interface.maps.schemas import OnlineInput, OnlineSource, OnlineState
from epf_gcs.web.serving.problems import problems, reading_problems

router = APIRouter(prefix="/map/online", tags=["maps"])


@router.get("", responses=reading_problems())
async def get_online_maps(maps: MapsDep) -> OnlineState:
    """What the operator chose, and how it goes."""
    return await _state(maps)


@router.put("", responses=problems(409))
async def put_online_maps(body: OnlineInput, maps: MapsDep, _: OperatorDep) -> OnlineState:
    """Choose. Kept over restarts; switched off, nothing leaves the station. What is over the limit goes at once."""
    ids = [source.id for source in body.sources]
    if len(set(ids)) != len(ids):
        raise InvalidInputError("invalid_request", "Two sources have the same id: give each its own.", field="sources")
    sources = tuple(Source(**source.model_dump()) for source in body.sources)
    await maps.online.choose(OnlineChoice(body.enabled, body.limit_bytes, sources))
    return await _state(maps)


@router.delete("/cache", responses=problems(409))
async def clear_online_cache(maps: MapsDep, _: OperatorDep) -> OnlineState:
    """Forget every tile that was kept."""
    await maps.online.clear()
    return await _state(maps)


async def _state(maps: Maps) -> OnlineState:
    online = maps.online
    return OnlineState(
        enabled=online.choice.enabled,
        limit_bytes=online.choice.limit_bytes,
        cached_bytes=await online.cached_bytes(),
        sources=[_source(maps, source) for source in online.choice.sources],
    )


def _source(maps: Maps, source: Source) -> OnlineSource:
    problem = maps.online.problem_of(source.id)
    return OnlineSource(*problem_parts(problem), **asdict(source))
