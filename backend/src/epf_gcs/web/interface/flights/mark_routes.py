"""Marks: set now in the flight that is being recorded, or later at a moment of a finished one."""

from __future__ import annotations

import secrets
from typing import Annotated

import msgspec
from fastapi import APIRouter, Path

from epf_gcs.contract.flight_questions import EventsQuestion, SpanQuestion
from epf_gcs.contract.flights import FlightEvents, FlightTimes
from epf_gcs.contract.requests import SetMark
from epf_gcs.errors import InvalidInputError
from epf_gcs.library import marks
from epf_gcs.library.about import KeptMark
from epf_gcs.library.flights import Flights
from epf_gcs.library.queries import Queries
from epf_gcs.web.interface.deps import AskerDep, FlightsDep, HolderDep, MarkSharesDep, QueriesDep, VehicleDep
from epf_gcs.web.interface.flights.data_routes import FlightName, which
from epf_gcs.web.interface.flights.schemas import MarkAtInput, MarkInput
from epf_gcs.web.serving.problems import problems

router = APIRouter(prefix="/flights", tags=["flights"])

MarkId = Annotated[str, Path(min_length=1, max_length=64)]


@router.post("/{flight_id}/marks", responses=problems(404, 409))
async def set_mark(
    flight_id: FlightName,
    mark: MarkAtInput,
    flights: FlightsDep,
    queries: QueriesDep,
    vehicle: VehicleDep,
    asker: AskerDep,
    holder: HolderDep,
    shares: MarkSharesDep,
) -> FlightEvents:
    """Set a mark: now, into the flight that is being recorded, or with `at_s` at a moment of any flight, whose
    recording stays as it is. Answers with all events."""
    flight, growing = await which(flight_id, flights)
    if mark.at_s is None and not growing:
        raise InvalidInputError(
            "invalid_request", "A mark in a finished flight needs its moment: send 'at_s'.", field="at_s"
        )
    with shares.one_more(flight, holder):
        if mark.at_s is None:
            mark_id = (await vehicle.ask(SetMark(mark.text, asker.name, mark.ago_s), asker)).id
        else:
            mark_id = secrets.token_hex(6)
            times = msgspec.json.decode(await queries.ask(SpanQuestion(flight, growing)), type=FlightTimes)
            kept = KeptMark(mark_id, mark.text, times.start_s + mark.at_s, mark.at_s, asker.name)
            await flights.say(flight, lambda about: marks.add(about, kept))
        shares.note(flight, holder, mark_id)
    events = await _events(flight, flights, queries)
    shares.look(flight, events)
    return events


@router.patch("/{flight_id}/marks/{mark_id}", responses=problems(404, 409))
async def change_mark(
    flight_id: FlightName, mark_id: MarkId, mark: MarkInput, flights: FlightsDep, queries: QueriesDep
) -> FlightEvents:
    """Change the words of a mark. Answers with all events."""
    return await _change(flight_id, mark_id, mark.text, flights, queries)


@router.delete("/{flight_id}/marks/{mark_id}", responses=problems(404, 409))
async def remove_mark(
    flight_id: FlightName, mark_id: MarkId, flights: FlightsDep, queries: QueriesDep, shares: MarkSharesDep
) -> FlightEvents:
    """Remove a mark; one that stands in the recording is not shown any more. Answers with all events."""
    events = await _change(flight_id, mark_id, None, flights, queries)
    flight, _ = await which(flight_id, flights)
    shares.forget(flight, mark_id)
    shares.look(flight, events)
    return events


async def _change(flight_id: str, mark_id: str, text: str | None, flights: Flights, queries: Queries) -> FlightEvents:
    flight, _ = await which(flight_id, flights)
    marks.check(await _events(flight, flights, queries), mark_id)
    await flights.say(flight, lambda about: marks.change(about, mark_id, text))
    return await _events(flight, flights, queries)


async def _events(flight: str, flights: Flights, queries: Queries) -> FlightEvents:
    body = await queries.ask(EventsQuestion(flight, flight == flights.growing))
    return marks.with_marks(body, (await flights.get(flight)).about)
