"""One aircraft as the bytes of its board and its simulator tell it: bytes in; samples, their health and events out.

It is told the time and does no I/O, so that any number can be made: the live one, and one for each replayed flight.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from epf_gcs.contract.answers import Sample
from epf_gcs.error_log import ErrorLog
from epf_gcs.vehicle.ahrs_test_samples import AhrsTestSamples
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.board_state import BoardState
from epf_gcs.vehicle.outside import Clock, Outlet
from epf_gcs.vehicle.restart import Restart
from epf_gcs.vehicle.simulator_motion import Jump
from epf_gcs.vehicle.simulator_samples import SIMULATOR_TOPICS, SimulatorSamples, SimulatorState
from epf_gcs.vehicle.telemetry import Telemetry, TelemetryState


class VehicleState(NamedTuple):
    """All that what comes next depends on: a key frame of a recording."""

    telemetry: TelemetryState
    board: BoardState
    simulator: SimulatorState


class Vehicle:
    """`board` takes bytes and lines, `simulator` datagrams, `telemetry` has the newest samples.

    `commanded_period_s` tells a task's period. Without `tells_jumps` somebody else tells of the simulator's jumps.
    `on_opened` and `on_restarted` are the board's.
    """

    def __init__(
        self,
        clock: Clock,
        outlet: Outlet,
        errors: ErrorLog,
        commanded_period_s: Callable[[str], float],
        *,
        tells_jumps: bool = True,
        on_opened: Callable[[], None] = lambda: None,
        on_restarted: Callable[[Restart], None] = lambda _: None,
    ) -> None:
        self.clock = clock
        self.telemetry = Telemetry(outlet, clock, commanded_period_s)
        self.board = Board(clock, outlet, self.telemetry, errors, on_opened=on_opened, on_restarted=on_restarted)
        self.simulator = SimulatorSamples(self.telemetry, self._tell_jump)
        self._outlet = outlet
        self._tells_jumps = tells_jumps
        self.ahrs_test = AhrsTestSamples(self.telemetry, clock)

    def _tell_jump(self, jump: Jump) -> None:
        """Example values jump when they begin again: of those nothing is told."""
        if self._tells_jumps and not self.board.is_emulated:
            self._outlet.event(jump.as_event())

    def newest(self) -> dict[str, Sample]:
        """The newest sample of every topic with its age. Those of a paused simulator are stale."""
        is_paused = self.simulator.motion.is_paused(self.clock.now_s())
        return self.telemetry.snapshot(SIMULATOR_TOPICS if is_paused else frozenset())

    def kept(self) -> VehicleState:
        """For `restore`, before anything else comes."""
        return VehicleState(self.telemetry.kept(), self.board.kept(), self.simulator.kept())

    def restore(self, kept: VehicleState) -> None:
        """Go on from a state that `kept` gave, with the same line attached; nothing is sent."""
        self.telemetry.restore(kept.telemetry)
        self.board.restore(kept.board)
        self.simulator.restore(kept.simulator)
