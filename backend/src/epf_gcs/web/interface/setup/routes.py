"""Setting a station up: whether it is the first start, and what the doctor finds. For owners."""

from __future__ import annotations

import asyncio

from fastapi import APIRouter, status

from epf_gcs.web.interface.deps import AdmissionDep, DoctorDep, FirstStartDep
from epf_gcs.web.interface.language import LanguageDep
from epf_gcs.web.serving.problems import problems, reading_problems
from epf_gcs.web.setup.schemas import DoctorReport, FirstStartState

router = APIRouter(tags=["setup"])


@router.get("/first-start", responses=reading_problems())
async def get_first_start(first_start: FirstStartDep) -> FirstStartState:
    """Whether this data folder still has to be set up."""
    return FirstStartState(is_due=await asyncio.to_thread(first_start.is_due))


@router.delete("/first-start", status_code=status.HTTP_204_NO_CONTENT, responses=problems(507))
async def delete_first_start(first_start: FirstStartDep) -> None:
    """It is done, or put off: it is not asked about again."""
    await asyncio.to_thread(first_start.end)


@router.get("/doctor", responses=reading_problems(409))
async def get_doctor(doctor: DoctorDep, admission: AdmissionDep, language: LanguageDep) -> DoctorReport:
    """What keeps the station from working on this computer, and what to do about it, as `epf-gcs doctor` finds it."""
    return DoctorReport(findings=await doctor.look(admission.port, language))
