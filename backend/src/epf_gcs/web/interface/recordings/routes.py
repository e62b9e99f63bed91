"""The recordings: list, size, download."""

from __future__ import annotations

import asyncio
from typing import Annotated, Literal

from fastapi import APIRouter, Depends, Path, Request
from fastapi.responses import FileResponse, Response, StreamingResponse

from epf_gcs.contract.shapes import FILE
from epf_gcs.errors import NotFoundError
from epf_gcs.web.interface.deps import MirrorDep, RecordingsDirDep
from epf_gcs.web.interface.recordings.folder import GrowingFile, Recording, RecordingFolder
from epf_gcs.web.interface.recordings.schemas import RecordingInfo, RecordingList
from epf_gcs.web.serving.problems import reading_problems

router = APIRouter(tags=["recordings"])

RecordingId = Annotated[str, Path(pattern=r"^[0-9]{8}T[0-9]{6}Z(-[0-9]{1,4})?$", examples=["20260131T120000Z"])]


async def _folder_of(path: RecordingsDirDep, mirror: MirrorDep) -> RecordingFolder:
    """The only part of the station that these routes use."""

    def growing() -> GrowingFile | None:
        recording = mirror.status.recording
        return None if recording.file is None or not recording.active else GrowingFile(recording.file, recording.bytes)

    return RecordingFolder(path, growing)


FolderDep = Annotated[RecordingFolder, Depends(_folder_of)]


@router.get("/recordings", responses=reading_problems())
async def get_recordings(folder: FolderDep) -> RecordingList:
    """All recordings, newest first."""
    return RecordingList(recordings=[_info(one) for one in await asyncio.to_thread(folder.all)])


@router.get("/recordings/{recording_id}", responses=reading_problems(404))
async def get_recording(recording_id: RecordingId, folder: FolderDep) -> RecordingInfo:
    """One recording."""
    return _info(await _find(recording_id, folder))


@router.get(
    "/recordings/{recording_id}/export",
    response_class=FileResponse,
    responses={
        200: {"content": {"application/octet-stream": FILE}},
        **reading_problems(404),
    },
)
async def export_recording(
    recording_id: RecordingId,
    request: Request,
    folder: FolderDep,
    format: Literal["mcap"] = "mcap",  # noqa: A002 - the name of the query parameter
) -> Response:
    """The file itself; one that is still being written is given as it was at the request, up to a whole record."""
    found = await _find(recording_id, folder)
    name = f"{recording_id}.{format}"
    if "range" in request.headers:
        # A range has a fixed end, so data appended meanwhile does not matter.
        return FileResponse(found.path, media_type="application/octet-stream", filename=name)
    # FileResponse sends Content-Length first and then the whole file: too many bytes if the file grows meanwhile.
    headers = {
        "Content-Length": str(found.size),
        "Content-Disposition": f'attachment; filename="{name}"',
        "Accept-Ranges": "bytes",
    }
    return StreamingResponse(found.pieces(), media_type="application/octet-stream", headers=headers)


async def _find(recording_id: str, folder: RecordingFolder) -> Recording:
    found = await asyncio.to_thread(folder.find, recording_id)
    if found is None:
        raise NotFoundError(
            "recording_unknown",
            f"There is no recording '{recording_id}': GET /api/v1/recordings lists all of them.",
            recording=recording_id,
        )
    return found


def _info(found: Recording) -> RecordingInfo:
    return RecordingInfo(id=found.path.stem, started_s=found.started_s, bytes=found.size, active=found.active)
