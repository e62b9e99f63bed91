"""The flight report, made by a worker program and kept beside the flight's columns."""

from __future__ import annotations

import base64
import hashlib
from typing import Annotated, Final, Literal

from fastapi import APIRouter, Path, Query
from fastapi.responses import HTMLResponse, Response

from epf_gcs.contract.report import FlightReport
from epf_gcs.contract.shapes import Description
from epf_gcs.errors import ConflictError, GatewayError, InvalidInputError
from epf_gcs.library.flights import Flights
from epf_gcs.recordings.places import ID_PATTERN
from epf_gcs.web.interface.deps import FlightsDep, HolderDep
from epf_gcs.web.interface.language import LanguageDep
from epf_gcs.web.serving.problems import reading_problems

router = APIRouter(prefix="/flights", tags=["flights"])

_HTML: Final[Description] = {"schema": {"type": "string"}}


@router.get(
    "/{flight_id}/report",
    response_class=Response,
    responses={200: {"model": FlightReport, "content": {"text/html": _HTML}}, **reading_problems(404, 409)},
)
async def get_flight_report(
    flight_id: Annotated[str, Path(pattern=ID_PATTERN, examples=["20260131T120000Z"])],
    flights: FlightsDep,
    lang: LanguageDep,
    holder: HolderDep,
    compare: Annotated[str | None, Query(pattern=ID_PATTERN, description="An earlier flight to set beside it.")] = None,
    format: Annotated[Literal["json", "html"], Query()] = "json",  # noqa: A002 - the contract's name
) -> Response:
    """The report of a finished flight. With `format=html` it is a page of its own, ready for print."""
    arguments = [await _recording(flights, flight_id)]
    if compare is not None:
        arguments += ["--compare", await _recording(flights, compare)]
    if format == "html":
        arguments += ["--page", lang]
    job = flights.jobs.start("report", arguments, by=holder, flight=flight_id)
    try:
        await job.ended.wait()
    finally:
        # Nobody waits for it any more: whoever asked has gone, or it is over.
        await flights.jobs.cancel(job)
    if job.fault is not None:
        raise _as_answer(job.fault)
    if job.state != "done" or job.answer is None:
        raise ConflictError(
            "job_failed", "The work on the recording failed (it was cancelled).", why="it was cancelled"
        )
    answer, job.answer = job.answer, None
    if format == "html":
        return HTMLResponse(answer.page, headers={"Content-Security-Policy": _policy_of(answer.page)})
    return Response(bytes(answer.report), media_type="application/json")


def _policy_of(page: str) -> str:
    """The page may show its own style and nothing else: it is one file that loads and runs nothing."""
    style = page.partition("<style>")[2].partition("</style>")[0]
    digest = base64.b64encode(hashlib.sha256(style.encode()).digest()).decode()
    return (
        f"default-src 'none'; style-src 'sha256-{digest}'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
    )


async def _recording(flights: Flights, flight: str) -> str:
    """The file of a finished flight. Raises NotFoundError, and ConflictError while it is recorded."""
    await flights.get(flight)
    if flight == flights.growing:
        raise ConflictError(
            "flight_recording", f"The flight '{flight}' is being recorded: end it first.", flight=flight
        )
    return str(flights.places.recording(flight).absolute())


def _as_answer(fault: GatewayError) -> GatewayError:
    kind = (
        ConflictError if fault.code in ("flight_not_indexed", "flight_not_written", "job_failed") else InvalidInputError
    )
    return kind(fault.code, fault.detail, **fault.params)
