"""A backup of the station, made by a job. It is restored at the command line alone, while no station runs."""

from __future__ import annotations

import secrets
import time
from typing import Annotated

from fastapi import APIRouter
from pydantic import AfterValidator, Field, SecretStr

from epf_gcs.backup.password import LONGEST, SHORTEST
from epf_gcs.contract.shapes import Input
from epf_gcs.web.interface.deps import ClockDep, FlightsDep, HolderDep
from epf_gcs.web.interface.flights.schemas import JobStart
from epf_gcs.web.serving.problems import problems

router = APIRouter(prefix="/backups", tags=["access"])


def _one_line(password: SecretStr) -> SecretStr:
    """It is typed again where it is restored, and is one line on its way to the job's program."""
    if not password.get_secret_value().isprintable():
        raise ValueError("a password is one line of printable characters")
    return password


class BackupInput(Input):
    """The password without which nobody can read the backup: one line."""

    password: Annotated[SecretStr, Field(min_length=SHORTEST, max_length=LONGEST), AfterValidator(_one_line)]


@router.post("", status_code=202, responses=problems(409))
async def start_backup(asked: BackupInput, flights: FlightsDep, clock: ClockDep, holder: HolderDep) -> JobStart:
    """Begin to write the data folder as one file, encrypted with the password in the format of age.

    The job tells how far it is, can be cancelled, and has the file as result for an hour.
    """
    result = flights.places.exports / secrets.token_hex(8)
    name = time.strftime("epf-gcs-%Y%m%dT%H%M%SZ.tar.age", time.gmtime(clock.now_s()))
    arguments = [str(flights.places.data_dir), str(result)]
    job = flights.jobs.start(
        "backup",
        arguments,
        by=holder,
        flight=None,
        result=result,
        result_name=name,
        secret=asked.password.get_secret_value(),
    )
    return JobStart(job=job.id)
