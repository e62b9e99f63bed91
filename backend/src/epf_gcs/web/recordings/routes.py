"""The recordings: list, size, download."""

from __future__ import annotations

import asyncio
from datetime import UTC, datetime
from pathlib import Path as FilePath
from typing import Annotated, Literal

from fastapi import APIRouter, Path
from fastapi.responses import FileResponse

from epf_gcs.errors import NotFoundError
from epf_gcs.web.deps import MirrorDep, RecordingsDirDep
from epf_gcs.web.problems import reading_problems
from epf_gcs.web.recordings.schemas import RecordingInfo, RecordingList
from epf_gcs.web.vehicle.mirror import VehicleMirror

router = APIRouter(tags=["recordings"])

RecordingId = Annotated[str, Path(pattern=r"^[0-9]{8}T[0-9]{6}Z(-[0-9]{1,4})?$", examples=["20260131T120000Z"])]


@router.get("/recordings", responses=reading_problems())
async def get_recordings(folder: RecordingsDirDep, mirror: MirrorDep) -> RecordingList:
    """All recordings, newest first."""
    return RecordingList(recordings=await asyncio.to_thread(_list, folder, _active(mirror)))


@router.get("/recordings/{recording_id}", responses=reading_problems(404))
async def get_recording(recording_id: RecordingId, folder: RecordingsDirDep, mirror: MirrorDep) -> RecordingInfo:
    """One recording."""
    return _find(recording_id, folder, _active(mirror))


@router.get(
    "/recordings/{recording_id}/export",
    response_class=FileResponse,
    responses={
        200: {"content": {"application/octet-stream": {"schema": {"type": "string", "format": "binary"}}}},
        **reading_problems(404),
    },
)
async def export_recording(
    recording_id: RecordingId,
    folder: RecordingsDirDep,
    mirror: MirrorDep,
    format: Literal["mcap"] = "mcap",  # noqa: A002 - the name of the query parameter
) -> FileResponse:
    """The file itself; one that is still being written is given as far as it is."""
    _find(recording_id, folder, _active(mirror))
    name = f"{recording_id}.{format}"
    return FileResponse(folder / name, media_type="application/octet-stream", filename=name)


def _active(mirror: VehicleMirror) -> str | None:
    """Name of the file that is being written."""
    file: str | None = mirror.status["recording"]["file"]
    return file


def _list(folder: FilePath, active: str | None) -> list[RecordingInfo]:
    files = sorted(folder.glob("*.mcap"), reverse=True)
    return [info for file in files if (info := _info(file, active)) is not None]


def _find(recording_id: str, folder: FilePath, active: str | None) -> RecordingInfo:
    info = _info(folder / f"{recording_id}.mcap", active)
    if info is None:
        raise NotFoundError(
            "recording_unknown",
            f"There is no recording '{recording_id}': GET /api/v1/recordings lists all of them.",
            recording=recording_id,
        )
    return info


def _info(file: FilePath, active: str | None) -> RecordingInfo | None:
    """None where the file is gone, or where it is none of ours."""
    try:
        started = datetime.strptime(file.stem.split("-")[0], "%Y%m%dT%H%M%SZ").replace(tzinfo=UTC)
        size = file.stat().st_size
    except (ValueError, OSError):
        return None
    return RecordingInfo(id=file.stem, started_s=started.timestamp(), bytes=size, active=file.name == active)
