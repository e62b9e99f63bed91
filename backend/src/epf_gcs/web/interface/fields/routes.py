"""Prepare a field: what it will take, begin, pause, go on, remove, and proof that a file is whole."""

from __future__ import annotations

import shutil
from dataclasses import asdict
from typing import Annotated

from fastapi import APIRouter, Path

from epf_gcs.contract.maps import FieldProof, PreparedField
from epf_gcs.errors import InvalidInputError
from epf_gcs.fields.area import Area
from epf_gcs.fields.known_sources import KNOWN_SOURCES
from epf_gcs.fields.order import Order, Part
from epf_gcs.web.interface.deps import FieldsDep, MapsDep, OperatorDep
from epf_gcs.web.interface.fields.schemas import (
    FieldEstimate,
    FieldInput,
    FieldLevel,
    FieldList,
    FieldOrderInput,
    FieldSource,
)
from epf_gcs.web.interface.maps.routes import LayerId
from epf_gcs.web.serving.problems import problems, reading_problems

router = APIRouter(prefix="/map", tags=["maps"])

FieldId = Annotated[str, Path(pattern=r"^[0-9a-f]{12}$")]


@router.get("/fields", responses=reading_problems())
async def get_fields(fields: FieldsDep) -> FieldList:
    """What is being prepared, and public sources to choose from. The event `map_field` tells how far one is."""
    return FieldList(
        fields=[job.told for job in fields.all()],
        sources=[FieldSource(**asdict(source)) for source in KNOWN_SOURCES],
    )


@router.post("/fields/estimate", responses=problems(409))
async def estimate_field(body: FieldInput, fields: FieldsDep, maps: MapsDep) -> FieldEstimate:
    """What it will take, from counts and usual sizes; no source is asked."""
    levels, made_bytes = await fields.estimate(_order(body))
    free_bytes = await maps.in_thread(_free_bytes, maps.folder.path)
    return FieldEstimate(
        levels=[FieldLevel(**level._asdict()) for level in levels],
        tiles=sum(level.tiles for level in levels),
        bytes=sum(level.bytes for level in levels) + made_bytes,
        made_bytes=made_bytes,
        free_bytes=free_bytes,
    )


@router.post("/fields", responses=problems(409))
async def prepare_field(body: FieldOrderInput, fields: FieldsDep, _: OperatorDep) -> PreparedField:
    """Begin to bring it. It goes on by itself after cuts and restarts, and is a map of the folder when it is whole."""
    if not body.accepts_terms:
        raise InvalidInputError("field_terms", "Read the terms of the sources and accept them first.")
    return (await fields.start(_order(body))).told


@router.post("/fields/{field_id}/pause", responses=problems(404, 409))
async def pause_field(field_id: FieldId, fields: FieldsDep, _: OperatorDep) -> PreparedField:
    """Stop for now; what has arrived is kept."""
    return (await fields.pause(field_id)).told


@router.post("/fields/{field_id}/resume", responses=problems(404, 409))
async def resume_field(field_id: FieldId, fields: FieldsDep, _: OperatorDep) -> PreparedField:
    """Go on where it stopped."""
    return (await fields.resume(field_id)).told


@router.delete("/fields/{field_id}", responses=problems(404, 409))
async def remove_field(field_id: FieldId, fields: FieldsDep, _: OperatorDep) -> FieldList:
    """Stop it and delete all that has arrived. One that is done is only forgotten: its file is a layer, and is removed
    as one."""
    await fields.remove(field_id)
    return await get_fields(fields)


@router.post("/layers/{layer_id}/proof", responses=problems(404, 409))
async def prove_map_layer(layer_id: LayerId, fields: FieldsDep) -> FieldProof:
    """Compare every tile of a prepared field with the manifest in its file."""
    return await fields.prove(layer_id)


def _free_bytes(folder: object) -> int:
    try:
        return shutil.disk_usage(str(folder)).free
    except OSError:
        return 0


def _order(body: FieldInput) -> Order:
    points = tuple((point.latitude_deg, point.longitude_deg) for point in body.points)
    parts = tuple(
        Part(part.kind, part.name, part.url, part.attribution, part.minimum_zoom, part.maximum_zoom)
        for part in body.parts
    )
    return Order(body.name, Area(points, body.radius_m), parts)
