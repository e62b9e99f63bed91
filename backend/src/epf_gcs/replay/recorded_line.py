"""Stands in for the board's line in a replay."""

from __future__ import annotations


class RecordedLine:
    """Implements `epf_gcs.vehicle.outside.Line`: what a vehicle would send was sent long ago."""

    def __init__(self, baud: int) -> None:
        self.baud = baud

    @property
    def backlog(self) -> int:
        """Nothing waits."""
        return 0

    def write(self, data: bytes) -> bool:
        """Send nothing."""
        return True
