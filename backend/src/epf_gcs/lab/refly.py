"""Flies a recording again: another build of the laws is told what the recorded board was told, in the same order and at
the same times, and what it answers is held against what was recorded.

Compared are the answers that the line alone decides: the surfaces and, where the board tells them, the times of its
steps, the plan of HIL, and the gains. Equal is equal to the byte where the board told the times of its steps
(`hil_step`); else the times are those of the station, and surfaces are equal within `TOLERANCE`.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import takewhile
from pathlib import Path
from typing import Final

from epf_gcs.codec.checksum import MASK
from epf_gcs.codec.frame import Frame, FrameDecoder
from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.lab.laws import FMS_TASK, Laws
from epf_gcs.lab.recorded_line import STEP, SURFACES, Answered, RecordedLine, Told, read_line

TOLERANCE: Final = 0.01
"""By how much a surface (-1..1) may differ where the station guessed the times of the board's steps."""
AFTER_S: Final = (0.0, 0.1, 1.0, 10.0, 60.0)
"""How long after the first difference its growth is told."""

_INFO: Final = "xplane_info"
_PLAN: Final = "fms_hil_plan"
_GAINS: Final = "autopilot_parameters"
_LOAD_GAINS: Final = COMMANDS["load_autopilot_parameters"]


@dataclass(frozen=True, slots=True)
class Difference:
    """A value that came out otherwise. `frame`: how many commands 50 were answered before, from 0."""

    frame: int
    at_s: float
    signal: str
    recorded: float
    now: float

    @property
    def size(self) -> float:
        """How far the two are apart; infinite where one of them is no number."""
        apart = abs(self.now - self.recorded)
        return apart if math.isfinite(apart) else math.inf


@dataclass(slots=True)
class Refly:
    """What came of it. `frames`: answered commands 50; `differences`: of the surfaces all, of the rest those before the
    first of the surfaces; `until_s`: where the comparison had to end before the recording did, and `why`."""

    is_exact: bool
    frames: int = 0
    differences: list[Difference] = field(default_factory=list)
    until_s: float | None = None
    why: str = ""
    has_receiver: bool = False

    @property
    def first(self) -> Difference | None:
        """The first difference; None if all is equal."""
        return self.differences[0] if self.differences else None

    def growth(self) -> list[tuple[float, float]]:
        """Seconds since the first difference, and the largest one of its signal until then."""
        first = self.first
        if first is None:
            return []
        same = [one for one in self.differences if one.signal == first.signal]
        return [(s, max(one.size for one in same if one.at_s <= first.at_s + s)) for s in AFTER_S]

    def lines(self) -> Iterator[str]:
        """For a person."""
        kind = "to the byte" if self.is_exact else f"within {TOLERANCE:g}, at the times of the station"
        first = self.first
        if first is None:
            yield f"{self.frames} answers, all equal {kind}"
        else:
            yield f"{self.frames} answers, compared {kind}"
            yield (
                f"  first difference   frame {first.frame}, after {first.at_s:.3f} s: {first.signal} is "
                f"{first.now:.9g}, was {first.recorded:.9g}"
            )
            yield f"  how it grows       {', '.join(f'{size:.3g} after {s:g} s' for s, size in self.growth())}"
        if first is not None and self.has_receiver:
            yield "  the stick came from the board's receiver for a while, which is in no recording"
        if self.until_s is not None:
            yield f"  compared until {self.until_s:.1f} s: {self.why}"


def refly(recording: Path, library: Path | None = None) -> Refly:
    """Fly a recording again with these laws. Raises LabError if it cannot be."""
    return refly_line(read_line(recording), library)


def refly_line(line: RecordedLine, library: Path | None = None) -> Refly:
    """The same, of what a recording holds of the board's line."""
    return _Flying(line, library).fly()


