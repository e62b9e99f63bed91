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
from epf_gcs.formats.mission_file import MAX_WAYPOINTS, FileFormat
from epf_gcs.formats.recognise import MAX_FILE_BYTES, WRITERS, read_plan_file, settle_plan
from epf_gcs.formats.wpl_plan import FirstItem
from epf_gcs.formats.xml_tree import plain
from epf_gcs.web.interface.deps import SurroundingsDep
from epf_gcs.web.interface.missions.file_schemas import MissionExport, MissionImport, Thinned
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
HomeAltitude = Annotated[
    float | None,
    Query(
        ge=-2000,
        le=60000,
        allow_inf_nan=False,
        description="Home's altitude, feet above mean sea level, for a file that does not have it.",
    ),
]

First = Annotated[
    FirstItem | None,
    Query(description="What item 0 of a .waypoints is whose height is one of a waypoint; else such a file is refused."),
]


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
async def import_mission(
    request: Request,
    surroundings: SurroundingsDep,
    name: FileName,
    home_ft: HomeAltitude = None,
    thin: Thinned = False,  # noqa: FBT002 - a query parameter
    first: First = None,
) -> MissionImport:
    """Read a KML, KMZ, GPX, CSV, .plan or .waypoints file, whole or not at all; what it is, its content says.

    Heights above home or the ground become altitudes above the sea. Three refusals are questions, and the file is read
    with their answer: `mission_file_no_home` wants `home_ft`, `mission_file_home_unclear` wants `first`, and
    `mission_file_track` wants `thin`.
    """
    named = plain(name)
    # In a thread: the largest file takes a second, and the stream must not wait for it.
    plan = await asyncio.to_thread(read_plan_file, named, await request.body(), thin=thin, first=first)
    on_earth = all(abs(at.latitude_deg) <= 90 and abs(at.longitude_deg) <= 180 for at in plan.points)
    places = [(at.latitude_deg, at.longitude_deg) for at in plan.points[: MAX_WAYPOINTS + 1]]
    ground_ft, heights = await surroundings.ground_ft(places) if on_earth else ([], [])
    return MissionImport.of(settle_plan(named, plan, ground_ft, home_ft), heights)


def attachment(name: str, extension: str) -> str:
    """Content-Disposition of a download: a name that every system takes, and the whole one for those that can."""
    safe = "".join("_" if letter in _FORBIDDEN_IN_NAMES else letter for letter in plain(name)).strip(" .") or "plan"
    ascii_name = safe.encode("ascii", "replace").decode().replace("?", "_")
    return f"attachment; filename=\"{ascii_name}.{extension}\"; filename*=UTF-8''{quote(safe, safe='')}.{extension}"
