"""Google Earth: what is planned, the aircraft as they fly, and where to ask for all of it."""

from __future__ import annotations

from typing import Final, Literal

from fastapi import APIRouter, Request
from fastapi.responses import Response

from epf_gcs.bus.station_end import StationEnd
from epf_gcs.codec.tables import Waypoint
from epf_gcs.contract.requests import ReadPlan
from epf_gcs.contract.shapes import PlanName
from epf_gcs.formats import aircraft_model, kmz
from epf_gcs.formats.kml import MEDIA_TYPE
from epf_gcs.formats.kml_live import Link, NamedTrack, link_document, live_document
from epf_gcs.formats.kml_plan import write_kml
from epf_gcs.formats.kml_words import WORDS
from epf_gcs.track.track_lines import lines_of
from epf_gcs.web.interface.deps import ClockDep, MirrorDep, TracksDep, VehicleDep
from epf_gcs.web.interface.language import LanguageDep
from epf_gcs.web.interface.missions.file_routes import attachment
from epf_gcs.web.interface.track.routes import file_answer, model_bytes
from epf_gcs.web.serving.problems import reading_problems
from epf_gcs.web.vehicle.aircraft import Which, aircraft_now, followed_of

router = APIRouter(tags=["earth"])

# Refresh the aircraft and the last minute of its track each second, the whole track every ten seconds.
_LIVE_S: Final = 1
_TRACK_S: Final = 10
_EARTH_POINTS: Final = 5000
_TAIL_S: Final = 60.0
_TAIL_POINTS: Final = 300


@router.get("/plan.kml", response_class=Response, responses={**file_answer(MEDIA_TYPE), **reading_problems(409, 502)})
async def get_plan_kml(vehicle: VehicleDep, lang: LanguageDep, plan: PlanName = "flight") -> Response:
    """A plan as the board has it now."""
    name = WORDS[lang].hil_plan if plan == "hil" else WORDS[lang].plan
    data = write_kml(name, await _read(vehicle, plan))
    return Response(data, media_type=MEDIA_TYPE, headers={"Content-Disposition": attachment(name, "kml")})


@router.get(
    "/plan.kmz",
    response_class=Response,
    responses={**file_answer(kmz.MEDIA_TYPE), **reading_problems(409, 502)},
)
async def get_plan_kmz(vehicle: VehicleDep, lang: LanguageDep, plan: PlanName = "flight") -> Response:
    """The same, packed."""
    name = WORDS[lang].hil_plan if plan == "hil" else WORDS[lang].plan
    document = write_kml(name, await _read(vehicle, plan))
    data = b"".join(kmz.kmz_pieces([(kmz.DOCUMENT, [document])]))
    return Response(data, media_type=kmz.MEDIA_TYPE, headers={"Content-Disposition": attachment(name, "kmz")})


@router.get("/earth.kml", response_class=Response, responses=file_answer(MEDIA_TYPE))
async def get_earth_kml(
    request: Request,
    mirror: MirrorDep,
    lang: LanguageDep,
    follow: Which | None = None,
    camera: Literal["follow", "free"] = "follow",
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
    if mirror.status.board.features.missions:
        # Loaded once and not refreshed, for each load is a transfer over the board's line.
        links += [
            Link(words.plan, f"{base}/plan.kml?plan=flight&lang={lang}", None),
            Link(words.hil_plan, f"{base}/plan.kml?plan=hil&lang={lang}", None),
        ]
    headers = {"Content-Disposition": attachment("EPF GCS", "kml")}
    return Response(link_document(words.station, links), media_type=MEDIA_TYPE, headers=headers)


@router.get("/earth/live.kml", response_class=Response, responses=file_answer(MEDIA_TYPE))
async def get_live_kml(
    request: Request,
    mirror: MirrorDep,
    flown: TracksDep,
    clock: ClockDep,
    lang: LanguageDep,
    follow: Which | None = None,
) -> Response:
    """The aircraft with their attitude, the view, and the last minute of the tracks."""
    words = WORDS[lang]
    since_s = clock.now_s() - _TAIL_S
    pair = flown.now
    tracks = [
        NamedTrack(name, [line.positions() for line in lines_of(track, _TAIL_POINTS, since_s)])
        for name, track in ((words.track, pair.flight), (words.hil_track, pair.hil))
    ]
    found = aircraft_now(mirror, words)
    model_url = f"{_base(request)}/earth/aircraft.dae"
    pieces = live_document(words.station, list(found.values()), followed_of(mirror, found, follow), tracks, model_url)
    return Response(b"".join(pieces), media_type=MEDIA_TYPE)


@router.get(
    "/earth/aircraft.dae",
    response_class=Response,
    responses=file_answer(aircraft_model.MEDIA_TYPE),
)
async def get_aircraftmodel_bytes() -> Response:
    """The aircraft's shape."""
    return Response(model_bytes(), media_type=aircraft_model.MEDIA_TYPE, headers={"Cache-Control": "max-age=3600"})


async def _read(vehicle: StationEnd, plan: PlanName) -> list[Waypoint]:
    return await vehicle.ask(ReadPlan(plan))


def _base(request: Request) -> str:
    """The base URL for Google Earth, taken from this request's Host."""
    return f"{str(request.base_url).rstrip('/')}/api/v1"
