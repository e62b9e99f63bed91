"""The simulator without its socket: control datagrams in, frames of X-Plane datagrams out.

Time is simulated time, counted in frames: the same options and the same datagrams at the same
frames give the same bytes, whoever runs it (the real-time process, lock-step, or a test).
"""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Final

from epf_gcs.contract.simulator_faults import FaultOrder, WindState
from epf_gcs.simulator.airframe import STEP_HZ, Airframe, AirframeError
from epf_gcs.simulator.crash import crash_cause
from epf_gcs.simulator.faults import SimulatorFaults, weather
from epf_gcs.simulator.inputs import Command, Inputs
from epf_gcs.simulator.link import Link, LinkQuality
from epf_gcs.simulator.models import AIRCRAFT
from epf_gcs.simulator.rows import RowWriter
from epf_gcs.simulator.situation import Situation
from epf_gcs.simulator.state import FlightState
from epf_gcs.simulator.trim import trimmed
from epf_gcs.xplane.datagram import build

LOWEST_RATE_HZ: Final = 20
HIGHEST_RATE_HZ: Final = 100


@dataclass(frozen=True, slots=True)
class SimulationOptions:
    """What is flown and how it is sent. `throttle` is the pilot's lever, 0..1; None: the trimmed position."""

    aircraft: str = "rc"
    situation: Situation = field(default_factory=Situation)
    throttle: float | None = None
    profile: str = "xp10"
    rate_hz: int = 50
    one_row_per_datagram: bool = False
    link: LinkQuality = field(default_factory=LinkQuality)


class Simulation:
    """One flight. `report` gets a sentence for each crash."""

    def __init__(self, options: SimulationOptions, report: Callable[[str], None]) -> None:
        self._options = options
        self._report = report
        self._trim = trimmed(AIRCRAFT[options.aircraft], options.situation.start)
        neutral = self._trim.controls
        if options.throttle is not None:
            neutral = replace(neutral, throttle=options.throttle)
        self.inputs = Inputs(neutral)
        seed = options.situation.seed
        self.uplink: Link[Command] = Link(options.link, f"{seed} to the simulator")
        self.downlink: Link[bytes] = Link(options.link, f"{seed} from the simulator")
        self._writer = RowWriter(options.profile)
        situation = options.situation
        wind = WindState(situation.wind.from_deg, situation.wind.speed_kt, situation.turbulence.value)
        self.faults = SimulatorFaults(seed, 1.0 / options.rate_hz, wind)
        self._pause: str | None = None
        self._newest: list[bytes] = []
        self._frames = 0
        self.crashes = 0
        self._craft = self._begin()
        self.state = self._craft.state()

    @property
    def time_s(self) -> float:
        """Simulated time since the start."""
        return self._frames / self._options.rate_hz

    @property
    def next_due_s(self) -> float | None:
        """When the next datagram reaches the station; None when none is under way."""
        due = [due_s for due_s in (self.downlink.next_due_s, self.faults.next_due_s) if due_s is not None]
        return min(due, default=None)

    def obey(self, order: FaultOrder) -> None:
        """Let something go wrong, or the wind change, from the next frame on."""
        before = self.faults.wind
        self.faults.obey(order, self.time_s)
        if self.faults.wind != before:
            self._craft.blow(*weather(self.faults.wind))

    def receive(self, datagram: bytes) -> bool:
        """Put a datagram from the station on the link; returns whether it is a command."""
        command = self.inputs.parse(datagram)
        if command is None:
            return False
        self.uplink.send(command, self.time_s)
        return True

    def advance(self) -> None:
        """Advance by one frame, with the commands that have arrived."""
        for command in self.faults.to_simulator(self.time_s, self.uplink.due(self.time_s)):
            self.inputs.apply(command)
        rate_hz = self._options.rate_hz
        # At rates that do not divide 200 Hz the frames have unequal numbers of steps, but the right mean.
        steps = (self._frames + 1) * STEP_HZ // rate_hz - self._frames * STEP_HZ // rate_hz
        self._frames += 1
        self.faults.tidy(self.time_s)
        self._pause = self.faults.pause(self.time_s)
        if self._pause is not None:
            return
        self._craft.gust(self.faults.gust_kt(self.time_s))
        self._craft.command(self.faults.moved(self.time_s, self.inputs.controls()))
        try:
            self._craft.step(steps)
            self.state = self._craft.state()
            cause = crash_cause(self.state)
        except AirframeError as error:
            cause = str(error)
        if cause is not None:
            self.crashes += 1
            self._report(f"Crash after {self.time_s:.1f} s: {cause}. The aircraft is put back to its start.")
            self._craft = self._begin()
            self.state = self._craft.state()

    def send(self) -> None:
        """Put this instant's rows on the link to the station."""
        if self._pause == "silent":
            return
        if self._pause is None:
            self._newest = self._datagrams(self.faults.measured(self.time_s, self.state))
        for datagram in self._newest:
            self.downlink.send(datagram, self.time_s)

    def arrived(self, time_s: float) -> list[bytes]:
        """The datagrams that reach the station by `time_s`."""
        return self.faults.to_station(time_s, self.downlink.due(time_s))

    def _datagrams(self, state: FlightState) -> list[bytes]:
        rows = self._writer.rows(state, self.inputs.stick())
        if self._options.one_row_per_datagram:
            return [build([row]) for row in rows]
        return [build(rows)]

    def _begin(self) -> Airframe:
        options = self._options
        wind, turbulence = weather(self.faults.wind)
        situation = replace(options.situation, wind=wind, turbulence=turbulence)
        return Airframe(AIRCRAFT[options.aircraft], situation, self._trim.motion, self._trim.controls)
