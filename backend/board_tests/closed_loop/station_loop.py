"""The closed loop through the station's own HIL path, in lock-step: what the simulator sends is read, judged, told to
the board and, on the assisted path, answered with its surfaces, by the very objects of the flight process."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Mapping
from typing import Any, Final, Self

from epf_gcs.codec.encode import encode_command
from epf_gcs.contract.base import SimulatorProfile
from epf_gcs.error_log import ErrorLog
from epf_gcs.flight.hil.hil import Hil
from epf_gcs.flight.hil.stick import Stick
from epf_gcs.lab.laws import Laws
from epf_gcs.link.udp import UdpLink
from epf_gcs.simulator.simulation import Simulation, SimulationOptions
from epf_gcs.simulator.state import FlightState
from epf_gcs.vehicle.judges import Loop
from epf_gcs.vehicle.thresholds import chosen
from epf_gcs.vehicle.vehicle import Vehicle
from epf_gcs.vehicle.watch import VehicleWatch
from tests.support.held import HeldClock
from tests.support.outlet import KeptOutlet

_HEARTBEAT_TASK: Final = 0
_TICK_S: Final = 0.1
_BAUD: Final = 115200


class _Line:
    """The board's line: what is written is answered at once, and heard when the frame is done."""

    baud = _BAUD
    backlog = 0

    def __init__(self, firmware: Laws) -> None:
        self._firmware = firmware
        self.waiting = b""

    def write(self, data: bytes) -> bool:
        """Give the board bytes."""
        self.waiting += self._firmware.feed(data)
        return True


class _Socket(UdpLink):
    """The socket to the simulator, without a network."""

    def __init__(self, receive: Callable[[bytes], object]) -> None:
        self._receive = receive

    def send(self, datagram: bytes) -> bool:
        """Give the simulator a datagram."""
        self._receive(datagram)
        return True


class StationLoop:
    """Simulator, station and board. `profile` is what the station reads the rows as; `pace` how fast the simulator's
    time runs; `change` what becomes of a datagram on its way to the station."""

    def __init__(
        self,
        options: SimulationOptions,
        profile: SimulatorProfile,
        *,
        pace: float = 1.0,
        change: Callable[[bytes], bytes] = lambda datagram: datagram,
    ) -> None:
        self._loop = asyncio.new_event_loop()
        self.change = change
        self.pace = pace
        self.crashes: list[str] = []
        self.simulation = Simulation(options, self.crashes.append)
        self._firmware = Laws(1.0 / options.rate_hz)
        self._line = _Line(self._firmware)
        self._clock = HeldClock(0.0)
        self._period_s = 1.0 / options.rate_hz
        self._ticked_s = 0.0
        outlet = KeptOutlet()
        self.vehicle = Vehicle(self._clock, outlet, ErrorLog(), lambda _: _TICK_S)
        self.alarms: list[tuple[float, str, Mapping[str, Any]]] = []
        self._active: dict[str, Mapping[str, Any]] = {}
        self._watch = VehicleWatch(self.vehicle.board, self.vehicle.telemetry, self._clock.steady_s())
        asyncio.set_event_loop(self._loop)
        self.hil = self._loop.run_until_complete(self._make_hil(outlet))
        self.hil.begin(_Socket(self.simulation.receive), profile)
        self.vehicle.board.on_urgent = self.hil.on_urgent
        self.vehicle.board.attach(self._line)
        for command in ("start", "autotrim_on"):
            self.command(command)
        self.command("control_source", 1)
        self.state: FlightState = self.simulation.state

    async def _make_hil(self, outlet: KeptOutlet) -> Hil:
        return Hil(self.vehicle, self._clock, Stick(outlet, self._clock, lambda: None))

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._firmware.close()
        self._loop.close()

    @property
    def time_s(self) -> float:
        """Time of the station's clock since the start."""
        return self._clock.time_s

    @property
    def active(self) -> set[str]:
        """The alarms that hold now."""
        return set(self._active)

    def command(self, name: str, *values: float) -> None:
        """Give the board a command."""
        self.vehicle.board.write(encode_command(name, *values))
        self._hear()

    def assist(self, route: str) -> None:
        """The board flies this route with the surfaces in its hand, whatever the station thinks of it."""
        self.command(f"hil_load_{route}")
        self.command("autopilot_on")
        self.hil.path = "assisted"

    def fly(self, seconds: float, until: Callable[[FlightState], bool] = lambda _: False) -> list[FlightState]:
        """Fly on, at most so long by the station's clock; returns the states of that time."""
        states: list[FlightState] = []
        end_s = self.time_s + seconds
        while self.time_s < end_s - 1e-9:
            self._frame()
            states.append(self.state)
            if until(self.state):
                break
        return states

    def _frame(self) -> None:
        self.simulation.advance()
        self.simulation.send()
        self.state = self.simulation.state
        self._clock.time_s += self._period_s / self.pace
        for datagram in self.simulation.arrived(self.simulation.time_s):
            self.hil.on_datagram(self.change(datagram))
            self._hear()
            self.hil.show()
        if self.time_s - self._ticked_s >= _TICK_S - 1e-9:
            self._ticked_s = self.time_s
            self._line.waiting += self._firmware.send_streams(_HEARTBEAT_TASK)
            self._hear()
            self.vehicle.board.tick()
            self._look()

    def _hear(self) -> None:
        while self._line.waiting:
            data, self._line.waiting = self._line.waiting, b""
            self.vehicle.board.on_bytes(data)

    def _look(self) -> None:
        found = self._watch.look(
            self._clock.steady_s(), chosen({}), None, self._known_of_hil(), self.hil.found, wants_gps=False
        )
        # The firmware's library measures no battery.
        now: dict[str, Mapping[str, Any]] = {one.id: one.params for one in found if one.id != "battery_low"}
        self.alarms += [(self.time_s, name, params) for name, params in now.items() if name not in self._active]
        self._active = now

    def _known_of_hil(self) -> Loop | None:
        hil = self.hil
        if hil.last_to_board_s is None:
            return None
        return Loop(
            to_board_age_s=self._clock.steady_s() - hil.last_to_board_s,
            unanswered_s=0.0 if hil.last_surfaces_s is None else self._clock.steady_s() - hil.last_surfaces_s,
            is_board_open=self.vehicle.board.is_open,
            is_simulator_open=bool(hil.rows),
            missing_rows=hil.missing_rows,
            unusable=hil.unusable,
        )
