"""The parts whose state is shown and looked after, in one place."""

from __future__ import annotations

from dataclasses import dataclass

from epf_gcs.clock import Clock
from epf_gcs.error_log import ErrorLog
from epf_gcs.flight.board.ahrs_test import AhrsTestRun
from epf_gcs.flight.board.board_link import Supervisor
from epf_gcs.flight.hil.hil import Hil
from epf_gcs.flight.hil.simulator import Simulator
from epf_gcs.flight.hil.simulator_faults import SimulatorFaultControl
from epf_gcs.flight.memory.memory import Memory
from epf_gcs.flight.recording.recorder import Recorder
from epf_gcs.flight.state.line_rates import LineRates
from epf_gcs.flight.state.lines import Lines
from epf_gcs.flight.state.watch import Watch
from epf_gcs.vehicle.alarms import Alarms
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.telemetry import Telemetry


@dataclass(frozen=True, slots=True, kw_only=True)
class StateSources:
    """The status and the inspector read them; the housekeeping gives those their turn that need one."""

    clock: Clock
    errors: ErrorLog
    memory: Memory
    board: Board
    telemetry: Telemetry
    supervisor: Supervisor
    lines: Lines
    simulator: Simulator
    faults: SimulatorFaultControl
    hil: Hil
    rates: LineRates
    ahrs_test: AhrsTestRun
    recorder: Recorder | None
    watch: Watch
    alarms: Alarms
