"""Jobs: what is worked on, cancelling it, and fetching what it made."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Path
from fastapi.responses import FileResponse

from epf_gcs.access.roles import Role
from epf_gcs.contract.flights import Job
from epf_gcs.contract.shapes import FILE
from epf_gcs.errors import NotFoundError
from epf_gcs.web.interface.deps import AdmittedDep, FlightsDep
from epf_gcs.web.interface.flights.schemas import JobList
from epf_gcs.web.serving.guard import admitted
from epf_gcs.web.serving.problems import problems, reading_problems

router = APIRouter(prefix="/jobs", tags=["flights"])

JobId = Annotated[str, Path(pattern=r"^[0-9a-f]{12}$")]


@router.get("", responses=reading_problems())
async def get_jobs(flights: FlightsDep) -> JobList:
    """Jobs under way and the last that ended, newest first. The event `job` tells of each change."""
    return JobList(jobs=[job.told for job in flights.jobs.all()])


@router.get("/{job_id}", responses=reading_problems(404))
async def get_job(job_id: JobId, flights: FlightsDep) -> Job:
    """How far a job is."""
    return flights.jobs.get(job_id).told


@router.delete("/{job_id}", responses=problems(404, 409))
async def cancel_job(job_id: JobId, flights: FlightsDep, caller: AdmittedDep) -> Job:
    """Stop a job: nothing of what it made is kept. One that is over stays as it is. A viewer stops its own alone."""
    job = flights.jobs.get(job_id)
    if job.by.key != caller.session:
        admitted(caller, Role.operator)
    await flights.cancel(job)
    return job.told


@router.get(
    "/{job_id}/result",
    response_class=FileResponse,
    responses={
        200: {"content": {"application/octet-stream": FILE}},
        **reading_problems(404),
    },
)
async def get_job_result(job_id: JobId, flights: FlightsDep, caller: AdmittedDep) -> FileResponse:
    """The file that a job made. That of a backup is for owners."""
    job = flights.jobs.get(job_id)
    if job.kind == "backup":
        admitted(caller, Role.owner)
    if job.result is None or job.told.result is None:
        raise NotFoundError("job_over", f"The job '{job_id}' has no file to be fetched: start it again.", job=job_id)
    return FileResponse(job.result, media_type="application/octet-stream", filename=job.result_name)
