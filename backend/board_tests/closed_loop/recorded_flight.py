"""The closed loop with the station's recorder beside it: the truth, and the recording that the station keeps of it."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from epf_gcs.codec.encode import encode_command
from epf_gcs.lab.closed_loop import ClosedLoop
from epf_gcs.recordings.topics import BOARD_RECEIVED, BOARD_SENT, SIMULATOR_RECEIVED
from epf_gcs.simulator.simulation import SimulationOptions
from tests.flights.flown_flights import indexed
from tests.recordings.files import START_NS, Said, plain

_HEARTBEAT_TASK: Final = 0
_HEARTBEAT_PERIOD_S: Final = 0.2


class RecordedLoop(ClosedLoop):
    """A closed loop of which every byte is kept, with its time in the simulation."""

    def __init__(self, options: SimulationOptions) -> None:
        self._said: list[Said] = []
        self._heartbeat_every = round(_HEARTBEAT_PERIOD_S * options.rate_hz)
        super().__init__(options)
        self.command("start")

    def command(self, name: str, *values: float) -> None:
        """Give the board a command."""
        self._keep(BOARD_SENT, encode_command(name, *values))
        super().command(name, *values)

    def write(self, data_dir: Path) -> Path:
        """Put the recording into a data folder, with its columns; returns its path."""
        return indexed(data_dir, b"".join(plain(self._said)))

    def _frame(self) -> None:
        super()._frame()
        self._keep(SIMULATOR_RECEIVED, *self.bytes_to_station)
        self.bytes_to_station.clear()
        if self._frames % self._heartbeat_every == 0:
            self._take(self.firmware.send_streams(_HEARTBEAT_TASK))

    def _take(self, data: bytes) -> None:
        self._keep(BOARD_RECEIVED, data)
        super()._take(data)

    def _keep(self, channel: int, *messages: bytes) -> None:
        t_ns = START_NS + round(self.simulation.time_s * 1e9)
        self._said += [(channel, t_ns, data) for data in messages if data]
