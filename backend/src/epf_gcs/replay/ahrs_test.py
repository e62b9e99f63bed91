"""An AHRS test in a recording: seen by what was sent for it, shown by the samples that live shows it by."""

from __future__ import annotations

from epf_gcs.codec.ahrs_test import BEGIN, QUIT
from epf_gcs.vehicle.vehicle import Vehicle


class RecordedAhrsTest:
    """Implements `epf_gcs.vehicle.board.ExclusiveUser`."""

    def __init__(self, vehicle: Vehicle) -> None:
        self._board = vehicle.board
        self._samples = vehicle.ahrs_test
        self._clock = vehicle.clock

    def sent(self, data: bytes) -> None:
        """These bytes were sent to the board: they may begin or end the test."""
        if self._board.exclusive_user is None and data.endswith(BEGIN):
            self._board.acquire_line(self)
            self._samples.test.start(self._clock.steady_s())
        elif self._board.exclusive_user is self and data.startswith(QUIT):
            self._board.release_line()

    def on_bytes(self, data: bytes) -> None:
        """Take bytes of the board's line during the test."""
        self._samples.take(data)

    def on_line_released(self) -> bytes:
        """The test is over."""
        return self._samples.test.stop()
