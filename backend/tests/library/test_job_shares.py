"""Jobs have shares: viewers cannot fill the queue, owners' work begins first, the station's own is never refused."""

from __future__ import annotations

import asyncio
from pathlib import Path
from typing import Any

import pytest

from epf_gcs.access.roles import Role
from epf_gcs.errors import ConflictError
from epf_gcs.library.jobs import Job, JobAnswer, Jobs
from epf_gcs.shares.holder import STATION, Holder, Standing
from epf_gcs.shares.table import SHARES
from tests.flights.flown_flights import recording
from tests.support.callers import person, strict_gateway
from tests.support.waiting import eventually


class HeldJobs(Jobs):
    """Their programs end when they are told to."""

    def __init__(self) -> None:
        super().__init__(lambda *_: None)
        self.ends: dict[str, asyncio.Event] = {}

    async def _work(self, job: Job, arguments: list[str], secret: str | None) -> None:
        await self.ends.setdefault(job.id, asyncio.Event()).wait()
        job.answer = JobAnswer()


def viewer(name: str) -> Holder:
    return Holder(name, Standing.viewer)


OWNER = Holder("boss", Standing.owner)
# More than anybody may have waiting.
MANY = 100


async def settle() -> None:
    for _ in range(10):
        await asyncio.sleep(0)


async def filled(jobs: HeldJobs, *holders: Holder) -> list[Job]:
    """As many exports as these may start, each as fast as it can; fails where there is no end of it."""
    started: list[Job] = []
    for holder in holders:
        for _ in range(MANY):
            try:
                started.append(jobs.start("export", [], by=holder, flight="f"))
            except ConflictError:
                break
            await settle()
        else:
            raise AssertionError(f"{holder.key} may start {MANY} jobs: nobody refuses them")
    return started


@pytest.mark.anyio
async def test_one_viewer_waits_with_few_and_hears_that_they_are_its_own() -> None:
    jobs, most = HeldJobs(), SHARES.jobs_waiting.parts[Standing.viewer].each
    started = await filled(jobs, viewer("ana"))
    assert [job.state for job in started] == ["running"] + ["waiting"] * most
    with pytest.raises(ConflictError) as refused:
        jobs.start("report", [], by=viewer("ana"), flight="f")
    assert (refused.value.code, refused.value.params) == ("jobs_busy_own", {"limit": most})
    await jobs.cancel(started[-1])
    assert jobs.start("export", [], by=viewer("ana"), flight="f").state == "waiting"
    await jobs.close()


@pytest.mark.anyio
async def test_when_viewers_have_filled_their_share_an_owner_s_export_begins_at_once() -> None:
    jobs = HeldJobs()
    started = await filled(jobs, *(viewer(f"v{number}") for number in range(20)))
    most = SHARES.jobs_waiting.parts[Standing.viewer].together
    assert len(started) == most + SHARES.results.parts[Standing.viewer].together
    with pytest.raises(ConflictError) as refused:
        jobs.start("export", [], by=viewer("late"), flight="f")
    assert (refused.value.code, refused.value.params) == ("jobs_busy", {"limit": most})
    mine = jobs.start("export", [], by=OWNER, flight="f")
    await settle()
    assert mine.state == "running"
    await jobs.close()


@pytest.mark.anyio
async def test_of_those_that_wait_an_owner_s_begins_first() -> None:
    jobs = HeldJobs()
    others = await filled(jobs, viewer("ana"), viewer("eva"), OWNER)
    running = [job for job in others if job.state == "running"]
    assert [job.by.key for job in running] == ["ana", "eva", "boss"]
    jobs.ends[running[0].id].set()
    await settle()
    assert [job.by.key for job in others if job.state == "running"] == ["eva", "boss", "boss"]
    await jobs.close()


@pytest.mark.anyio
async def test_the_station_s_own_work_is_never_refused() -> None:
    jobs = HeldJobs()
    await filled(jobs, *(Holder(f"o{number}", Standing.own) for number in range(3)))
    preparing = [jobs.start("pack", [], by=STATION, flight=f"f{number}") for number in range(30)]
    await settle()
    assert preparing[0].state == "running"
    await jobs.close()


def start_export(client: Any, flight: str) -> str:
    return str(client.post(f"/flights/{flight}/exports", json={"format": "csv"}).raise_for_status().json()["job"])


def test_a_viewer_cancels_its_own_job_and_an_operator_anybody_s(tmp_path: Path) -> None:
    with strict_gateway(tmp_path / "data") as station, person(station, Role.operator, "Op") as operator:
        flight = imported(operator)
        with person(station, Role.viewer, "Ana") as ana, person(station, Role.viewer, "Eva") as eva:
            job = start_export(ana, flight)
            refused = eva.delete(f"/jobs/{job}")
            assert (refused.status_code, refused.json()["code"]) == (403, "role_too_low")
            assert ana.delete(f"/jobs/{job}").is_success
            assert operator.delete(f"/jobs/{start_export(ana, flight)}").is_success


def imported(client: Any) -> str:
    answer = client.post("/flights", params={"name": "a.mcap"}, content=recording(20)).raise_for_status().json()
    eventually(lambda: client.get(f"/jobs/{answer['job']}").json()["state"] == "done", "it is imported")
    flight = str(client.get(f"/jobs/{answer['job']}").json()["flight"])
    eventually(lambda: client.get(f"/flights/{flight}").json()["state"] == "indexed", "it is indexed")
    return flight
