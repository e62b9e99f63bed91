"""The shapes of the flown tracks."""

from __future__ import annotations

from epf_gcs.contract.shapes import Output


class TrackState(Output):
    """What is drawn now; `can_restore`: the track that was cleared last is still kept."""

    flight_points: int
    hil_points: int
    can_restore: bool
