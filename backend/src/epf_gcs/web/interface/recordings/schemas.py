"""The shapes of recordings."""

from __future__ import annotations

from epf_gcs.contract.shapes import Output


class RecordingInfo(Output):
    """A file with everything that went over the lines."""

    id: str
    started_s: float
    bytes: int
    active: bool


class RecordingList(Output):
    """All recordings, newest first."""

    recordings: list[RecordingInfo]
