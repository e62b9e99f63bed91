"""The shapes of flight plans."""

from __future__ import annotations

from pydantic import Field

from epf_gcs.contract.shapes import Input, Output, PlanName


class WaypointModel(Input):
    """WGS84 degrees, feet above mean sea level, knots indicated."""

    latitude_deg: float = Field(ge=-90, le=90)
    longitude_deg: float = Field(ge=-180, le=180)
    altitude_ft: float = Field(ge=-2000, le=60000)
    speed_kt: float = Field(ge=0, le=500)


class MissionInput(Input):
    """A whole plan."""

    waypoints: list[WaypointModel] = Field(min_length=1, max_length=100)


class Mission(Output):
    """The plan that the board has."""

    plan: PlanName
    waypoints: list[WaypointModel]
