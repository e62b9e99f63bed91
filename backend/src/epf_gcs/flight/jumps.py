"""Tells viewers, recording and log of each jump of the simulated aircraft."""

from __future__ import annotations

from epf_gcs.flight.flight_log import FlightLog
from epf_gcs.vehicle.outside import Outlet
from epf_gcs.vehicle.simulator_motion import JUMPED, Jump
from epf_gcs.vehicle.vehicle import Vehicle


def tell_jumps(vehicle: Vehicle, outlet: Outlet, log: FlightLog) -> None:
    """From now on. Example values jump when they begin again: of those nothing is told."""

    def tell(jump: Jump) -> None:
        if not vehicle.board.is_emulated:
            log.simulator_jumped(jump.distance_m)
            outlet.event(JUMPED, jump.as_event())

    vehicle.simulator.motion.on_jump = tell
