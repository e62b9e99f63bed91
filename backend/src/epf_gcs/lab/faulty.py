"""Flights in which something fails, as it was asked for, and only if it did."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from struct import Struct
from typing import Final

from epf_gcs.codec.encode import frame_bytes
from epf_gcs.codec.frame import TO_BOARD
from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.contract.simulator_faults import Fault
from epf_gcs.lab.answers import Answers
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.faults import check_hil
from epf_gcs.lab.laws import Laws
from epf_gcs.lab.lock_step import LockStep
from epf_gcs.simulator.effects import SENSORS, SERVOS, Effect, GustEffect, LineEffect, SensorEffect, ServoEffect
from epf_gcs.simulator.simulation import SimulationOptions
from epf_gcs.simulator.state import Controls

_INFO: Final = COMMANDS["xplane_info"]
_FIELDS: Final = tuple(value.name for value in _INFO.values)
_PAYLOAD: Final = slice(8, 8 + _INFO.size)
_VALUES: Final = Struct(_INFO.struct.format)


class FaultyLockStep(LockStep):
    """A flight with faults on the path of HIL. The board measures the time of its steps, as deployed, because it flies
    on while nothing reaches it. Raises LabError for a fault that this path cannot carry."""

    fields: Sequence[str] = _FIELDS

    def __init__(self, options: SimulationOptions, faults: Sequence[Fault], library: Path | None = None) -> None:
        self._check(faults)
        seed = options.situation.seed
        period_s = 1.0 / options.rate_hz
        self._sensors = [SensorEffect(one, seed, self.fields) for one in faults if one.place in SENSORS]
        self._servos = [ServoEffect(one, seed, period_s) for one in faults if one.place in SERVOS]
        self._lines = [LineEffect(one, seed) for one in faults if one.place == "line"]
        self._to_board = [line.direction("to", line.flipped) for line in self._lines]
        self._to_station = [line.direction("from", line.flipped) for line in self._lines]
        self._gusts = [GustEffect(one, seed) for one in faults if one.place == "wind"]
        self._pauses = [Effect(one, seed) for one in faults if one.place == "simulator"]
        self._resets = [Effect(one, seed) for one in faults if one.place == "board"]
        self._newest = b""
        self._elapsed_ms = 0
        self._ticks = 0
        super().__init__(options, library)

    def evidence(self) -> tuple[str, ...]:
        """What shows that each fault was there. Raises LabError for one that was not."""
        return tuple(self._evidence(effect) for effect in self._effects())

    def _check(self, faults: Sequence[Fault]) -> None:
        check_hil(faults)

    def _effects(self) -> list[Effect]:
        return [*self._sensors, *self._servos, *self._lines, *self._gusts, *self._pauses, *self._resets]

    def _evidence(self, effect: Effect) -> str:
        shown = effect.evidence()
        if shown is not None:
            return shown
        fault = effect.fault
        why = "what arrived is what was sent"
        if fault.start_s >= self.time_s:
            why = f"the flight ended after {self.time_s:.1f} s"
        raise LabError(f"the fault {fault} was asked for and was not there: {why}")

    def _new_board(self) -> Laws:
        return Laws(0.0, self._library)

    def _frame(self) -> tuple[float, float]:
        for pause in self._pauses:
            if self._begins(pause):
                self._stand_still(pause)
        for reset in self._resets:
            if self._begins(reset):
                self._start_anew()
        self._tick()
        if self._gusts:
            self._craft.gust(sum(gust.more_kt(self.time_s) for gust in self._gusts))
        return super()._frame()

    def _begins(self, effect: Effect) -> bool:
        return effect.fault.is_on(self.time_s) and not effect.fault.is_on(self.time_s - 1.0 / self._rate_hz)

    def _tick(self) -> None:
        """A frame's time passes on the board."""
        self._ticks += 1
        due_ms = round(self._ticks * 1000.0 / self._rate_hz)
        self._laws.advance(due_ms - self._elapsed_ms)
        self._elapsed_ms = due_ms
        self._laws.supervise()

    def _stand_still(self, pause: Effect) -> None:
        """The aircraft hangs still while the board's time runs."""
        for _ in range(round(pause.fault.length * self._rate_hz)):
            self._tick()
            pause.show()
            if pause.fault.kind == "pause" and self._newest:
                self._take(self._laws.feed(self._newest))

    def _start_anew(self) -> None:
        self._laws.close()
        self._laws = self._new_board()
        self._answers = self._new_answers()

    def _moved(self) -> Controls:
        controls = self._controls
        for servo in self._servos:
            controls = servo.change(self.time_s, controls)
        return controls

    def _told(self, values: Sequence[float]) -> bytes:
        frame = super()._told(values)
        if not self._sensors:
            return frame
        told = list(_VALUES.unpack(frame[_PAYLOAD]))
        for sensor in self._sensors:
            sensor.change(self.time_s, told)
        return frame_bytes(TO_BOARD, _INFO, _VALUES.pack(*told))

    def _give(self, arrived: list[bytes]) -> None:
        for to_board in self._to_board:
            arrived = to_board.carry(self.time_s, arrived)
        for reset in self._resets:
            if reset.fault.is_on(self.time_s):
                reset.show()
                arrived = []
        answers = [answer for told in arrived if (answer := self._laws.feed(told))]
        self._newest = arrived[-1] if arrived else self._newest
        for to_station in self._to_station:
            answers = to_station.carry(self.time_s, answers)
        for answer in answers:
            self._take(answer)

    def _new_answers(self) -> Answers:
        return Answers(self._plan_stream, is_line_sound=not any(line.fault.kind == "flipped" for line in self._lines))
