"""FastAPI dependencies: each gives a route one part of the station.

All that are called for a request are coroutines: FastAPI calls plain functions in threads, and the parts belong to the
event loop.
"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

from fastapi import Depends, Header, Request

from epf_gcs.access.admission import Admission
from epf_gcs.access.caller import Caller, Credentials
from epf_gcs.access.control import Control
from epf_gcs.access.limits import holder_of
from epf_gcs.access.roles import Role
from epf_gcs.beacons.listener import BeaconListener
from epf_gcs.bus.definition import Asker
from epf_gcs.bus.station_end import StationEnd
from epf_gcs.clock import Clock
from epf_gcs.fields.fields import Fields
from epf_gcs.library.flights import Flights
from epf_gcs.library.imports import FlightImports
from epf_gcs.library.mark_shares import MarkShares
from epf_gcs.library.queries import Queries
from epf_gcs.maps.maps import Maps
from epf_gcs.rehearsal.rehearsals import Rehearsals
from epf_gcs.shares.holder import Holder
from epf_gcs.surroundings.watch import Surroundings
from epf_gcs.track.tracks import Tracks
from epf_gcs.web.checklist.checklist_store import KeptChecklist
from epf_gcs.web.serving.guard import admitted
from epf_gcs.web.setup.doctor import Doctor
from epf_gcs.web.setup.first_start import FirstStart
from epf_gcs.web.state.whole import WholeStatus
from epf_gcs.web.stream.hub import Hub
from epf_gcs.web.vehicle.mirror import VehicleMirror
from epf_gcs.web.vehicle.shared_inspector import SharedInspector


def _part(name: str) -> Any:
    """The part that the application's state holds under this name (`Station.parts`)."""

    async def get(request: Request) -> Any:
        return getattr(request.app.state, name)

    return Depends(get)


VehicleDep = Annotated[StationEnd, _part("vehicle")]
"""The connection to the flight process, for requests."""
MirrorDep = Annotated[VehicleMirror, _part("mirror")]
"""The newest samples and status from the flight process."""
StatusDep = Annotated[WholeStatus, _part("status")]
ControlDep = Annotated[Control, _part("control")]
TracksDep = Annotated[Tracks, _part("tracks")]
FieldsDep = Annotated[Fields, _part("fields")]
MapsDep = Annotated[Maps, _part("maps")]
FlightsDep = Annotated[Flights, _part("flights")]
QueriesDep = Annotated[Queries, _part("flight_queries")]
"""Questions about what is in a flight."""
ImportsDep = Annotated[FlightImports, _part("flight_imports")]
"""Recordings that come from other machines."""
MarkSharesDep = Annotated[MarkShares, _part("mark_shares")]
"""How many marks a caller may set."""
InspectorDep = Annotated[SharedInspector, _part("inspector")]
RecordingsDirDep = Annotated[Path, _part("recordings_dir")]
ChecklistDep = Annotated[KeptChecklist, _part("checklist")]
RehearsalsDep = Annotated[Rehearsals, _part("rehearsals")]
"""Flies plans in a model before they are sent."""
BeaconsDep = Annotated[BeaconListener, _part("beacons")]
"""The X-Planes on this computer's networks."""
SurroundingsDep = Annotated[Surroundings, _part("surroundings")]
FirstStartDep = Annotated[FirstStart, _part("first_start")]
DoctorDep = Annotated[Doctor, _part("doctor")]
"""Looks at this computer in a process of its own."""
HubDep = Annotated[Hub, _part("hub")]
"""Tells all viewers."""
ClockDep = Annotated[Clock, _part("clock")]
"""The flight's clock."""
AdmissionDep = Annotated[Admission, _part("admission")]


def caller_of(request: Request) -> Caller | None:
    """Who asks, as the guard found it; None: a stranger, who reaches only what is open to all."""
    caller: Caller | None = request.state.caller
    return caller


async def get_caller(request: Request) -> Caller | None:
    """As `caller_of`."""
    return caller_of(request)


async def get_shown(request: Request) -> Credentials:
    """What the request shows of its caller."""
    shown: Credentials = request.state.shown
    return shown


CallerDep = Annotated[Caller | None, Depends(get_caller)]
ShownDep = Annotated[Credentials, Depends(get_shown)]


async def get_admitted(caller: CallerDep) -> Caller:
    """Who asks, where strangers are not let in. Raises NotAdmittedError."""
    return admitted(caller, Role.viewer)


AdmittedDep = Annotated[Caller, Depends(get_admitted)]


async def get_holder(caller: AdmittedDep) -> Holder:
    """The caller as a holder of shares."""
    return holder_of(caller)


HolderDep = Annotated[Holder, Depends(get_holder)]

XClient = Annotated[
    str | None,
    Header(max_length=64, description="Id of the caller's own stream (`hello`); not needed while nobody has control."),
]


async def get_asker(control: ControlDep, caller: AdmittedDep, x_client: XClient = None) -> Asker:
    """The caller, by name. Raises NotYoursError if the id is of another session."""
    return control.asker(caller, x_client)


async def get_operator(control: ControlDep, caller: AdmittedDep, x_client: XClient = None) -> Asker:
    """The caller, if it may command now. Raises ConflictError while another has control, NotYoursError, RoleError."""
    return control.command(admitted(caller, Role.operator), x_client)


AskerDep = Annotated[Asker, Depends(get_asker)]
OperatorDep = Annotated[Asker, Depends(get_operator)]
