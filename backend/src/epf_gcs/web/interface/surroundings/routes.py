"""Ground and fence: read by everybody, chosen by those who fly. What is seen now stands in the status."""

from __future__ import annotations

import asyncio
from typing import Final

from fastapi import APIRouter, Request, Response

from epf_gcs.contract.events import SurroundingsEvent
from epf_gcs.contract.shapes import FILE, file_body
from epf_gcs.errors import ConflictError
from epf_gcs.formats.fence_file import FenceFormat, read_fence_file, write_fence_kml, write_fence_plan
from epf_gcs.formats.kml import MEDIA_TYPE as KML_MEDIA_TYPE
from epf_gcs.formats.recognise import MAX_FILE_BYTES
from epf_gcs.formats.xml_tree import plain
from epf_gcs.surroundings.choice import FenceCorner, SurroundingsChange
from epf_gcs.web.interface.deps import HubDep, SurroundingsDep
from epf_gcs.web.interface.missions.file_routes import FileName, attachment
from epf_gcs.web.interface.surroundings.schemas import FenceImport, FenceNote, SurroundingsChoice
from epf_gcs.web.serving.problems import problems, reading_problems

"""The event that tells every page to read the choice again."""
IMPORT_PATH: Final = "/surroundings/fence/import"

_MEDIA_TYPES: Final[dict[FenceFormat, str]] = {"kml": KML_MEDIA_TYPE, "plan": "application/octet-stream"}
_FILE_NAME: Final = "epf-gcs-fence"

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
    hub.event(SurroundingsEvent())
    return SurroundingsChoice(**change.model_dump())


@router.get(
    "/fence",
    response_class=Response,
    responses={200: {"content": dict.fromkeys(_MEDIA_TYPES.values(), FILE)}, **reading_problems(409)},
)
async def get_fence(surroundings: SurroundingsDep, format: FenceFormat) -> Response:  # noqa: A002 - the query's name
    """The fence that is kept, as a file: a polygon of KML with its ceiling, or the geofence of a .plan, without."""
    choice = surroundings.choice
    corners = [(corner.latitude_deg, corner.longitude_deg) for corner in choice.corners]
    if not corners:
        raise ConflictError("surroundings_no_fence", "There is no fence yet: mark its corners and keep it.")
    data = write_fence_kml("EPF GCS", corners, choice.ceiling_ft) if format == "kml" else write_fence_plan(corners)
    return Response(
        data, media_type=_MEDIA_TYPES[format], headers={"Content-Disposition": attachment(_FILE_NAME, format)}
    )


@router.post(
    "/fence/import",
    responses=problems(),
    openapi_extra=file_body(maxLength=MAX_FILE_BYTES),
)
async def import_fence(request: Request, name: FileName) -> FenceImport:
    """Read the fence in a file: KML, KMZ, .plan, .waypoints with fence items, or rows of latitude and longitude.

    It is read whole or not at all. The fence that is watched stays as it is. A border that
    crosses itself is read, and noted.
    """
    # In a thread: the stream must not wait for the largest file.
    found = await asyncio.to_thread(read_fence_file, plain(name), await request.body())
    return FenceImport(
        format=found.format,
        corners=[FenceCorner(latitude_deg=latitude, longitude_deg=longitude) for latitude, longitude in found.corners],
        ceiling_ft=found.ceiling_ft,
        notes=[FenceNote(code=note.code, params=note.params) for note in found.notes],
    )
