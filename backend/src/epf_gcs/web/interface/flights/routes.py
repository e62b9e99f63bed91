"""The library of flights: list, search, what people say of a flight, the bin, the room on the disk, imports."""

from __future__ import annotations

from collections.abc import AsyncIterator
from dataclasses import replace
from typing import Annotated, Final, Literal

from fastapi import APIRouter, Path, Query, Request
from starlette.requests import ClientDisconnect

from epf_gcs.contract.answers import DiskPolicy
from epf_gcs.contract.flights import Flight, FlightState
from epf_gcs.contract.shapes import file_body
from epf_gcs.errors import InvalidInputError
from epf_gcs.library.about import About
from epf_gcs.library.flights import Flights
from epf_gcs.library.folder import KEPT_S
from epf_gcs.library.imports import incomplete, most_import_bytes
from epf_gcs.library.library import Row
from epf_gcs.library.query import FlightQuery, Sort
from epf_gcs.recordings.places import ID_PATTERN
from epf_gcs.web.interface.deps import FlightsDep, HolderDep, ImportsDep, MirrorDep, OperatorDep
from epf_gcs.web.interface.flights.schemas import (
    DeletedFlight,
    FlightBin,
    FlightChange,
    FlightList,
    JobStart,
)
from epf_gcs.web.interface.flights.settings_schemas import (
    FlightAircraft,
    FlightAircraftInput,
    FlightDisk,
    FlightPolicy,
    FlightPolicyInput,
)
from epf_gcs.web.serving.problems import problems, reading_problems
from epf_gcs.web.vehicle.mirror import VehicleMirror

router = APIRouter(prefix="/flights", tags=["flights"])

UPLOAD_PATH: Final = "/flights"
# The fields of a flight that its summary has by the same names.
_FROM_SUMMARY: Final = (
    "board",
    "firmware",
    "station",
    "aircraft",
    "operator",
    "highest_ft",
    "fastest_kt",
    "distance_nm",
    "frames",
    "frames_damaged",
    "waypoints",
    "alarms",
    "thumbnail",
)

_MOST_UNNAMED: Final = 20

FlightId = Annotated[str, Path(pattern=ID_PATTERN, examples=["20260131T120000Z"])]
UnixTime = Annotated[float | None, Query(ge=0, le=1e11, description="Unix time in seconds.")]
FileName = Annotated[str, Query(min_length=1, max_length=255, description="The file's name, which becomes the title.")]


@router.get("", responses=reading_problems())
async def get_flights(
    flights: FlightsDep,
    mirror: MirrorDep,
    text: Annotated[str, Query(max_length=200, description="Words that all stand in what is said of it.")] = "",
    tag: Annotated[str | None, Query(max_length=40)] = None,
    board: Annotated[str | None, Query(max_length=200)] = None,
    aircraft: Annotated[str | None, Query(max_length=200)] = None,
    operator: Annotated[str | None, Query(max_length=200)] = None,
    from_s: UnixTime = None,
    to_s: UnixTime = None,
    sort: Sort = "started",
    order: Literal["asc", "desc"] = "desc",
    page: Annotated[int, Query(ge=1, le=1_000_000)] = 1,
    per_page: Annotated[int, Query(ge=1, le=500)] = 50,
) -> FlightList:
    """The library: one page of the flights that were asked for, newest first unless another order is."""
    wanted = FlightQuery(
        text=text,
        tag=tag,
        board=board,
        aircraft=aircraft,
        operator=operator,
        from_s=from_s,
        to_s=to_s,
        sort=sort,
        descending=order == "desc",
        first=(page - 1) * per_page,
        most=per_page,
    )
    rows, total = await flights.search(wanted)
    words = await flights.words()
    return FlightList(
        flights=[_flight(row, flights, mirror) for row in rows],
        total=total,
        tags=words.tags,
        boards=words.boards,
        all_aircraft=words.aircraft,
        operators=words.operators,
        unnamed=words.unnamed[:_MOST_UNNAMED],
        indexing=[job.told for job in flights.jobs.all() if job.kind in ("pack", "index") and not job.is_over],
        disk=await _disk(flights),
        aircraft=await flights.aircraft.now(),
    )


@router.get("/bin", responses=reading_problems())
async def get_flight_bin(flights: FlightsDep) -> FlightBin:
    """The flights that were deleted and can be restored."""
    found = [
        DeletedFlight(
            id=one.id,
            title=one.about.title,
            started_s=one.started_s,
            bytes=one.bytes,
            deleted_s=one.deleted_s,
            gone_s=one.deleted_s + KEPT_S,
        )
        for one in await flights.bin()
    ]
    return FlightBin(flights=found)


@router.put("/policy", responses=problems(409))
async def set_flight_policy(choice: FlightPolicyInput, flights: FlightsDep, _: OperatorDep) -> FlightDisk:
    """Choose what happens when the disk fills."""
    await flights.set_policy(DiskPolicy(choice.delete_oldest, choice.keep_free_bytes))
    return await _disk(flights)


