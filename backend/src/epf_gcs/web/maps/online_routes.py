"""Online sources of maps: whether any is asked at all, which, and how much of what was seen is kept."""

from __future__ import annotations

from dataclasses import asdict

from fastapi import APIRouter

from epf_gcs.errors import InvalidInputError
from epf_gcs.flight.station import Station
from epf_gcs.web.deps import OperatorDep, StationDep
from epf_gcs.web.maps.schemas import OnlineInput, OnlineSource, OnlineState, problem_fields
from epf_gcs.web.maps.sources import OnlineChoice, Source
from epf_gcs.web.problems import problems, reading_problems

router = APIRouter(prefix="/map/online", tags=["maps"])


@router.get("", responses=reading_problems())
async def get_online_maps(station: StationDep) -> OnlineState:
    """What the operator chose, and how it goes."""
    return await _state(station)


@router.put("", responses=problems(409))
async def put_online_maps(body: OnlineInput, station: StationDep, _: OperatorDep) -> OnlineState:
    """Choose. Kept over restarts; switched off, nothing leaves the station. What is over the limit goes at once."""
    ids = [source.id for source in body.sources]
    if len(set(ids)) != len(ids):
        raise InvalidInputError("invalid_request", "Two sources have the same id: give each its own.", field="sources")
    sources = tuple(Source(**source.model_dump()) for source in body.sources)
    await station.maps.online.choose(OnlineChoice(body.enabled, body.limit_bytes, sources))
    return await _state(station)


@router.delete("/cache", responses=problems(409))
async def clear_online_cache(station: StationDep, _: OperatorDep) -> OnlineState:
    """Forget every tile that was kept."""
    await station.maps.online.clear()
    return await _state(station)


async def _state(station: Station) -> OnlineState:
    online = station.maps.online
    return OnlineState(
        enabled=online.choice.enabled,
        limit_bytes=online.choice.limit_bytes,
        cached_bytes=await online.cached_bytes(),
        sources=[_source(station, source) for source in online.choice.sources],
    )


def _source(station: Station, source: Source) -> OnlineSource:
    problem = station.maps.online.problem_of(source.id)
    return OnlineSource(**asdict(source), **problem_fields(problem))
