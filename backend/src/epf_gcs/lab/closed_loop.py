"""The closed loop in one process: JSBSim, X-Plane's datagrams, command 50, and the board's own C code.

What flies here is what flies in the real processes: the simulator without its socket, the gateway's decoders, and the
firmware's pure part. `lock_step.py` flies the same flight without the datagrams.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Final, Self

from epf_gcs.codec.encode import encode_command
from epf_gcs.lab.answers import Answers
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.laws import FMS_PERIOD_S, FMS_TASK, Laws
from epf_gcs.lab.own_gains import OwnGains
from epf_gcs.simulator.simulation import Simulation, SimulationOptions
from epf_gcs.simulator.state import FlightState
from epf_gcs.xplane.datagram import Surfaces, parse, surfaces_datagram
from epf_gcs.xplane.gather import Gatherer
from epf_gcs.xplane.mapping import XplaneInfo

FIRST_COMMANDS: Final = (("fms_hil_plan_on",), ("autotrim_on",), ("control_source", 1))
"""What the board is told before a flight: send the plan of HIL, trim by itself, fly the assisted path."""


@dataclass(frozen=True, slots=True)
class Sample:
    """One frame of a flight: the truth of the simulator, and what the board made of it."""

    time_s: float
    state: FlightState
    waypoint: int  # -1 without a plan
    surfaces: Surfaces | None  # the board's newest answer


class ClosedLoop:
    """A simulator and a board, wired as the gateway wires them, on the assisted path.

    `measured`: the board measures the time of its steps, as deployed. `repeats`: how often the simulator sends each of
    its pictures again, evenly in the time until the next.
    """

    def __init__(
        self, options: SimulationOptions, *, measured: bool = False, repeats: int = 0, library: Path | None = None
    ) -> None:
        self.crashes: list[str] = []
        self.simulation = Simulation(options, self.crashes.append)
        self.firmware = Laws(0.0 if measured else 1.0 / options.rate_hz, library)
        self.own_gains = OwnGains(self.firmware.feed)
        self._sent_every_ms = round(1000.0 / options.rate_hz / (1 + repeats)) if measured else 0
        self._repeats = repeats
        self._rate_hz = options.rate_hz
        self._info: XplaneInfo | None = None
        self._gatherer = Gatherer(options.profile)
        self._answers = Answers()
        self._fms_every = round(FMS_PERIOD_S * options.rate_hz)
        self._frames = 0
        self.surfaces: Surfaces | None = None
        self.samples: list[Sample] = []
        self.bytes_to_station: list[bytes] = []
        for name, *values in FIRST_COMMANDS:
            self.command(name, *values)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.firmware.close()

    def command(self, name: str, *values: float) -> None:
        """Give the board a command."""
        self._take(self.firmware.feed(encode_command(name, *values)))

    def fly(self, seconds: float, until: Callable[[Sample], bool] = lambda _: False) -> list[Sample]:
        """Fly on, at most so long; returns the samples of that time."""
        first = len(self.samples)
        end_s = self.simulation.time_s + seconds
        while self.simulation.time_s < end_s:
            self._frame()
            if until(self.samples[-1]):
                break
        return self.samples[first:]

    def pause(self, seconds: float, *, stick_trembles: bool = False) -> None:
        """Pause the simulator: its newest frame goes to the board again and again, and the board's time runs on."""
        if self._info is None:
            raise LabError("nothing was flown yet, so there is no frame that a paused simulator could repeat")
        for frame in range(round(seconds * self._rate_hz)):
            self._tell(self._info._replace(elevator=0.001 * (frame % 3)) if stick_trembles else self._info)

    def _tell(self, info: XplaneInfo) -> None:
        self.firmware.advance(self._sent_every_ms)
        self._take(self.firmware.feed(encode_command("xplane_info", *info)))

    def _frame(self) -> None:
        simulation = self.simulation
        simulation.advance()
        simulation.send()
        for datagram in simulation.arrived(simulation.time_s):
            self.bytes_to_station.append(datagram)
            info = self._gatherer.take(parse(datagram) or [], simulation.time_s)
            if info is not None:
                self._info = info
                for _ in range(1 + self._repeats):
                    self._tell(info)
        self._frames += 1
        if self._frames % self._fms_every == 0:
            self._take(self.firmware.send_streams(FMS_TASK))
        self.samples.append(Sample(simulation.time_s, simulation.state, self._answers.waypoint, self.surfaces))

    def _take(self, data: bytes) -> None:
        """What the station does with the board's frames."""
        for surfaces in self._answers.take(data):
            self.surfaces = surfaces
            datagram = surfaces_datagram(surfaces)
            if datagram is not None:
                self.simulation.receive(datagram)
