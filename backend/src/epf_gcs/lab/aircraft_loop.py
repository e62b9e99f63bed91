"""The loop of the real aircraft in lock-step: its sensors measure what the simulator flies, its servos move it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Final

from epf_gcs.contract.simulator_faults import Fault
from epf_gcs.lab.answers import within_limits
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.faults import check_aircraft
from epf_gcs.lab.faulty import FaultyLockStep
from epf_gcs.simulator.airframe import ground_course
from epf_gcs.simulator.link import LinkQuality
from epf_gcs.simulator.simulation import SimulationOptions
from epf_gcs.simulator.situation import FT_S_PER_KT
from epf_gcs.units import FT_MIN_PER_FT_S, M_PER_FT
from epf_gcs.xplane.datagram import Surfaces

_AUTOPILOT, _AUTOTRIM = 4, 5
_CHANNELS: Final = 12
_FIELDS: Final = (
    *("gx_rad_s", "gy_rad_s", "gz_rad_s", "heading_deg", "pitch_deg", "roll_deg"),
    *("altitude_ft", "vvi_ft_min", "speed_kt"),
    *("latitude_deg", "longitude_deg", "gps_altitude_ft", "ground_speed_kt", "yaw_deg", "receiver"),
)


class AircraftLoop(FaultyLockStep):
    """A simulator and a board whose sensors and servos are the aircraft's. Attitude comes from its own sensor here: the
    board's estimator is left out, so that a fault is of what the laws are told. The pilot's stick stays neutral; the
    switches of the transmitter are commands: `autopilot_on`, `autotrim_on`.
    """

    fields: Sequence[str] = _FIELDS
    _plan_stream = "fms_plan"

    def __init__(self, options: SimulationOptions, faults: Sequence[Fault], library: Path | None = None) -> None:
        if options.link != LinkQuality():
            raise LabError('the loop of the real aircraft has no link to be delayed or to lose frames: loop = "hil"')
        self.channels = [0.0] * _CHANNELS
        super().__init__(options, faults, library)
        self.channels[2] = self._lever
        for switch in (_AUTOPILOT, _AUTOTRIM):
            self.channels[switch] = -1.0
        self.command("fms_plan_on")
        self.command("autotrim_on")

    def command(self, name: str, *values: float) -> None:
        """Give the board a command, or the transmitter a switch."""
        for word, channel in (("autopilot", _AUTOPILOT), ("autotrim", _AUTOTRIM)):
            if name in (f"{word}_on", f"{word}_off"):
                self.channels[channel] = 1.0 if name.endswith("_on") else -1.0
                return
        super().command(name, *values)

    def _check(self, faults: Sequence[Fault]) -> None:
        check_aircraft(faults)

    def _told(self, values: Sequence[float]) -> bytes:
        """Let the board measure this instant, and its servos move; nothing goes over a line."""
        latitude_deg, longitude_deg, altitude_ft, indicated_ft, roll, pitch, heading, p, q, r = values[:10]
        cas_kt, north, east, down = values[10:14]
        heading_deg = math.degrees(heading) % 360.0
        told = [
            *(p, q, r, heading_deg, math.degrees(pitch), math.degrees(roll)),
            *(indicated_ft, -down * FT_MIN_PER_FT_S, cas_kt, latitude_deg, longitude_deg, altitude_ft),
            *(math.hypot(north, east) / FT_S_PER_KT, ground_course(north, east, heading_deg), 0.0),
        ]
        for sensor in self._sensors:
            sensor.change(self.time_s, told)
        self._step(told)
        return b""

    def _step(self, told: list[float]) -> None:
        for reset in self._resets:
            if reset.fault.is_on(self.time_s):
                reset.show()
                return
        *measured, receiver = told
        # The board takes metres.
        measured[6] *= M_PER_FT
        measured[11] *= M_PER_FT
        self._laws.step([*measured, *(channel + receiver for channel in self.channels)], 1.0 / self._rate_hz)
        aileron, elevator, throttle, rudder = self._laws.positions()[:4]
        self._uplink.send(within_limits(Surfaces(elevator, aileron, rudder, throttle)), self.time_s)

    def _give(self, arrived: list[bytes]) -> None:
        """Nothing comes over a line."""
