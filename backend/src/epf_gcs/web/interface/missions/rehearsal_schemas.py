"""The shapes of a plan that is flown in the model before it is sent."""

from __future__ import annotations

from typing import Self

from pydantic import Field, model_validator

from epf_gcs.contract.shapes import Input, Output
from epf_gcs.contract.surroundings import HeightSet
from epf_gcs.rehearsal.findings import FindingCode
from epf_gcs.rehearsal.rehearsals import GroundKnown
from epf_gcs.web.interface.missions.schemas import MissionInput


class RehearsalStart(Input):
    """Where the aircraft is: true track over the ground, indicated airspeed. One that stands begins in slow flight."""

    latitude_deg: float = Field(ge=-90, le=90)
    longitude_deg: float = Field(ge=-180, le=180)
    altitude_ft: float = Field(ge=-2000, le=60000)
    track_deg: float = Field(ge=-360, le=360)
    speed_kt: float = Field(ge=0, le=500)


class RehearsalWind(Input):
    """A steady wind, by the true direction that it blows from."""

    from_deg: float = Field(ge=0, le=360)
    speed_kt: float = Field(ge=0, le=100)


class RehearsalInput(MissionInput):
    """A plan from its waypoint `first` on, counted from 0. Without `start` it is flown from over that waypoint.

    `endurance_min`: how long the battery lasts from now on; without it the battery is not judged.
    """

    first: int = Field(0, ge=0)
    start: RehearsalStart | None = None
    wind: RehearsalWind = RehearsalWind(from_deg=0, speed_kt=0)
    endurance_min: float | None = Field(None, gt=0, le=10000)

    @model_validator(mode="after")
    def _has_first(self) -> Self:
        if self.first >= len(self.waypoints):
            raise ValueError("first is the number of a waypoint of the plan, counted from 0")
        return self


class RehearsalFinding(Output):
    """What goes wrong on the leg to waypoint `row`, counted from 0, with the numbers for its sentence.

    above_ceiling {above_ft, ceiling_ft}, leaves_fence {distance_m}, meets_ground {below_ft}, low_ground {height_ft,
    margin_ft}: against the station's fence and heights. wide_turn {distance_m}: so far from the legs.
    unfinished_turn {off_deg}: so far from the course where the waypoint is reached. short_leg {distance_m, radius_m}:
    reached at once, or within the capture radius of the one before. misses_altitude {off_ft, flown_ft}: flown there.
    battery_ends {lasts_min, takes_min}. unreached, too_long: the flight ends on this leg; what follows was not flown.
    """

    code: FindingCode
    row: int
    params: dict[str, float]


class MissionRehearsal(Output):
    """What came of the flight. `time_s`: until waypoint `last` was reached, or the flight ended on the way to it.

    What is not known was not judged: `ground` says how much of the heights below the flight is known and
    `heights` by which sets of terrain, `fence` whether there is one, `battery` whether its time was given.
    """

    time_s: float
    last: int
    ground: GroundKnown
    heights: list[HeightSet]
    fence: bool
    battery: bool
    findings: list[RehearsalFinding]
