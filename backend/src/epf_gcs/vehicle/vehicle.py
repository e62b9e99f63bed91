"""One aircraft as the bytes of its board and its simulator tell it: bytes in; samples, their health and events out.

It is told the time and does no I/O, so that any number can be made: the live one, and one for each replayed flight.
"""

from __future__ import annotations

from collections.abc import Callable

from epf_gcs.error_log import ErrorLog
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.outside import Clock, Outlet
from epf_gcs.vehicle.simulator_samples import SimulatorSamples
from epf_gcs.vehicle.telemetry import Telemetry


class Vehicle:
    """`board` takes bytes and lines, `simulator` datagrams, `telemetry` has the newest samples.

    `commanded_period_s` tells a task's period.
    """

    def __init__(
        self, clock: Clock, outlet: Outlet, errors: ErrorLog, commanded_period_s: Callable[[str], float]
    ) -> None:
        self.telemetry = Telemetry(outlet, clock, commanded_period_s)
        self.board = Board(clock, outlet, self.telemetry, errors)
        self.simulator = SimulatorSamples(self.telemetry)
