"""Google Earth: what was flown, what is planned, and the aircraft as they fly. Clearing the track, and undoing it."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Iterator
from functools import cache
from typing import Annotated, Any, Final, Literal

from fastapi import APIRouter, Query, Request
from fastapi.responses import Response, StreamingResponse

from gateway.api.deps import OperatorDep, StationDep
from gateway.api.errors import problems, reading_problems
from gateway.api.mission_files import attachment
from gateway.api.schemas import PlanName
from gateway.api.track_schemas import TrackState
from gateway.formats import aircraft_model
from gateway.formats.kml import MEDIA_TYPE
from gateway.formats.kml_live import Link, NamedTrack, link_document, live_document, track_document
from gateway.formats.kml_plan import write_kml
from gateway.formats.kml_words import WORDS, Language
from gateway.services.aircraft import Which, aircraft_now, followed_of
from gateway.vehicle.track import MAX_POINTS, Track

router = APIRouter(tags=["earth"])

# The aircraft moves each second; its whole track is drawn again now and then, and the last minute with it.
_LIVE_S: Final = 1
_TRACK_S: Final = 10
_EARTH_POINTS: Final = 5000
_TAIL_S: Final = 60.0
_TAIL_POINTS: Final = 300

_KML: Final[dict[int | str, dict[str, Any]]] = {
    200: {"content": {MEDIA_TYPE: {"schema": {"type": "string", "format": "binary"}}}}
}
Lang = Annotated[Language, Query(description="Language of the names in the file.")]
MostPoints = Annotated[
    int | None, Query(ge=2, le=MAX_POINTS, description="Leave points out evenly so that about this many remain.")
]


@cache
def _model() -> bytes:
    return aircraft_model.aircraft_dae()


@router.get("/track.kml", response_class=Response, responses={**_KML, **reading_problems()})
async def get_track_kml(station: StationDep, points: MostPoints = None, lang: Lang = "es") -> Response:
    """The flown tracks, real and HIL, with their curtains."""
    words = WORDS[lang]
    pair = station.tracks.now
    tracks = [
        NamedTrack(words.track, _lines(pair.real, points)),
        NamedTrack(words.hil_track, _lines(pair.hil, points)),
    ]
    headers = {"Content-Disposition": attachment(words.track, "kml")}
    return _streamed(track_document(f"{words.station}: {words.track}", tracks), headers)


@router.get("/plan.kml", response_class=Response, responses={**_KML, **reading_problems(409, 502)})
async def get_plan_kml(station: StationDep, plan: PlanName = "flight", lang: Lang = "es") -> Response:
    """A plan as the board has it now."""
    name = WORDS[lang].hil_plan if plan == "hil" else WORDS[lang].plan
    data = write_kml(name, await station.missions.read(plan))
    return Response(data, media_type=MEDIA_TYPE, headers={"Content-Disposition": attachment(name, "kml")})


@router.get("/earth.kml", response_class=Response, responses={**_KML, **reading_problems()})
async def get_earth_kml(
    request: Request,
    station: StationDep,
    follow: Which | None = None,
    camera: Literal["follow", "free"] = "follow",
    lang: Lang = "es",
) -> Response:
    """What a user opens in Google Earth: links to the aircraft (each second), the track and the plans.

    `follow` names the aircraft that the view stays behind; by default the HIL aircraft while a simulator flies.
    """
    words = WORDS[lang]
    base = _base(request)
    chosen = "" if follow is None else f"&follow={follow}"
    links = [
        Link(words.aircraft, f"{base}/earth/live.kml?lang={lang}{chosen}", _LIVE_S, moves_view=camera == "follow"),
        Link(words.track, f"{base}/track.kml?lang={lang}&points={_EARTH_POINTS}", _TRACK_S),
    ]
    if station.board.capabilities().get("has_missions"):
        # Asked for once: each time is a transfer over the board's line.
        links += [
            Link(words.plan, f"{base}/plan.kml?plan=flight&lang={lang}", None),
            Link(words.hil_plan, f"{base}/plan.kml?plan=hil&lang={lang}", None),
        ]
    headers = {"Content-Disposition": attachment("EPF GCS", "kml")}
    return Response(link_document(words.station, links), media_type=MEDIA_TYPE, headers=headers)


@router.get("/earth/live.kml", response_class=Response, responses={**_KML, **reading_problems()})
async def get_live_kml(
    request: Request, station: StationDep, follow: Which | None = None, lang: Lang = "es"
) -> Response:
    """The aircraft with their attitude, the view, and the last minute of the tracks."""
    words = WORDS[lang]
    since_s = station.clock.now_s() - _TAIL_S
    pair = station.tracks.now
    tracks = [
        NamedTrack(words.track, _lines(pair.real, _TAIL_POINTS, since_s)),
        NamedTrack(words.hil_track, _lines(pair.hil, _TAIL_POINTS, since_s)),
    ]
    found = aircraft_now(station, words)
    model_url = f"{_base(request)}/earth/aircraft.dae"
    pieces = live_document(words.station, list(found.values()), followed_of(station, found, follow), tracks, model_url)
    return Response(b"".join(pieces), media_type=MEDIA_TYPE)


@router.get(
    "/earth/aircraft.dae",
    response_class=Response,
    responses={
        200: {"content": {aircraft_model.MEDIA_TYPE: {"schema": {"type": "string", "format": "binary"}}}},
        **reading_problems(),
    },
)
async def get_aircraft_model() -> Response:
    """The aircraft's shape."""
    return Response(_model(), media_type=aircraft_model.MEDIA_TYPE, headers={"Cache-Control": "max-age=3600"})


@router.get("/track", responses=reading_problems())
async def get_track(station: StationDep) -> TrackState:
    """How long the drawn tracks are."""
    return TrackState(**station.tracks.as_dict())


@router.post("/track/reset", responses=problems(409))
async def reset_track(station: StationDep, _: OperatorDep) -> TrackState:
    """Clear the drawn tracks; what is recorded stays."""
    station.tracks.reset()
    return TrackState(**station.tracks.as_dict())


@router.post("/track/restore", responses=problems(409))
async def restore_track(station: StationDep, _: OperatorDep) -> TrackState:
    """Bring the track back that was cleared last, before what was flown since."""
    station.tracks.restore()
    return TrackState(**station.tracks.as_dict())


def _lines(track: Track, most_points: int | None, since_s: float | None = None) -> list[Iterator[Any]]:
    pieces = track.pieces(most_points) if since_s is None else track.pieces(most_points, since_s)
    return [track.points(piece) for piece in pieces]


def _streamed(pieces: Iterator[bytes], headers: dict[str, str]) -> StreamingResponse:
    async def send() -> AsyncIterator[bytes]:
        for piece in pieces:
            yield piece
            # An hour's track is half a second of work: board and simulator come between.
            await asyncio.sleep(0)

    return StreamingResponse(send(), media_type=MEDIA_TYPE, headers=headers)


def _base(request: Request) -> str:
    """The address that Google Earth can ask, as this request's own Host names it."""
    return f"{str(request.base_url).rstrip('/')}/api/v1"
