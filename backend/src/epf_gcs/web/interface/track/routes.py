"""The flown tracks: their points for the page, as files for other programs, cleared and brought back."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import cache
from typing import Annotated, Final

from fastapi import APIRouter, Query
from fastapi.responses import Response, StreamingResponse

from epf_gcs.contract.answers import TrackState
from epf_gcs.contract.shapes import FILE, Answers
from epf_gcs.formats import aircraft_model, czml, gpx_track, kml, kmz
from epf_gcs.formats.czml import MovingTrack, czml_pieces
from epf_gcs.formats.gpx_track import TimedTrack, gpx_track_pieces
from epf_gcs.formats.kml_live import Aircraft, NamedTrack, track_document
from epf_gcs.formats.kml_words import WORDS, Words
from epf_gcs.formats.kmz import kmz_pieces
from epf_gcs.formats.track_points import HEADER_BYTES, MEDIA_TYPE, points_header
from epf_gcs.track.track import MAX_POINTS, POINT
from epf_gcs.track.track_lines import Line, lines_of
from epf_gcs.track.tracks import Tracks
from epf_gcs.web.interface.deps import OperatorDep, TracksDep
from epf_gcs.web.interface.language import LanguageDep
from epf_gcs.web.interface.missions.file_routes import attachment
from epf_gcs.web.serving.problems import problems, reading_problems
from epf_gcs.web.vehicle.aircraft import Which

router = APIRouter(tags=["track"])

# Size of each piece of the answer: each costs a turn of the event loop and is made in a thread.
_PIECE_BYTES: Final = 65536
_MODEL_IN_KMZ: Final = "models/aircraft.dae"
_FLIGHT_COLOUR: Final = (255, 255, 0, 255)
_HIL_COLOUR: Final = (0, 229, 255, 255)

MostPoints = Annotated[
    int | None, Query(ge=2, le=MAX_POINTS, description="Leave points out evenly so that about this many remain.")
]
Index = Annotated[int, Query(ge=0, le=0xFFFFFFFF)]


def file_answer(media_type: str) -> Answers:
    """Documentation of an answer that is a file."""
    return {200: {"content": {media_type: FILE}}, **reading_problems()}


@cache
def model_bytes() -> bytes:
    """The aircraft's shape, as Google Earth takes it."""
    return aircraft_model.aircraft_dae()


@router.get("/track/points", response_class=Response, responses=file_answer(MEDIA_TYPE))
async def get_track_points(
    tracks: TracksDep,
    source: Which = "hil",
    after: Annotated[Index, Query(description="How many points the caller has already.")] = 0,
    epoch: Annotated[Index | None, Query(description="The epoch of the answer from which it has them.")] = None,
) -> StreamingResponse:
    """Every point of a track from index `after` on, little endian.

    Header of 32 bytes: `EPT1`, u32 epoch, u32 index of the first point, u32 count, u32 total, u32 0, f64 Unix time t0.
    Then `count` records of 16: u32 ms since t0, i32 latitude and i32 longitude in 1e-7 deg, i32 altitude in mm above
    mean sea level. Where the epoch is another than the caller's, or `after` is beyond the end, all points come.
    """
    pair = tracks.now
    track = pair.flight if source == "flight" else pair.hil
    total = len(track)
    first = after if after <= total and epoch in (None, track.epoch) else 0
    header = points_header(epoch=track.epoch, first=first, count=total - first, total=total, t0_s=track.t0_s)
    # Blocks are immutable: the answer is the track as of now, even if it grows while it is sent.
    pieces = [header, *(block.points for block in track.blocks(first))]
    length = HEADER_BYTES + (total - first) * POINT.itemsize
    return StreamingResponse(iter(pieces), media_type=MEDIA_TYPE, headers={"Content-Length": str(length)})


@router.get("/track.kml", response_class=Response, responses=file_answer(kml.MEDIA_TYPE))
async def get_track_kml(flown: TracksDep, lang: LanguageDep, points: MostPoints = None) -> StreamingResponse:
    """The flown tracks, real and HIL, with their curtains: every point, unless fewer are asked for."""
    words = WORDS[lang]
    tracks = [_drawn(name, lines) for name, lines in _named(flown, words, points)]
    return _streamed(track_document(_title(words), tracks), kml.MEDIA_TYPE, words.track, "kml")


