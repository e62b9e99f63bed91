"""What the routes ask for."""

from __future__ import annotations

from typing import Annotated, cast

from fastapi import Depends, Header, Request

from epf_gcs.flight.station import Station


def get_station(request: Request) -> Station:
    """The running parts."""
    return cast(Station, request.app.state.station)


StationDep = Annotated[Station, Depends(get_station)]


def get_operator(
    station: StationDep,
    x_client: Annotated[
        str | None,
        Header(max_length=64, description="Id of the stream's hello; not needed while nobody has control."),
    ] = None,
) -> str | None:
    """The caller, who may command now. Raises ConflictError while another has control."""
    station.control.check(x_client)
    return x_client


OperatorDep = Annotated[str | None, Depends(get_operator)]
