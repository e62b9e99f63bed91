"""Flights as files of other programs: made by a job, or made and sent in one request."""

from __future__ import annotations

import asyncio
import contextlib
import secrets
from typing import Annotated, Final

from fastapi import APIRouter, Path, Query, Request
from fastapi.responses import FileResponse, Response
from starlette.background import BackgroundTask

from epf_gcs.contract.shapes import FILE
from epf_gcs.errors import ConflictError, GatewayError, InvalidInputError, NotFoundError
from epf_gcs.formats import czml, gpx_track, kml, kmz
from epf_gcs.formats.kml_words import Language
from epf_gcs.library.flights import Flights
from epf_gcs.library.jobs import Job
from epf_gcs.recordings.export_names import ExportFormat, check_export, file_name, is_single
from epf_gcs.recordings.places import ID_PATTERN
from epf_gcs.shares.holder import Holder
from epf_gcs.web.interface.deps import FlightsDep, HolderDep
from epf_gcs.web.interface.flights.schemas import ExportInput, JobStart
from epf_gcs.web.interface.language import BrowserLanguageDep, LanguageDep
from epf_gcs.web.serving.problems import problems, reading_problems

router = APIRouter(prefix="/flights", tags=["flights"])

_ZIP: Final = "application/zip"
_MEDIA_TYPES: Final[dict[ExportFormat, str]] = {
    "mcap": "application/octet-stream",
    "mcap-decoded": "application/octet-stream",
    "csv": _ZIP,
    "parquet": _ZIP,
    "kml": kml.MEDIA_TYPE,
    "kmz": kmz.MEDIA_TYPE,
    "gpx": gpx_track.MEDIA_TYPE,
    "czml": czml.MEDIA_TYPE,
}
_SINGLE: Final = {"csv": "text/csv", "parquet": "application/vnd.apache.parquet"}
# How often it is asked whether somebody still waits for the file.
_LOOK_EVERY_S: Final = 0.5

FlightId = Annotated[str, Path(pattern=ID_PATTERN, examples=["20260131T120000Z"])]
AtS = Annotated[float | None, Query(ge=0, le=10_000_000, description="Seconds since the flight's start.")]
Topics = Annotated[
    str | None,
    Query(
        pattern=r"^[a-z0-9_]{1,64}(,[a-z0-9_]{1,64}){0,99}$",
        max_length=2000,
        description="Topics, separated by commas; without it all of them.",
        examples=["ahrs,gps"],
    ),
]


@router.post("/{flight_id}/exports", status_code=202, responses=problems(404, 409))
async def start_flight_export(
    flight_id: FlightId, asked: ExportInput, flights: FlightsDep, browser: BrowserLanguageDep, holder: HolderDep
) -> JobStart:
    """Begin to write a flight as a file: the job tells how far it is, can be cancelled, and has the file as result."""
    return JobStart(job=(await _start(flights, flight_id, asked, browser, holder)).id)


@router.get(
    "/{flight_id}/export",
    response_class=Response,
    responses={
        200: {"content": dict.fromkeys(sorted({*_MEDIA_TYPES.values(), *_SINGLE.values()}), FILE)},
        **reading_problems(404, 409),
    },
)
async def get_flight_export(
    request: Request,
    flight_id: FlightId,
    flights: FlightsDep,
    lang: LanguageDep,
    holder: HolderDep,
    format: ExportFormat,  # noqa: A002 - the query parameter's name
    topics: Topics = None,
    from_s: AtS = None,
    to_s: AtS = None,
    every_point: Annotated[bool, Query(description="Also those less than a metre from the track.")] = False,  # noqa: FBT002 - a query parameter
) -> Response:
    """The same in one request, for programs: the answer comes when the file is made. Who hangs up cancels it."""
    chosen = None if topics is None else topics.split(",")
    asked = ExportInput(format=format, topics=chosen, from_s=from_s, to_s=to_s, every_point=every_point)
    job = await _start(flights, flight_id, asked, lang, holder)
    try:
        while not job.is_over and not await request.is_disconnected():
            with contextlib.suppress(TimeoutError):
                async with asyncio.timeout(_LOOK_EVERY_S):
                    await job.ended.wait()
    finally:
        await asyncio.shield(flights.jobs.cancel(job))
    if job.fault is not None:
        raise _as_answered(job.fault)
    if job.result is None or job.state != "done":
        raise ConflictError("job_over", f"The job '{job.id}' was cancelled: start it again.", job=job.id)
    media_type = _SINGLE[format] if is_single(format, chosen) else _MEDIA_TYPES[format]
    return FileResponse(
        job.result,
        media_type=media_type,
        filename=job.result_name,
        background=BackgroundTask(flights.jobs.drop, job),
    )


async def _start(flights: Flights, flight: str, asked: ExportInput, language: Language, by: Holder) -> Job:
    """Raises NotFoundError, InvalidInputError, and ConflictError while it is recorded or prepared."""
    check_export(asked.format, asked.topics, asked.from_s, asked.to_s)
    row = await flights.get(flight)
    if flight == flights.growing:
        raise ConflictError(
            "flight_recording", f"The flight '{flight}' is being recorded: end it first.", flight=flight
        )
    if row.summary is None and asked.format != "mcap":
        raise ConflictError(
            "flight_not_indexed", f"The flight '{flight}' is being prepared: wait until it is indexed.", flight=flight
        )
    result = flights.places.exports / secrets.token_hex(8)
    arguments = [str(flights.places.recording(flight)), asked.format, str(result), "--language", asked.lang or language]
    if asked.every_point:
        arguments.append("--every-point")
    if asked.topics is not None:
        arguments += ["--topics", ",".join(asked.topics)]
    for option, at_s in (("--from-s", asked.from_s), ("--to-s", asked.to_s)):
        if at_s is not None:
            arguments += [option, repr(at_s)]
    name = file_name(flight, asked.format, asked.topics)
    return flights.jobs.start("export", arguments, by=by, flight=flight, result=result, result_name=name)


def _as_answered(fault: GatewayError) -> GatewayError:
    """What a worker reported, as the kind of error that it is."""
    kind: type[GatewayError] = InvalidInputError
    if fault.code == "export_topic_unknown":
        kind = NotFoundError
    elif fault.code in ("flight_disk_full", "flight_not_indexed", "flight_not_written", "job_failed"):
        kind = ConflictError
    return kind(fault.code, fault.detail, **fault.params)
