"""The message inspector: everything that goes over the lines, and advice."""

from __future__ import annotations

from typing import Literal

from fastapi import APIRouter, Response

from epf_gcs.contract.shapes import Output, ParamValue
from epf_gcs.vehicle.advice import Code
from epf_gcs.web.interface.deps import InspectorDep
from epf_gcs.web.interface.state.schemas import RoundTripMs
from epf_gcs.web.serving.problems import reading_problems

router = APIRouter(tags=["inspector"])


class InspectedFrame(Output):
    """One type of frame from the board, heard or not. `jitter_ms` is the standard deviation of the intervals.

    A type that this gateway does not know is named `unknown_0x…` and has no values.
    """

    id: int
    name: str
    count: int
    rate_hz: float
    jitter_ms: float | None
    damaged: int
    age_s: float | None
    stale_after_s: float | None
    values: dict[str, float | int | bool | str | None] | None


class InspectedRow(Output):
    """One row of the simulator; `expected` ones are what the HIL loop needs. A row that we do not know is `row_n`."""

    row: int
    name: str
    expected: bool
    count: int
    rate_hz: float
    jitter_ms: float | None
    age_s: float | None
    values: list[float | None] | None


class InspectedLink(Output):
    """What the lines carry against what they can; null while no board's link is open, and 73,000 for the simulator.

    A recording does not tell the round trips: null.
    """

    rx_bytes_per_s: float
    tx_bytes_per_s: float
    capacity_bytes_per_s: float | None
    rx_percent: float | None
    tx_percent: float | None
    simulator_bytes_per_s: float
    simulator_percent: float
    round_trip_ms: RoundTripMs
    round_trips: int | None


class AdviceState(Output):
    """Something to do about what does not go well."""

    code: Code
    level: Literal["info", "warning"]
    text: str
    params: dict[str, ParamValue]


class Inspector(Output):
    """All of it now; made to be asked for some times a second."""

    t_s: float
    board: list[InspectedFrame]
    rows: list[InspectedRow]
    link: InspectedLink
    advice: list[AdviceState]


@router.get("/inspector", response_model=Inspector, responses=reading_problems(409))
async def get_inspector(inspector: InspectorDep) -> Response:
    """Every type of frame and row with rate, jitter, count and last values; the load of the lines; and advice."""
    return Response(await inspector.text(), media_type="application/json")
