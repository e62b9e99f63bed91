"""FastAPI dependencies: each gives a route one part of the station."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, cast

from fastapi import Depends, Header, Request

from epf_gcs.bus.definition import Asker
from epf_gcs.bus.station_end import StationEnd
from epf_gcs.clock import Clock
from epf_gcs.web.access.control import Control
from epf_gcs.web.flights.flights import Flights
from epf_gcs.web.flights.imports import FlightImports
from epf_gcs.web.flights.queries import Queries
from epf_gcs.web.inspector.shared import SharedInspector
from epf_gcs.web.maps.maps import Maps
from epf_gcs.web.state.whole import WholeStatus
from epf_gcs.web.track.tracks import Tracks
from epf_gcs.web.vehicle.mirror import VehicleMirror


def get_vehicle(request: Request) -> StationEnd:
    """The connection to the flight process, for requests."""
    return cast(StationEnd, request.app.state.vehicle)


def get_mirror(request: Request) -> VehicleMirror:
    """The newest samples and status from the flight process."""
    return cast(VehicleMirror, request.app.state.mirror)


def get_status(request: Request) -> WholeStatus:
    """The whole status."""
    return cast(WholeStatus, request.app.state.status)


def get_control(request: Request) -> Control:
    """Who has control."""
    return cast(Control, request.app.state.control)


def get_tracks(request: Request) -> Tracks:
    """The flown tracks."""
    return cast(Tracks, request.app.state.tracks)


def get_maps(request: Request) -> Maps:
    """The maps."""
    return cast(Maps, request.app.state.maps)


def get_flights(request: Request) -> Flights:
    """The flights."""
    return cast(Flights, request.app.state.flights)


def get_flight_imports(request: Request) -> FlightImports:
    """Recordings that come from other machines."""
    return cast(FlightImports, request.app.state.flight_imports)


def get_queries(request: Request) -> Queries:
    """Questions about what is in a flight."""
    return cast(Queries, request.app.state.flight_queries)


def get_inspector(request: Request) -> SharedInspector:
    """The message inspector."""
    return cast(SharedInspector, request.app.state.inspector)


def get_recordings_dir(request: Request) -> Path:
    """The folder of the recordings."""
    return cast(Path, request.app.state.recordings_dir)


def get_clock(request: Request) -> Clock:
    """The flight's clock."""
    return cast(Clock, request.app.state.clock)


VehicleDep = Annotated[StationEnd, Depends(get_vehicle)]
MirrorDep = Annotated[VehicleMirror, Depends(get_mirror)]
StatusDep = Annotated[WholeStatus, Depends(get_status)]
ControlDep = Annotated[Control, Depends(get_control)]
TracksDep = Annotated[Tracks, Depends(get_tracks)]
MapsDep = Annotated[Maps, Depends(get_maps)]
FlightsDep = Annotated[Flights, Depends(get_flights)]
QueriesDep = Annotated[Queries, Depends(get_queries)]
ImportsDep = Annotated[FlightImports, Depends(get_flight_imports)]
InspectorDep = Annotated[SharedInspector, Depends(get_inspector)]
RecordingsDirDep = Annotated[Path, Depends(get_recordings_dir)]
ClockDep = Annotated[Clock, Depends(get_clock)]


XClient = Annotated[
    str | None,
    Header(max_length=64, description="Id of the stream's hello; not needed while nobody has control."),
]


def get_operator(control: ControlDep, x_client: XClient = None) -> Asker:
    """The caller, if it may command now. Raises ConflictError while another has control."""
    control.check(x_client)
    return Asker(x_client, None if x_client is None else control.name_of(x_client))


OperatorDep = Annotated[Asker, Depends(get_operator)]
