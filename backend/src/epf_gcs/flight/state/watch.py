"""Collects the state of the running parts and evaluates the alarm conditions."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from epf_gcs.contract.answers import BatteryPack
from epf_gcs.flight.board.parameters import Parameters
from epf_gcs.flight.recording.recorder import Recorder
from epf_gcs.flight.state.lines import BothLines
from epf_gcs.link.descriptor import DescriptorLink
from epf_gcs.link.read_budget import MOST_BYTES_PER_S
from epf_gcs.vehicle.judges import (
    Finding,
    Line,
    Loop,
    judge_parameters,
    judge_recording,
    judge_stick,
)
from epf_gcs.vehicle.surroundings import ToldSurroundings
from epf_gcs.vehicle.telemetry import Telemetry
from epf_gcs.vehicle.traffic_judges import FloodJudge, StrangersJudge
from epf_gcs.vehicle.watch import VehicleWatch


class Watch:
    """Called a few times a second with the thresholds; `wants(topic)`: whether a stream was requested."""

    def __init__(
        self,
        both: BothLines,
        *,
        telemetry: Telemetry,
        parameters: Parameters,
        recorder: Recorder | None,
        steady_s: Callable[[], float],
        wants: Callable[[str], bool],
        surroundings: ToldSurroundings,
    ) -> None:
        self._supervisor = both.supervisor
        self._board = both.board
        self._telemetry = telemetry
        self._parameters = parameters
        self._simulator = both.simulator
        self._hil = both.hil
        self._recorder = recorder
        self.surroundings = surroundings
        self._steady_s = steady_s
        self._wants = wants
        # The board that is wanted, since when, and when it was heard last, however often its line was opened again.
        self._target: str | None = None
        self._wanted_since_s = steady_s()
        self._heard_s: float | None = None
        self._vehicle = VehicleWatch(both.board, telemetry, steady_s())
        self._strangers = StrangersJudge(steady_s())
        self._flood = FloodJudge()

    @property
    def damaged_percent(self) -> float:
        """Share of damaged frames in the last ten seconds, in percent; 0 if there are too few frames."""
        return self._vehicle.damaged_percent

    def battery(self, limits: Mapping[str, float]) -> BatteryPack | None:
        """What the battery's alarm goes by; None while no voltage was measured."""
        return self._vehicle.battery.pack(limits)

    def __call__(self, limits: Mapping[str, float]) -> list[Finding]:
        """All alarm conditions that hold now, the most urgent kinds first."""
        now_s = self._steady_s()
        recorder = self._recorder
        if self._supervisor.address is None:
            self._vehicle.forget_gps()
        found = (
            *self.surroundings.look(now_s),
            *self._vehicle.look(
                now_s,
                limits,
                self._line(now_s),
                self._loop(now_s),
                self._hil.found,
                wants_gps=self._wants("gps"),
            ),
            self._flood.look(now_s, self._held_back(), MOST_BYTES_PER_S),
            self._strangers.look(now_s, self._simulator.dropped["stranger"], self._simulator.last_stranger),
            judge_stick(self._hil.stick.gamepad, self._hil.stick.state, flies=self._hil.source != "rc"),
            judge_parameters(self._parameters.unconfirmed),
            judge_recording(None if recorder is None else recorder.failure),
        )
        return [finding for finding in found if finding is not None]

    def _held_back(self) -> int:
        link = self._board.link
        return link.held_back if isinstance(link, DescriptorLink) else 0

    def _line(self, now_s: float) -> Line | None:
        supervisor = self._supervisor
        if supervisor.address is None or self._board.exclusive_user is not None:
            # While another user (the AHRS test) has the line, the board's silence is expected.
            self._target = None
            return None
        target = supervisor.address.target
        if target != self._target:
            self._target, self._wanted_since_s, self._heard_s = target, now_s, None
        # Each opening begins a session that has heard nothing yet: a board that spoke a moment ago is not silent.
        if self._board.session.heartbeat_s is not None:
            self._heard_s = now_s - (self._telemetry.age_s("heartbeat") or 0.0)
        return Line(
            target=target,
            wanted_for_s=now_s - self._wanted_since_s,
            is_lost=supervisor.state == "lost",
            was_heard=self._heard_s is not None,
            heartbeat_age_s=None if self._heard_s is None else now_s - self._heard_s,
            stale_after_s=self._telemetry.stale_after_s("heartbeat"),
            failure=None if supervisor.failure is None else supervisor.failure.detail,
        )

    def _loop(self, now_s: float) -> Loop | None:
        hil = self._hil
        if self._simulator.address is None or hil.last_to_board_s is None or self._supervisor.address is None:
            return None
        answered_s = hil.last_surfaces_s if hil.last_surfaces_s is not None else hil.first_to_board_s
        return Loop(
            to_board_age_s=now_s - hil.last_to_board_s,
            unanswered_s=0.0 if answered_s is None else now_s - answered_s,
            is_board_open=self._board.is_open,
            is_simulator_open=self._simulator.state == "open",
            missing_rows=hil.missing_rows,
            unusable=hil.unusable,
            is_paused=hil.is_paused,
        )
