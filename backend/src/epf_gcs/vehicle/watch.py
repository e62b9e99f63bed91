"""The alarms that the board's own bytes tell, live as in a replay."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from epf_gcs.contract.base import Values
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.flight_figures import FlightFigures
from epf_gcs.vehicle.flight_judges import BatteryJudge, LimitJudge, ReceiverJudge
from epf_gcs.vehicle.judges import (
    CpuJudge,
    DamageJudge,
    Finding,
    GpsJudge,
    Line,
    Loop,
    judge_card,
    judge_heartbeat,
    judge_hil,
    judge_pause,
)
from epf_gcs.vehicle.telemetry import Telemetry


class WatchState(NamedTuple):
    """What each rule remembers, as its `kept` gives it."""

    battery: list[Any]
    receiver: list[Any]
    limits: dict[str, list[Any]]
    flight: list[Any]
    cpu: list[Any]
    gps: list[Any]
    damage: list[Any]


class VehicleWatch:
    """Told the time of the clock by which the vehicle's ages count, in seconds."""

    def __init__(self, board: Board, telemetry: Telemetry, now_s: float) -> None:
        self._board = board
        self._telemetry = telemetry
        self.battery = BatteryJudge()
        self._cpu = CpuJudge()
        self._gps = GpsJudge()
        self._damage = DamageJudge(now_s)
        self._receiver = ReceiverJudge()
        self._limits = {
            "altitude_high_ft": LimitJudge(
                "altitude_high", "warning", "The aircraft is at {value} ft, above the limit of {limit} ft: descend."
            ),
            "airspeed_low_kt": LimitJudge(
                "airspeed_low",
                "critical",
                "The airspeed is {value} kt, below {limit} kt: lower the nose, more throttle.",
                is_least=True,
            ),
            "airspeed_high_kt": LimitJudge(
                "airspeed_high",
                "warning",
                "The airspeed is {value} kt, above {limit} kt: less throttle, raise the nose.",
            ),
            "distance_far_m": LimitJudge(
                "distance_far", "warning", "The aircraft is {value} m from where its flight began, beyond {limit} m."
            ),
            "satellites_few": LimitJudge(
                "satellites_few",
                "warning",
                "The GPS uses {value} satellites, fewer than {limit}: do not trust its position.",
                is_least=True,
            ),
        }
        self._flight = FlightFigures()

    @property
    def damaged_percent(self) -> float:
        """Share of damaged frames in the last ten seconds, in percent; 0 if there are too few frames."""
        return self._damage.percent

    def look(
        self,
        now_s: float,
        limits: Mapping[str, float],
        line: Line | None,
        loop: Loop | None,
        simulator: Sequence[Finding | None] = (),
        *,
        wants_gps: bool,
    ) -> list[Finding]:
        """All that is wrong now, the most urgent kinds first. `line` None: no board is wanted; `loop` None: no HIL;
        `simulator`: what its rows tell."""
        board = self._board
        found = (
            judge_heartbeat(line, limits["heartbeat_lost_s"]),
            judge_hil(loop, limits["hil_lost_s"]),
            *simulator,
            judge_pause(loop),
            self.battery.look(now_s, self._live("analog"), limits),
            self._receiver.look(now_s, self._live("servos_in")),
            self._look_at_gps(now_s, is_wanted=wants_gps),
            *self._look_at_limits(now_s, limits),
            self._cpu.look(now_s, self._live("statistics"), limits["cpu_high_percent"]),
            self._damage.look(now_s, board.frames_received, board.frames_damaged, limits["frames_damaged_percent"]),
            judge_card(board.capabilities()),
        )
        return [finding for finding in found if finding is not None]

    def forget_gps(self) -> None:
        """No board is wanted: forget that there was a position."""
        self._gps.forget()

    def kept(self) -> WatchState:
        """For `restore`."""
        return WatchState(
            battery=self.battery.kept(),
            receiver=self._receiver.kept(),
            limits={name: judge.kept() for name, judge in self._limits.items()},
            flight=self._flight.kept(),
            cpu=self._cpu.kept(),
            gps=self._gps.kept(),
            damage=self._damage.kept(),
        )

    def restore(self, kept: WatchState) -> None:
        """Go on from what `kept` gave."""
        self.battery.restore(kept.battery)
        self._receiver.restore(kept.receiver)
        for name, judge in self._limits.items():
            judge.restore(kept.limits[name])
        self._flight.restore(kept.flight)
        self._cpu.restore(kept.cpu)
        self._gps.restore(kept.gps)
        self._damage.restore(kept.damage)

    def _look_at_limits(self, now_s: float, limits: Mapping[str, float]) -> list[Finding | None]:
        values = self._flight.of(self._live("analog"), self._live("gps"), limits["airspeed_low_kt"])
        return [judge.look(now_s, values[name], limits[name]) for name, judge in self._limits.items()]

    def _live(self, topic: str) -> Values | None:
        return self._telemetry.newest(topic) if self._telemetry.is_live(topic) else None

    def _look_at_gps(self, now_s: float, *, is_wanted: bool) -> Finding | None:
        """Judge the GPS only while heartbeats arrive: a silent board has its own alarm."""
        heartbeat = self._live("heartbeat")
        if heartbeat is None:
            self._gps.wait()
            return None
        return self._gps.look(now_s, self._live("gps"), is_wanted=is_wanted or heartbeat.get("gps") is True)
