"""Shapes of ground and fence."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from epf_gcs.formats.fence_file import (
    HIGHEST_CEILING_FT,
    LEAST_CORNERS,
    LOWEST_CEILING_FT,
    MOST_CORNERS,
    FenceFormat,
    FenceNoteCode,
)
from epf_gcs.web.schemas import Input, Output, ParamValue


class FenceCorner(Input):
    """One corner of the fence, WGS 84."""

    latitude_deg: Annotated[float, Field(ge=-90, le=90)]
    longitude_deg: Annotated[float, Field(ge=-180, le=180)]


class SurroundingsChange(Input):
    """The whole choice as it shall be. Both warnings are off until chosen.

    `margin_ft`: height above the ground that is wanted. `corners`: the fence's border, none or at least three;
    `ceiling_ft` above the sea. `fence_margin_ft`: nearer to the border or the ceiling than this is warned of.
    """

    terrain_on: bool
    margin_ft: Annotated[float, Field(ge=30, le=3000)]
    fence_on: bool
    corners: Annotated[list[FenceCorner], Field(max_length=MOST_CORNERS)]
    ceiling_ft: Annotated[float, Field(ge=LOWEST_CEILING_FT, le=HIGHEST_CEILING_FT)] | None
    fence_margin_ft: Annotated[float, Field(ge=0, le=3000)]

    @model_validator(mode="after")
    def _is_a_fence(self) -> Self:
        if 0 < len(self.corners) < LEAST_CORNERS:
            raise ValueError("a fence has at least three corners, or none")
        if self.fence_on and not self.corners and self.ceiling_ft is None:
            raise ValueError("a fence that warns has corners or a ceiling")
        return self


class SurroundingsChoice(Output):
    """What the operator chose, for everybody."""

    terrain_on: bool
    margin_ft: float
    fence_on: bool
    corners: list[FenceCorner]
    ceiling_ft: float | None
    fence_margin_ft: float


class FenceNote(Output):
    """Something about the file that a person should know before relying on the fence.

    circle_cornered {count}: the fence was a circle, and has so many corners now, all of them within it.
    exclusions_skipped {count}: areas to stay out of, which this fence cannot have.
    shapes_skipped {count}: other borders; the first one was taken.
    """

    code: FenceNoteCode
    params: dict[str, ParamValue]


class FenceImport(Output):
    """What was in the file; `ceiling_ft` above the sea, null if it has none. The station's fence is as it was."""

    format: FenceFormat
    corners: list[FenceCorner]
    ceiling_ft: float | None
    notes: list[FenceNote]


class TrackPlace(Output):
    """A place on the present track."""

    latitude_deg: float
    longitude_deg: float


class ThreatAhead(Output):
    """What the present track leads to: in `in_s` (0: now), at this place, at this altitude above the sea."""

    what: Literal["terrain", "fence", "ceiling"]
    in_s: float
    latitude_deg: float
    longitude_deg: float
    altitude_ft: float


class AircraftAround(Output):
    """Ground and fence of one aircraft. `blind`: why nothing is known of the ground; `path`: the present track, while
    there is a warning. `outside`: beyond the fence's border or over its ceiling."""

    blind: Literal["no_position", "no_heights", "no_heights_here"] | None
    ground_ft: float | None
    height_ft: float | None
    terrain: ThreatAhead | None
    fence: ThreatAhead | None
    outside: bool
    path: list[TrackPlace]


class SurroundingsState(Output):
    """The board's aircraft by its GPS, and the simulator's."""

    flight: AircraftAround
    hil: AircraftAround
