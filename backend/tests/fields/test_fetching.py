"""What is said of a source that gives nothing now."""

from __future__ import annotations

import asyncio

import httpx
import pytest

from epf_gcs.errors import GatewayError
from epf_gcs.fields.fetching import Fetcher, Pace
from epf_gcs.fields.order import Part, Place


async def first_told(failure: Exception) -> GatewayError:
    """The first problem of a source whose every request fails so."""
    told: asyncio.Future[GatewayError] = asyncio.get_running_loop().create_future()

    def refuse(_request: httpx.Request) -> httpx.Response:
        raise failure

    def waits(problem: GatewayError | None, _pause_s: float) -> None:
        if problem is not None and not told.done():
            told.set_result(problem)

    part = Part("imagery", "PNOA", "https://maps.example/{z}/{x}/{y}.jpg", "IGN", 1, 2)
    async with httpx.AsyncClient(transport=httpx.MockTransport(refuse)) as client:
        fetcher = Fetcher(part, client, lambda _place, _data: None, waits, Pace(first_pause_s=60.0))
        work = asyncio.create_task(fetcher.fetch(iter([Place(1, 0, 0)])))
        problem = await told
        work.cancel()
        await asyncio.gather(work, return_exceptions=True)
    return problem


@pytest.mark.parametrize(
    ("failure", "code"),
    [
        (httpx.ConnectError("no route"), "field_source_unreachable"),
        (OSError("network is unreachable"), "field_source_unreachable"),
        (httpx.ReadTimeout("late"), "field_source_silent"),
        (httpx.RemoteProtocolError("cut"), "field_source_silent"),
    ],
)
def test_without_a_way_to_the_source_the_internet_is_named(failure: Exception, code: str) -> None:
    problem = asyncio.run(first_told(failure))
    assert problem.code == code
    assert ("internet" in problem.detail) == (code == "field_source_unreachable")
