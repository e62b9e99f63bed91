"""What the operator chooses of ground and fence, as it is asked for and kept."""

from __future__ import annotations

from typing import Annotated, Self

from pydantic import Field, model_validator

from epf_gcs.contract.shapes import Input
from epf_gcs.formats.fence_border import crossing_edges
from epf_gcs.formats.fence_file import (
    HIGHEST_CEILING_FT,
    LEAST_CORNERS,
    LOWEST_CEILING_FT,
    MOST_CORNERS,
)


class FenceCorner(Input):
    """One corner of the fence, WGS 84."""

    latitude_deg: Annotated[float, Field(ge=-90, le=90)]
    longitude_deg: Annotated[float, Field(ge=-180, le=180)]


def crossing(choice: SurroundingsChange) -> tuple[int, int] | None:
    """Two sides of the chosen fence that cross, by number from 1."""
    return crossing_edges([(corner.latitude_deg, corner.longitude_deg) for corner in choice.corners])


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