@router.get("/track.kmz", response_class=Response, responses=file_answer(kmz.MEDIA_TYPE))
async def get_track_kmz(flown: TracksDep, lang: LanguageDep, points: MostPoints = None) -> StreamingResponse:
    """The same in one packed file with the aircraft's model, which stands where each track ends."""
    words = WORDS[lang]
    named = _named(flown, words, points)
    tracks = [_drawn(name, lines) for name, lines in named]
    shown = (words.aircraft, words.hil_aircraft)
    aircraft = [_at_the_end(name, lines[-1]) for name, (_, lines) in zip(shown, named, strict=True) if lines]
    document = track_document(_title(words), tracks, aircraft, _MODEL_IN_KMZ)
    pieces = kmz_pieces([(kmz.DOCUMENT, document), (_MODEL_IN_KMZ, [model_bytes()])])
    return _streamed(pieces, kmz.MEDIA_TYPE, words.track, "kmz")


@router.get("/track.gpx", response_class=Response, responses=file_answer(gpx_track.MEDIA_TYPE))
async def get_track_gpx(flown: TracksDep, lang: LanguageDep, points: MostPoints = None) -> StreamingResponse:
    """The flown tracks as GPX 1.1, with the time of every point."""
    words = WORDS[lang]
    tracks = [TimedTrack(name, lines) for name, lines in _named(flown, words, points)]
    return _streamed(gpx_track_pieces(tracks), gpx_track.MEDIA_TYPE, words.track, "gpx")


@router.get(
    "/track.czml",
    response_class=Response,
    responses={
        200: {"content": {czml.MEDIA_TYPE: {"schema": {"type": "array", "items": {"type": "object"}}}}},
        **reading_problems(),
    },
)
async def get_track_czml(flown: TracksDep, lang: LanguageDep, points: MostPoints = None) -> StreamingResponse:
    """The flown tracks as CZML: place and time of every point, and the attitude where it was live."""
    words = WORDS[lang]
    ids = (("flight", _FLIGHT_COLOUR), ("hil", _HIL_COLOUR))
    tracks = [
        MovingTrack(which, name, colour, [line.span_s() for line in lines], lines)
        for (which, colour), (name, lines) in zip(ids, _named(flown, words, points), strict=True)
    ]
    return _streamed(czml_pieces(_title(words), tracks), czml.MEDIA_TYPE, words.track, "czml")


@router.get("/track", responses=reading_problems())
async def get_track(tracks: TracksDep) -> TrackState:
    """How long the drawn tracks are."""
    return tracks.state


@router.post("/track/reset", responses=problems(409))
async def reset_track(tracks: TracksDep, _: OperatorDep) -> TrackState:
    """Clear the drawn tracks; what is recorded stays."""
    tracks.reset()
    return tracks.state


@router.post("/track/restore", responses=problems(409))
async def restore_track(tracks: TracksDep, _: OperatorDep) -> TrackState:
    """Bring the track back that was cleared last, before what was flown since."""
    tracks.restore()
    return tracks.state


def _named(tracks: Tracks, words: Words, most_points: int | None) -> list[tuple[str, list[Line]]]:
    pair = tracks.now
    return [(words.track, lines_of(pair.flight, most_points)), (words.hil_track, lines_of(pair.hil, most_points))]


def _drawn(name: str, lines: Sequence[Line]) -> NamedTrack:
    return NamedTrack(name, [line.positions() for line in lines])


def _at_the_end(name: str, line: Line) -> Aircraft:
    """The aircraft at the end of the line, with its attitude there if known."""
    last = line.last()
    place = (float(last.latitude_deg[0]), float(last.longitude_deg[0]), float(last.altitude_m[0]))
    heading_deg, pitch_deg, roll_deg = (float(one[0]) for one in (last.heading_deg, last.pitch_deg, last.roll_deg))
    return Aircraft(name, place) if math.isnan(heading_deg) else Aircraft(name, place, heading_deg, pitch_deg, roll_deg)


def _title(words: Words) -> str:
    return f"{words.station}: {words.track}"


def _streamed(pieces: Iterator[bytes], media_type: str, name: str, extension: str) -> StreamingResponse:
    """A file generated while it is sent. Each piece is made in a thread, so that the event loop does not wait."""
    headers = {"Content-Disposition": attachment(name, extension)}
    return StreamingResponse(_gathered(pieces), media_type=media_type, headers=headers)


def _gathered(pieces: Iterator[bytes]) -> Iterator[bytes]:
    held = bytearray()
    for piece in pieces:
        held += piece
        if len(held) >= _PIECE_BYTES:
            yield bytes(held)
            held.clear()
    yield bytes(held)
