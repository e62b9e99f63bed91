"""The recording's clock, for a vehicle that is replayed."""

from __future__ import annotations


class RecordedClock:
    """Implements `epf_gcs.vehicle.outside.Clock`. Stands where it was set: at the bytes being decoded, or after."""

    def __init__(self) -> None:
        self.t_ns = 0

    def now_s(self) -> float:
        """Unix seconds."""
        return self.t_ns * 1e-9

    def steady_s(self) -> float:
        """The same: a recording's time never jumps back but by a seek, which makes a new vehicle."""
        return self.t_ns * 1e-9
