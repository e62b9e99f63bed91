"""The alarms of a recording that has no notes of them: judged anew from its bytes, by the rules of the live flight."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

from epf_gcs.contract.status import AlarmState
from epf_gcs.vehicle.alarms import Alarms
from epf_gcs.vehicle.judges import Finding, Line, Loop
from epf_gcs.vehicle.outside import Outlet
from epf_gcs.vehicle.vehicle import Vehicle
from epf_gcs.vehicle.watch import VehicleWatch, WatchState


class JudgedState(NamedTuple):
    """What the rules remember, and the alarms that they found."""

    watch: WatchState
    alarms: list[AlarmState]


class JudgedAlarms:
    """`line` and `loop` give what is known of the board's line and the HIL loop. The thresholds are the defaults."""

    def __init__(
        self, vehicle: Vehicle, outlet: Outlet, line: Callable[[], Line | None], loop: Callable[[], Loop | None]
    ) -> None:
        self._clock = vehicle.clock
        self._simulator = vehicle.simulator
        self._line = line
        self._loop = loop
        self._watch = VehicleWatch(vehicle.board, vehicle.telemetry, vehicle.clock.now_s())
        self._alarms = Alarms(self._find, outlet, {}, lambda _: None)

    def look(self) -> None:
        """Judge this moment; alarms that come and go are events."""
        self._alarms.look(self._clock.now_s())

    def listed(self) -> list[AlarmState]:
        """What is or was wrong, oldest first. Nobody acknowledged anything."""
        return [alarm.state for alarm in self._alarms.active]

    def kept(self) -> JudgedState:
        """For `restore`."""
        return JudgedState(self._watch.kept(), self.listed())

    def restore(self, kept: JudgedState) -> None:
        """Go on from what `kept` gave."""
        self._watch.restore(kept.watch)
        self._alarms.restore(kept.alarms)

    def _find(self, limits: Mapping[str, float]) -> list[Finding]:
        line = self._line()
        if line is None:
            self._watch.forget_gps()
        now_s = self._clock.now_s()
        return self._watch.look(now_s, limits, line, self._loop(), self._simulator.look(now_s), wants_gps=False)
