"""Flight plans as files of other programs. Nothing here reaches the board: a plan is uploaded by itself."""

from __future__ import annotations

import asyncio
from typing import Annotated, Final
from urllib.parse import quote

from fastapi import APIRouter, Query, Request, Response

from epf_gcs.codec.tables import Waypoint
from epf_gcs.contract.shapes import FILE, file_body
from epf_gcs.formats.kml import MEDIA_TYPE as KML_MEDIA_TYPE
from epf_gcs.formats.kmz import MEDIA_TYPE as KMZ_MEDIA_TYPE
from epf_gcs.formats.mission_file import FileFormat
from epf_gcs.formats.recognise import MAX_FILE_BYTES, WRITERS, read_mission_file
from epf_gcs.formats.xml_tree import plain
from epf_gcs.web.interface.missions.file_schemas import MissionExport, MissionImport, MissionNote
from epf_gcs.web.interface.missions.schemas import WaypointModel
from epf_gcs.web.serving.problems import problems

router = APIRouter(prefix="/missions", tags=["missions"])

IMPORT_PATH: Final = "/missions/import"
_MEDIA_TYPES: Final[dict[FileFormat, str]] = {
    "kml": KML_MEDIA_TYPE,
    "kmz": KMZ_MEDIA_TYPE,
    "gpx": "application/gpx+xml",
    "csv": "text/csv; charset=utf-8",
    "plan": "application/octet-stream",
}
# Characters that some operating system forbids in file names.
_FORBIDDEN_IN_NAMES: Final = frozenset('/\\:*?"<>|')

FileName = Annotated[str, Query(min_length=1, max_length=255, description="The file's name, for the sentences.")]


@router.post(
    "/export",
    response_class=Response,
    responses={
        200: {"content": {media_type.split(";")[0]: FILE for media_type in _MEDIA_TYPES.values()}},
        **problems(),
    },
)
async def export_mission(body: MissionExport, format: FileFormat) -> Response:  # noqa: A002 - the query parameter's name
    """A plan as a file."""
    waypoints = [Waypoint(**waypoint.model_dump()) for waypoint in body.waypoints]
    return Response(
        WRITERS[format](body.name, waypoints),
        media_type=_MEDIA_TYPES[format],
        headers={"Content-Disposition": attachment(body.name, format)},
    )


@router.post(
    "/import",
    responses=problems(),
    openapi_extra=file_body(maxLength=MAX_FILE_BYTES),
)
async def import_mission(request: Request, name: FileName) -> MissionImport:
    """Read a KML, KMZ, GPX, CSV, .plan or .waypoints file, whole or not at all; what it is, its content says."""
    # In a thread: the largest file takes a second, and the stream must not wait for it.
    found = await asyncio.to_thread(read_mission_file, plain(name), await request.body())
    return MissionImport(
        format=found.format,
        waypoints=[
            WaypointModel(
                latitude_deg=waypoint.latitude_deg,
                longitude_deg=waypoint.longitude_deg,
                altitude_ft=waypoint.altitude_ft,
                speed_kt=waypoint.speed_kt,
            )
            for waypoint in found.waypoints
        ],
        notes=[MissionNote(code=note.code, params=note.params) for note in found.notes],
    )


def attachment(name: str, extension: str) -> str:
    """Content-Disposition of a download: a name that every system takes, and the whole one for those that can."""
    safe = "".join("_" if letter in _FORBIDDEN_IN_NAMES else letter for letter in plain(name)).strip(" .") or "plan"
    ascii_name = safe.encode("ascii", "replace").decode().replace("?", "_")
    return f"attachment; filename=\"{ascii_name}.{extension}\"; filename*=UTF-8''{quote(safe, safe='')}.{extension}"
