"""The load of the lines, in bytes/s."""

from __future__ import annotations

from epf_gcs.flight.hil.simulator import Simulator
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.rates import ByteRate


class LineRates:
    """Bytes/s over the last second: the board's line in both directions, and the simulator's datagrams."""

    def __init__(self) -> None:
        self.board_in = ByteRate()
        self.board_out = ByteRate()
        self.simulator_in = ByteRate()

    def note(self, now_s: float, board: Board, simulator: Simulator) -> None:
        """Take the counters as they are now."""
        self.board_in.note(now_s, board.bytes_in)
        self.board_out.note(now_s, board.bytes_out)
        self.simulator_in.note(now_s, simulator.bytes_in)
