"""The faults of a flight that goes on: begun, ended and reported by order, at work on rows, controls, link and air.

The truth stays as it is: the rows, the surfaces and the datagrams are what is wrong. Times are simulated seconds.
"""

from __future__ import annotations

import math
from dataclasses import replace
from operator import attrgetter
from typing import Final, NamedTuple, TypeVar

from epf_gcs.contract.simulator_faults import (
    HIGHEST_WIND_KT,
    MOST_FAULTS,
    FaultOrder,
    FaultReport,
    FlownFault,
    OrderedFault,
    WindState,
    not_carried,
)
from epf_gcs.simulator.effects import (
    SENSORS,
    SERVOS,
    Direction,
    Effect,
    GustEffect,
    LineEffect,
    SensorEffect,
    ServoEffect,
)
from epf_gcs.simulator.inputs import Command
from epf_gcs.simulator.situation import Turbulence, Wind
from epf_gcs.simulator.state import Controls, FlightState

T = TypeVar("T")

# What each sensor measures, by the names of command 50 and by those of the state.
_MEASURED: Final = {
    "gx_rad_s": "p_rad_s",
    "gy_rad_s": "q_rad_s",
    "gz_rad_s": "r_rad_s",
    "pitch_deg": "pitch_deg",
    "roll_deg": "roll_deg",
    "altitude_ft": "altitude_indicated_ft",
    "vvi_ft_min": "vvi_ft_min",
    "speed_kt": "airspeed_indicated_kt",
    "latitude_deg": "latitude_deg",
    "longitude_deg": "longitude_deg",
    "yaw_deg": "track_deg",
}
_FIELDS: Final = tuple(_MEASURED)
_STATE_FIELDS: Final = tuple(_MEASURED.values())
_read_state: Final = attrgetter(*_STATE_FIELDS)
# A fault that is over is reported for so long, so that its end and its frames are heard.
_REPORTED_S: Final = 3.0


class _Flown(NamedTuple):
    """A fault at work. `to_station` and `to_simulator`: of a line's fault."""

    id: str
    effect: Effect
    to_station: Direction[bytes] | None = None
    to_simulator: Direction[Command] | None = None

    @property
    def end_s(self) -> float:
        return self.effect.fault.start_s + self.effect.fault.length


