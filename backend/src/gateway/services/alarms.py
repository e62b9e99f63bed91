"""What the operator must know at once, on whatever tab."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Final, Literal

from gateway.errors import Params
from gateway.services.board import Board
from gateway.services.hil import Hil
from gateway.services.hub import Hub
from gateway.services.recorder import Recorder
from gateway.services.simulator import Simulator
from gateway.services.supervisor import Supervisor
from gateway.services.telemetry import Telemetry

AlarmId = Literal["heartbeat_lost", "no_heartbeat", "hil_lost", "frames_damaged", "recorder_failed"]
Level = Literal["warning", "critical"]

_SHORTEST_HEARTBEAT_LOSS_S: Final = 1.0
_NEVER_HEARD_S: Final = 5.0
_HIL_LOST_S: Final = 0.5
_DAMAGE_WINDOW_S: Final = 10.0
_DAMAGE_LIMIT: Final = 0.01
# One bad frame of ten in a quiet window is no bad line yet.
_DAMAGE_LEAST: Final = 5


@dataclass(frozen=True, slots=True)
class Alarm:
    """One thing that is wrong now. `since_s` is Unix time."""

    id: AlarmId
    level: Level
    text: str
    since_s: float = 0.0
    params: Params = field(default_factory=dict)

    def as_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "id": self.id,
            "level": self.level,
            "since_s": self.since_s,
            "text": self.text,
            "params": self.params,
        }


class Alarms:
    """Looks some times a second; tells the viewers of each alarm that comes or goes."""

    def __init__(
        self,
        *,
        supervisor: Supervisor,
        board: Board,
        telemetry: Telemetry,
        simulator: Simulator,
        hil: Hil,
        recorder: Recorder | None,
        hub: Hub,
        steady_s: Callable[[], float],
    ) -> None:
        self._supervisor = supervisor
        self._board = board
        self._telemetry = telemetry
        self._simulator = simulator
        self._hil = hil
        self._recorder = recorder
        self._hub = hub
        self._steady_s = steady_s
        self._wanted_since_s: float | None = None
        self._frames = deque([(steady_s(), 0, 0)])
        self._active: dict[AlarmId, Alarm] = {}

    @property
    def active(self) -> list[Alarm]:
        """All that is wrong now, oldest first."""
        return list(self._active.values())

    def look(self, t_s: float) -> bool:
        """See what is wrong at Unix time `t_s`. True where an alarm came or went."""
        steady_s = self._steady_s()
        found = [
            alarm
            for alarm in (
                self._heartbeat(steady_s),
                self._hil_loop(steady_s),
                self._damage(steady_s),
                self._recording(),
            )
            if alarm is not None
        ]
        current = {
            alarm.id: Alarm(
                alarm.id,
                alarm.level,
                alarm.text,
                self._active[alarm.id].since_s if alarm.id in self._active else t_s,
                alarm.params,
            )
            for alarm in found
        }
        gone = [alarm for alarm in self._active.values() if alarm.id not in current]
        come = [alarm for alarm in current.values() if alarm.id not in self._active]
        self._active = current
        for alarm in come:
            self._hub.event("alarm", {**alarm.as_dict(), "active": True})
        for alarm in gone:
            self._hub.event("alarm", {**alarm.as_dict(), "active": False})
        return bool(come or gone)

    def _heartbeat(self, steady_s: float) -> Alarm | None:
        if self._supervisor.address is None:
            self._wanted_since_s = None
            return None
        if self._wanted_since_s is None:
            self._wanted_since_s = steady_s
        target = self._supervisor.address.target
        age_s = self._telemetry.age_s("heartbeat")
        heard = self._board.session.heartbeat_s is not None
        if self._supervisor.failure is not None and (heard or self._supervisor.state == "lost"):
            return Alarm("heartbeat_lost", "critical", self._supervisor.failure.detail, params={"target": target})
        limit_s = max(self._telemetry.stale_after_s("heartbeat") or 0.0, _SHORTEST_HEARTBEAT_LOSS_S)
        if heard and age_s is not None and age_s > limit_s:
            text = f"The board on {target} is silent: check its power and the line."
            return Alarm("heartbeat_lost", "critical", text, params={"target": target})
        if not heard and steady_s - self._wanted_since_s > _NEVER_HEARD_S:
            text = f"Nothing that a board sends came from {target}: check that it is on, the port and the baud rate."
            return Alarm("no_heartbeat", "warning", text, params={"target": target})
        return None

    def _hil_loop(self, steady_s: float) -> Alarm | None:
        hil = self._hil
        if self._simulator.address is None or hil.last_to_board_s is None or self._supervisor.address is None:
            return None
        if steady_s - hil.last_to_board_s > _HIL_LOST_S:
            if not self._board.is_open:
                text = "The HIL loop is open: the board gets no simulator data. Check the board's link."
            elif self._simulator.state == "open" and hil.missing_rows:
                text = f"The HIL loop is open: rows {hil.missing_rows} are missing. Tick them in the data output."
            else:
                text = "The HIL loop is open: the simulator sends nothing. Check that it runs and where it sends to."
            return Alarm("hil_lost", "critical", text)
        answered_s = hil.last_surfaces_s
        if answered_s is None or steady_s - answered_s > _HIL_LOST_S:
            return Alarm(
                "hil_lost", "critical", "The HIL loop is open: the board does not answer the simulator's data."
            )
        return None

    def _damage(self, steady_s: float) -> Alarm | None:
        self._frames.append((steady_s, self._board.frames_received, self._board.frames_damaged))
        while self._frames[0][0] < steady_s - _DAMAGE_WINDOW_S:
            self._frames.popleft()
        good = self._board.frames_received - self._frames[0][1]
        damaged = self._board.frames_damaged - self._frames[0][2]
        if damaged < _DAMAGE_LEAST or damaged <= _DAMAGE_LIMIT * (good + damaged):
            return None
        percent = round(100.0 * damaged / (good + damaged), 1)
        text = f"{percent:g} % of the board's frames are damaged: check baud rate, cable and radio."
        return Alarm("frames_damaged", "warning", text, params={"percent": percent})

    def _recording(self) -> Alarm | None:
        if self._recorder is None or self._recorder.failure is None:
            return None
        reason = self._recorder.failure
        text = f"The flight is not being recorded ({reason}): free the disk or correct the folder's permissions."
        return Alarm("recorder_failed", "critical", text, params={"reason": reason})
