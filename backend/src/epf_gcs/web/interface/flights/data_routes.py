"""What is in a flight: events, signals, topics, overview, track, and what was known at a moment.

`current` is the flight that is being recorded, as far as it is.
"""

from __future__ import annotations

from typing import Annotated, Final, Literal

import orjson
from fastapi import APIRouter, Path, Query, Request
from fastapi.responses import Response

from epf_gcs.contract.flight_knowledge import FlightKnowledge
from epf_gcs.contract.flight_questions import (
    EventsQuestion,
    KnownQuestion,
    OverviewQuestion,
    SignalsQuestion,
    TopicsQuestion,
    TrackQuestion,
)
from epf_gcs.contract.flights import FlightEvents, FlightOverview, FlightTopics, Signals
from epf_gcs.contract.shapes import FILE
from epf_gcs.errors import NotFoundError
from epf_gcs.formats.track_points import MEDIA_TYPE
from epf_gcs.library.flights import Flights
from epf_gcs.library.folder import unknown
from epf_gcs.library.marks import with_marks
from epf_gcs.web.interface.deps import FlightsDep, QueriesDep
from epf_gcs.web.serving.problems import reading_problems

router = APIRouter(prefix="/flights", tags=["flights"])

ARROW: Final = "application/vnd.apache.arrow.stream"
_JSON: Final = "application/json"
_MOST_NAMES: Final = 32
_RECORDED: Final = r"[A-Za-z0-9_]+\.[A-Za-z0-9_]+"
_SIGNAL: Final = rf"({_RECORDED}|rate\({_RECORDED}\)|(diff|error)\({_RECORDED},{_RECORDED}\))"
_NAMES: Final = rf"^{_SIGNAL}(,{_SIGNAL}){{0,{_MOST_NAMES - 1}}}$"

FlightName = Annotated[
    str,
    Path(pattern=r"^(current|[0-9]{8}T[0-9]{6}Z(-[0-9]{1,4})?)$", examples=["20260131T120000Z"]),
]
AtS = Annotated[float | None, Query(ge=0, le=10_000_000, description="Seconds since the flight's start.")]


@router.get(
    "/{flight_id}/events",
    response_class=Response,
    responses={200: {"model": FlightEvents}, **reading_problems(404, 409)},
)
async def get_flight_events(flight_id: FlightName, flights: FlightsDep, queries: QueriesDep) -> Response:
    """Commands with their outcome, alarms, modes, waypoints passed, marks, gaps and damage, in order of time."""
    flight, growing = await which(flight_id, flights)
    body = await queries.ask(EventsQuestion(flight, growing))
    about = (await flights.get(flight)).about
    if about.marks:
        body = orjson.dumps(with_marks(body, about))
    return Response(body, media_type=_JSON)


@router.get(
    "/{flight_id}/signals",
    response_class=Response,
    responses={200: {"model": Signals, "content": {ARROW: FILE}}, **reading_problems(404, 409)},
)
async def get_flight_signals(
    request: Request,
    flight_id: FlightName,
    flights: FlightsDep,
    queries: QueriesDep,
    names: Annotated[
        str,
        Query(
            min_length=1,
            max_length=2000,
            pattern=_NAMES,
            description=f"Up to {_MOST_NAMES} signals, separated by commas: topic.field, rate(topic.field) for the "
            "change in a second, diff(topic.field,topic.field) for the first less the second, or "
            "error(topic.field,topic.field) for the second, a target, less the first.",
            examples=["ahrs.roll_deg,rate(gps.speed_kt)"],
        ),
    ],
    from_s: AtS = None,
    to_s: AtS = None,
    points: Annotated[int, Query(ge=10, le=20_000)] = 2000,
) -> Response:
    """Signals, thinned to `points` steps so that no extreme is lost. With `Accept: application/vnd.apache.arrow.stream`
    an Arrow stream with the columns name, at_s, min and max."""
    flight, growing = await which(flight_id, flights)
    arrow = ARROW in request.headers.get("accept", "")
    body = await queries.ask(SignalsQuestion(flight, growing, names, from_s, to_s, points, arrow))
    return Response(body, media_type=ARROW if arrow else _JSON)


@router.get(
    "/{flight_id}/topics",
    response_class=Response,
    responses={200: {"model": FlightTopics}, **reading_problems(404, 409)},
)
async def get_flight_topics(flight_id: FlightName, flights: FlightsDep, queries: QueriesDep) -> Response:
    """The topics that the flight has, with their fields and units."""
    flight, growing = await which(flight_id, flights)
    return Response(await queries.ask(TopicsQuestion(flight, growing)), media_type=_JSON)


@router.get(
    "/{flight_id}/overview",
    response_class=Response,
    responses={200: {"model": FlightOverview}, **reading_problems(404, 409)},
)
async def get_flight_overview(
    flight_id: FlightName,
    flights: FlightsDep,
    queries: QueriesDep,
    points: Annotated[int, Query(ge=10, le=10_000)] = 1000,
) -> Response:
    """The ground of the time bar: altitude at even steps, and gaps."""
    flight, growing = await which(flight_id, flights)
    return Response(await queries.ask(OverviewQuestion(flight, growing, points)), media_type=_JSON)


@router.get(
    "/{flight_id}/track",
    response_class=Response,
    responses={200: {"content": {MEDIA_TYPE: FILE}}, **reading_problems(404, 409)},
)
async def get_flight_track(
    flight_id: FlightName,
    flights: FlightsDep,
    queries: QueriesDep,
    source: Literal["flight", "hil"] = "hil",
    points: Annotated[int | None, Query(ge=2, le=720_000, description="At most about this many, evenly.")] = None,
) -> Response:
    """The flown track, in the form of /track/points; without points where there is none."""
    flight, growing = await which(flight_id, flights)
    body = await queries.ask(TrackQuestion(flight, growing, source, points))
    return Response(body, media_type=MEDIA_TYPE)


@router.get(
    "/{flight_id}/known",
    response_class=Response,
    responses={200: {"model": FlightKnowledge}, **reading_problems(404, 409)},
)
async def get_flight_known(
    flight_id: FlightName,
    flights: FlightsDep,
    queries: QueriesDep,
    at_s: Annotated[float, Query(ge=0, le=10_000_000, description="Seconds since the flight's start.")] = 0.0,
) -> Response:
    """Identity, gains and plans as they were known at that moment."""
    flight, growing = await which(flight_id, flights)
    return Response(await queries.ask(KnownQuestion(flight, growing, at_s)), media_type=_JSON)


async def which(flight_id: str, flights: Flights) -> tuple[str, bool]:
    """The id of the flight that is meant, and whether it is being recorded. Raises NotFoundError."""
    growing = flights.growing
    if flight_id == "current":
        if growing is None:
            raise NotFoundError("flight_unknown", "No flight is being recorded now.", flight=flight_id)
        return growing, True
    if flight_id == growing:
        return flight_id, True
    if not await flights.in_thread(flights.places.recording(flight_id).exists):
        raise unknown(flight_id)
    return flight_id, False