class SimulatorFaults:
    """Those of one simulation, with its seed and the length of its frames."""

    def __init__(self, seed: int, period_s: float, wind: WindState) -> None:
        self._seed = seed
        self._period_s = period_s
        self._flown: list[_Flown] = []
        self._serial = 0
        self.wind = wind

    @property
    def next_due_s(self) -> float | None:
        """When the next datagram arrives that a fault delays; None when none is under way."""
        due = [one.to_station.next_due_s for one in self._flown if one.to_station is not None]
        return min((due_s for due_s in due if due_s is not None), default=None)

    def obey(self, order: FaultOrder, time_s: float) -> None:
        """Begin, end and blow as ordered. What cannot be flown is not begun: the report lacks it."""
        self._serial = order.serial
        for one in self._flown:
            if order.ends_all or one.id == order.end:
                self._end(one, time_s)
        if order.begin is not None:
            self._begin(order.begin, time_s)
        if order.wind is not None and 0.0 <= order.wind.speed_kt <= HIGHEST_WIND_KT:
            self.wind = replace(order.wind, from_deg=order.wind.from_deg % 360.0)

    def report(self, time_s: float) -> FaultReport:
        """What is flown now, and what was until some seconds ago."""
        return FaultReport(self._serial, self.wind, tuple(_reported(one, time_s) for one in self._flown))

    def marks(self, time_s: float) -> tuple[tuple[str, bool], ...]:
        """Which faults are there now; it differs where one begins, ends, or is ordered."""
        return tuple((one.id, one.effect.fault.is_on(time_s)) for one in self._flown)

    def tidy(self, time_s: float) -> None:
        """Forget what was over some seconds ago."""
        if self._flown:
            self._flown = [one for one in self._flown if time_s < one.end_s + _REPORTED_S]

    def measured(self, time_s: float, state: FlightState) -> FlightState:
        """The state as the sensors measure it."""
        sensors = [one.effect for one in self._flown if isinstance(one.effect, SensorEffect)]
        if not sensors:
            return state
        told = list(_read_state(state))
        for sensor in sensors:
            sensor.change(time_s, told)
        return replace(state, **dict(zip(_STATE_FIELDS, told, strict=True)))

    def moved(self, time_s: float, controls: Controls) -> Controls:
        """Where the surfaces and the throttle go."""
        for one in self._flown:
            if isinstance(one.effect, ServoEffect):
                controls = one.effect.change(time_s, controls)
        return controls

    def to_station(self, time_s: float, datagrams: list[bytes]) -> list[bytes]:
        """The datagrams that reach the station now."""
        for one in self._flown:
            if one.to_station is not None:
                datagrams = one.to_station.carry(time_s, datagrams)
        return datagrams

    def to_simulator(self, time_s: float, commands: list[Command]) -> list[Command]:
        """The commands that reach the simulator now."""
        for one in self._flown:
            if one.to_simulator is not None:
                commands = one.to_simulator.carry(time_s, commands)
        return commands

    def gust_kt(self, time_s: float) -> float:
        """By how much it blows more than the steady wind."""
        return sum(one.effect.more_kt(time_s) for one in self._flown if isinstance(one.effect, GustEffect))

    def pause(self, time_s: float) -> str | None:
        """How it stands still in this frame: `pause` repeats its rows, `silent` sends none; None: it flies."""
        pauses = [one.effect for one in self._flown if one.effect.fault.place == "simulator"]
        now = [pause for pause in pauses if pause.fault.is_on(time_s)]
        for pause in now:
            pause.show()
        return max((pause.fault.kind for pause in now), default=None)

    def _begin(self, ordered: OrderedFault, time_s: float) -> None:
        fault = ordered.fault
        is_known = any(one.id == ordered.id for one in self._flown)
        if is_known or len(self._flown) >= MOST_FAULTS or not_carried(fault.place, fault.kind) is not None:
            return
        fault = replace(fault, start_s=round(time_s + fault.start_s, 3))
        if fault.place in SENSORS:
            flown = _Flown(ordered.id, SensorEffect(fault, self._seed, _FIELDS))
        elif fault.place in SERVOS:
            flown = _Flown(ordered.id, ServoEffect(fault, self._seed, self._period_s))
        elif fault.place == "line":
            line = LineEffect(fault, self._seed)
            flown = _Flown(ordered.id, line, line.direction("to", _whole), line.direction("from", _whole))
        elif fault.place == "wind":
            flown = _Flown(ordered.id, GustEffect(fault, self._seed))
        else:
            flown = _Flown(ordered.id, Effect(fault, self._seed))
        self._flown.append(flown)

    def _end(self, flown: _Flown, time_s: float) -> None:
        fault = flown.effect.fault
        if time_s < fault.start_s:
            self._flown = [one for one in self._flown if one is not flown]
        elif time_s < flown.end_s:
            flown.effect.fault = replace(fault, length_s=max(time_s - fault.start_s, 1e-6))


def weather(wind: WindState) -> tuple[Wind, Turbulence]:
    """As the flight model has them."""
    return Wind(wind.from_deg, wind.speed_kt), Turbulence(wind.turbulence)


def _reported(flown: _Flown, time_s: float) -> FlownFault:
    ends_in_s = flown.end_s - time_s
    fault = flown.effect.fault
    return FlownFault(
        flown.id,
        fault,
        round(fault.start_s - time_s, 3),
        round(ends_in_s, 3) if math.isfinite(ends_in_s) else None,
        flown.effect.frames,
    )


def _whole(frame: T) -> T:
    return frame