class _Flying:
    def __init__(self, line: RecordedLine, library: Path | None) -> None:
        self._line = line
        self._period_s = line.period_s()
        self._laws = Laws(self._period_s, library)
        self._decoder = FrameDecoder()
        self._told = deque(line.told)
        self._clock_ms = 0
        self._newest: dict[str, Frame] = {}
        self._found = Refly(line.has_steps, has_receiver=line.has_receiver)

    def fly(self) -> Refly:
        try:
            for command in self._line.before:
                self._feed(command)
            for answered in self._line.answered:
                if not self._compare(answered):
                    break
        finally:
            self._laws.close()
        if self._line.damaged_at_s is not None and self._found.until_s is None:
            self._end(self._line.damaged_at_s, "a frame of the board is damaged in the recording")
        return self._found

    def _compare(self, answered: Answered) -> bool:
        """False where no further answer can be compared."""
        name = answered.frame.message.name
        if name == SURFACES:
            return self._compare_surfaces(answered)
        if name == "acknowledgement":
            type_id = answered.frame.values[0] & MASK
            # The gains are told since their other answer came.
            if type_id != _LOAD_GAINS.id:
                self._tell_taken(type_id)
        elif name == _PLAN:
            self._feed_streams()
            if self._found.is_exact:
                self._hold(answered, self._newest.get(name))
        elif name == _GAINS:
            self._tell_taken(_LOAD_GAINS.id)
            self._hold(answered, self._newest.get(name))
        return True

    def _compare_surfaces(self, answered: Answered) -> bool:
        if not self._tell_info(answered):
            return self._end(answered.t_s, "the board answered more than it was told")
        now, step = self._newest.pop(SURFACES, None), self._newest.pop(STEP, None)
        if now is None:
            return self._end(answered.t_s, "these laws do not answer")
        if answered.step is not None and step is not None:
            self._note(answered.t_s, "step_s", answered.step[1], step.values[1])
        self._hold(answered, now)
        self._found.frames += 1
        return True

    def _hold(self, answered: Answered, now: Frame | None) -> None:
        if now is None or now.payload == answered.frame.payload:
            return
        for value, recorded, own in zip(now.message.values, answered.frame.values, now.values, strict=True):
            self._note(answered.t_s, value.name, recorded, own)

    def _note(self, at_s: float, signal: str, recorded: float, now: float) -> None:
        one = Difference(self._found.frames, at_s, signal, float(recorded), float(now))
        is_same = recorded == now or (math.isnan(recorded) and math.isnan(now))
        if not is_same and (self._found.is_exact or one.size > TOLERANCE):
            self._found.differences.append(one)

    def _end(self, at_s: float, why: str) -> bool:
        self._found.until_s, self._found.why = at_s, why
        return False

    def _tell_info(self, answered: Answered) -> bool:
        """Tell what comes before the next command 50, and that one; whether one came."""
        while self._told:
            told = self._told.popleft()
            if told.name == _INFO:
                self._advance(told, answered)
            self._feed(told.data)
            if told.name == _INFO:
                return True
        return False

    def _tell_taken(self, type_id: int) -> None:
        """The board has answered this command: it took it, and those before it, before it sends anything else."""
        coming = list(takewhile(lambda told: told.name != _INFO, self._told))
        for number, told in enumerate(coming):
            if told.name and COMMANDS[told.name].id == type_id:
                for one in coming[: number + 1]:
                    self._feed(one.data)
                    self._told.popleft()
                return

    def _advance(self, told: Told, answered: Answered) -> None:
        """Let the board's time pass until it takes this command 50."""
        if self._period_s > 0.0:
            return
        now_ms = round(told.t_s * 1000.0)
        if answered.step is not None:
            now_ms = answered.step[0]
        self._laws.advance((now_ms - self._clock_ms) & MASK)
        self._laws.supervise()
        self._clock_ms = now_ms

    def _feed_streams(self) -> None:
        self._read(self._laws.send_streams(FMS_TASK))

    def _feed(self, data: bytes) -> None:
        self._read(self._laws.feed(data))

    def _read(self, data: bytes) -> None:
        for found in self._decoder.feed(data):
            if isinstance(found, Frame):
                self._newest[found.message.name] = found
