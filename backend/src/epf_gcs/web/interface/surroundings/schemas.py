"""Shapes of ground and fence."""

from __future__ import annotations

from epf_gcs.contract.shapes import Output, ParamValue
from epf_gcs.formats.fence_file import FenceFileFormat, FenceNoteCode
from epf_gcs.surroundings.choice import FenceCorner


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
    crosses {first, second}: these sides meet, counted from 1; the fence cannot be kept so.
    return_skipped {count}: the place to return to, which this fence does not have.
    exclusions_skipped {count}: areas to stay out of, which this fence cannot have.
    shapes_skipped {count}: other borders; the first one was taken.
    """

    code: FenceNoteCode
    params: dict[str, ParamValue]


class FenceImport(Output):
    """What was in the file; `ceiling_ft` above the sea, null if it has none. The station's fence is as it was."""

    format: FenceFileFormat
    corners: list[FenceCorner]
    ceiling_ft: float | None
    notes: list[FenceNote]