@router.put("/aircraft", responses=problems(409))
async def set_flight_aircraft(named: FlightAircraftInput, flights: FlightsDep, _: OperatorDep) -> FlightAircraft:
    """Say what the aircraft is called: each recording has the name from now on, the one under way too."""
    return FlightAircraft(name=await flights.aircraft.choose(named.name))


@router.post(
    "",
    status_code=202,
    responses=problems(409),
    openapi_extra=file_body(),
)
async def import_flight(
    request: Request, imports: ImportsDep, name: FileName, holder: HolderDep, _: OperatorDep
) -> JobStart:
    """Take a recording of another machine, whole or not at all. The answer comes when all of it is there; the job that
    it names checks it then, and says under which id it is in the library, or why it is not."""
    length = request.headers.get("content-length", "")
    total_bytes = int(length) if length.isdecimal() else None
    job = await imports.receive(name, total_bytes, _chunks(request, name), holder)
    return JobStart(job=job.id)


@router.get("/{flight_id}", responses=reading_problems(404))
async def get_flight(flight_id: FlightId, flights: FlightsDep, mirror: MirrorDep) -> Flight:
    """One flight."""
    return _flight(await flights.get(flight_id), flights, mirror)


@router.patch("/{flight_id}", responses=problems(404, 409))
async def change_flight(flight_id: FlightId, change: FlightChange, flights: FlightsDep, mirror: MirrorDep) -> Flight:
    """Change title, tags, notes or whether it is pinned; what is left out stays."""
    given = {name: value for name, value in change.model_dump(exclude_unset=True).items() if value is not None}
    if "tags" in given:
        given["tags"] = sorted({tag.strip() for tag in given["tags"]} - {""})

    def changed(about: About) -> About:
        return replace(about, **given)

    return _flight(await flights.say(flight_id, changed), flights, mirror)


@router.delete("/{flight_id}", responses=problems(404, 409))
async def delete_flight(
    flight_id: FlightId,
    flights: FlightsDep,
    _: OperatorDep,
    confirm: Annotated[str, Query(max_length=64, description="The flight's id once more.")] = "",
) -> FlightBin:
    """Move a flight to the bin, from which it can be restored for 30 days."""
    if confirm != flight_id:
        raise InvalidInputError(
            "flight_delete_unconfirmed",
            f"Deleting asks for the id once more: add ?confirm={flight_id}.",
            flight=flight_id,
        )
    await flights.delete(flight_id)
    return await get_flight_bin(flights)


@router.post("/{flight_id}/restore", responses=problems(404, 409))
async def restore_flight(flight_id: FlightId, flights: FlightsDep, mirror: MirrorDep, _: OperatorDep) -> Flight:
    """Bring a flight back from the bin."""
    return _flight(await flights.restore(flight_id), flights, mirror)


@router.post("/{flight_id}/index", responses=problems(404, 409))
async def index_flight(flight_id: FlightId, flights: FlightsDep, mirror: MirrorDep) -> Flight:
    """Make all that is made of a recording again."""
    return _flight(await flights.index_again(flight_id), flights, mirror)


async def _chunks(request: Request, name: str) -> AsyncIterator[bytes]:
    try:
        async for chunk in request.stream():
            yield chunk
    except ClientDisconnect as error:
        raise incomplete(name) from error


async def _disk(flights: Flights) -> FlightDisk:
    policy = await flights.policy()
    free_bytes, hours_left = await flights.room()
    return FlightDisk(
        free_bytes=free_bytes,
        used_bytes=await flights.used_bytes(),
        most_import_bytes=most_import_bytes(free_bytes),
        hours_left=hours_left,
        policy=FlightPolicy(delete_oldest=policy.delete_oldest, keep_free_bytes=policy.keep_free_bytes),
    )


def _flight(row: Row, flights: Flights, mirror: VehicleMirror) -> Flight:
    active = row.id == flights.growing
    known, about = row.summary, row.about
    added = sum(not mark.recorded for mark in about.marks)
    hidden = sum(mark.hidden for mark in about.marks)
    return Flight(
        id=row.id,
        active=active,
        state=_state(row, flights, active=active),
        fault=row.fault,
        started_s=row.started_s,
        clock_ahead_s=known.clock_ahead_s if known else 0.0,
        clock_unsure=known.clock_unsure if known else False,
        duration_s=known.duration_ns * 1e-9 if known else None,
        bytes=mirror.status.recording.bytes if active else row.bytes,
        marks=known.marks + added - hidden if known else None,
        emulated=known.emulated if known else False,
        imported=about.imported,
        log=about.log,
        damage=" ".join(sentence for sentence in (about.came_damaged, known.damage if known else None) if sentence)
        or None,
        title=about.title,
        tags=about.tags,
        notes=about.notes,
        pinned=about.pinned,
        copies=row.copies,
        **{name: getattr(known, name, None) for name in _FROM_SUMMARY},
    )


def _state(row: Row, flights: Flights, *, active: bool) -> FlightState:
    if active:
        return "recording"
    if flights.preparing(row.id):
        return "indexing"
    if row.summary is not None:
        return "indexed"
    if row.fault is None:
        return "waiting"
    # Nothing is wrong with the file where the packages to look into it are missing.
    return "unread" if row.fault.code == "extra_missing" else "damaged"
