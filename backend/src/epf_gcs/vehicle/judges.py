"""The rules that find what is wrong. They keep only the state that a rule needs, and get the time from the caller."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from typing import Any, Final, Literal

from epf_gcs.contract.alarm_ids import AlarmId
from epf_gcs.contract.base import Values
from epf_gcs.vehicle.unusable_value import UnusableValue

Level = Literal["warning", "critical"]
Params = dict[str, str | int | float | bool | None]

LASTS_S: Final = 3.0
HICCUP_S: Final = 1.0
_NEVER_HEARD_S: Final = 5.0
_GPS_LASTS_S: Final = 1.0
_DAMAGE_WINDOW_S: Final = 10.0
# Fewer damaged frames than this raise no alarm: in a quiet window a single one would be a large share.
_DAMAGE_LEAST: Final = 5


@dataclass(frozen=True, slots=True)
class Finding:
    """One thing that is wrong now: a sentence with what to do, and the values in it."""

    id: AlarmId
    level: Level
    text: str
    params: Params = field(default_factory=dict)


class Debounce:
    """Debounces a condition: `holds` changes only after the condition has differed from it for `lasts_s`.

    An unknown condition does not hold, but only after `HICCUP_S`: a short gap of the line changes nothing.
    """

    def __init__(self, lasts_s: float) -> None:
        self._lasts_s = lasts_s
        self._other_since_s: float | None = None
        self._unknown_since_s: float | None = None
        self.holds = False

    def look(self, now_s: float, *, condition: bool | None) -> bool:
        """Whether the condition holds at `now_s`. None: unknown."""
        if condition is None:
            self._other_since_s = None
            if self._unknown_since_s is None:
                self._unknown_since_s = now_s
            if now_s - self._unknown_since_s >= HICCUP_S:
                self.holds = False
            return self.holds
        self._unknown_since_s = None
        if condition == self.holds:
            self._other_since_s = None
        elif self._other_since_s is None:
            self._other_since_s = now_s
        if self._other_since_s is not None and now_s - self._other_since_s >= self._lasts_s:
            self.holds = condition
            self._other_since_s = None
        return self.holds

    def kept(self) -> list[Any]:
        """Plain values for `restore`; so with all rules that remember something."""
        return [self._other_since_s, self._unknown_since_s, self.holds]

    def restore(self, kept: Sequence[Any]) -> None:
        """Go on from what `kept` gave."""
        self._other_since_s, self._unknown_since_s, self.holds = kept

    def reset(self) -> None:
        """Set `holds` to False at once."""
        self.holds = False
        self._other_since_s = self._unknown_since_s = None


class CpuJudge:
    """The load of the board's two processors."""

    def __init__(self) -> None:
        self._high = Debounce(LASTS_S)
        self._said_percent = 0

    def kept(self) -> list[Any]:
        """Plain values for `restore`."""
        return [self._high.kept(), self._said_percent]

    def restore(self, kept: Sequence[Any]) -> None:
        """Go on from what `kept` gave."""
        high, self._said_percent = kept
        self._high.restore(high)

    def look(self, now_s: float, live: Values | None, high_percent: float) -> Finding | None:
        """`live` is the newest sample of statistics, None while it is not live."""
        loads = [] if live is None else [load for load in live.values() if load is not None]
        is_high = max(loads) > high_percent if loads else None
        if is_high:
            self._said_percent = max(loads)
        if not self._high.look(now_s, condition=is_high):
            return None
        text = f"A processor of the board is {self._said_percent} % busy: lower the rates of its streams."
        return Finding("cpu_high", "warning", text, {"percent": self._said_percent})


class GpsJudge:
    """The position: no fix, no validity, or no sample although the stream is wanted."""

    def __init__(self) -> None:
        self._lost = Debounce(_GPS_LASTS_S)
        self._said: Finding | None = None
        self._was_valid = False

    def kept(self) -> list[Any]:
        """Plain values for `restore`."""
        return [self._lost.kept(), None if self._said is None else asdict(self._said), self._was_valid]

    def restore(self, kept: Sequence[Any]) -> None:
        """Go on from what `kept` gave."""
        lost, said, self._was_valid = kept
        self._lost.restore(lost)
        self._said = None if said is None else Finding(**said)

    def forget(self) -> None:
        """No board is wanted: forget that there was a position."""
        self._was_valid = False
        self.wait()

    def wait(self) -> None:
        """The board as a whole is silent, which is not the receiver's fault: no GPS alarm."""
        self._lost.reset()

    def look(self, now_s: float, live: Values | None, *, is_wanted: bool) -> Finding | None:
        """`live` is the newest sample of gps, None while it is not live."""
        if live is None and not is_wanted:
            self._lost.reset()
            return None
        is_valid = live is not None and bool(live.get("fix")) and live.get("valid") is True
        self._was_valid = self._was_valid or is_valid
        # A receiver that never had a valid position may not be installed: its silence is not a loss.
        is_lost = not is_valid if live is not None or self._was_valid else None
        if is_lost:
            self._said = _gps_silent() if live is None else _gps_without_fix(critical=self._was_valid)
        return self._said if self._lost.look(now_s, condition=is_lost) else None


def _gps_silent() -> Finding:
    text = "The GPS is lost: its stream stopped. Check the receiver and the line."
    return Finding("gps_lost", "critical", text, {"reason": "silent"})


def _gps_without_fix(*, critical: bool) -> Finding:
    text = "The GPS has no valid position: check its antenna and its view of the sky."
    return Finding("gps_lost", "critical" if critical else "warning", text, {"reason": "no_fix"})


class DamageJudge:
    """The share of damaged frames of the last ten seconds."""

    def __init__(self, now_s: float) -> None:
        self._counts = deque([(now_s, 0, 0)])
        self.percent = 0.0

    def kept(self) -> list[Any]:
        """Plain values for `restore`."""
        return [list(self._counts), self.percent]

    def restore(self, kept: Sequence[Any]) -> None:
        """Go on from what `kept` gave."""
        counts, self.percent = kept
        self._counts = deque((now_s, good, damaged) for now_s, good, damaged in counts)

    def look(self, now_s: float, good: int, damaged: int, limit_percent: float) -> Finding | None:
        """`good` and `damaged` are counters that only grow."""
        self._counts.append((now_s, good, damaged))
        while self._counts[0][0] < now_s - _DAMAGE_WINDOW_S:
            self._counts.popleft()
        good -= self._counts[0][1]
        damaged -= self._counts[0][2]
        self.percent = 100.0 * damaged / (good + damaged) if damaged >= _DAMAGE_LEAST else 0.0
        if self.percent <= limit_percent:
            return None
        percent = round(self.percent, 1)
        text = f"{percent:g} % of the board's frames are damaged: check baud rate, cable and radio."
        return Finding("frames_damaged", "warning", text, {"percent": percent})


@dataclass(frozen=True, slots=True)
class Line:
    """What is known of the board's line. Ages and times in seconds; `failure` is why the link is not open."""

    target: str
    wanted_for_s: float
    is_lost: bool
    was_heard: bool
    heartbeat_age_s: float | None
    stale_after_s: float | None
    failure: str | None


def judge_heartbeat(line: Line | None, lost_s: float) -> Finding | None:
    """`line` is None while no board is wanted."""
    if line is None:
        return None
    params: Params = {"target": line.target}
    if line.failure is not None and (line.was_heard or line.is_lost):
        return Finding("heartbeat_lost", "critical", line.failure, params)
    limit_s = max(line.stale_after_s or 0.0, lost_s)
    if line.was_heard and line.heartbeat_age_s is not None and line.heartbeat_age_s > limit_s:
        text = f"The board on {line.target} is silent: check its power and the line."
        return Finding("heartbeat_lost", "critical", text, params)
    if not line.was_heard and line.wanted_for_s > _NEVER_HEARD_S:
        text = f"Nothing that a board sends came from {line.target}: check that it is on, the port and the baud rate."
        return Finding("no_heartbeat", "warning", text, params)
    return None


@dataclass(frozen=True, slots=True)
class Loop:
    """What is known of the HIL loop after its first data have gone to the board. Times in seconds."""

    to_board_age_s: float
    unanswered_s: float
    """Since the board's newest surfaces; since the first data that went to it while none have come."""
    is_board_open: bool
    is_simulator_open: bool
    missing_rows: Sequence[int]
    unusable: Sequence[UnusableValue] = ()
    is_paused: bool = False


def judge_hil(loop: Loop | None, lost_s: float) -> Finding | None:
    """`loop` is None while HIL is not in use."""
    if loop is None:
        return None
    if loop.to_board_age_s > lost_s:
        params: Params = {}
        if not loop.is_board_open:
            text = "The HIL loop is open: the board gets no simulator data. Check the board's link."
        elif loop.is_simulator_open and loop.missing_rows:
            text = f"The HIL loop is open: rows {list(loop.missing_rows)} are missing. Tick them in the data output."
        elif loop.is_simulator_open and loop.unusable:
            text, params = loop.unusable[0].sentence, asdict(loop.unusable[0].state)
        else:
            text = "The HIL loop is open: the simulator sends nothing. Check that it runs and where it sends to."
        return Finding("hil_lost", "critical", text, params)
    if loop.unanswered_s > lost_s:
        return Finding("hil_lost", "critical", "The HIL loop is open: the board does not answer the simulator's data.")
    return None


def judge_pause(loop: Loop | None) -> Finding | None:
    """`loop` is None while HIL is not in use."""
    if loop is None or not loop.is_paused:
        return None
    text = "The simulator is paused: its values are not live. Go on in the simulator when you are ready."
    return Finding("simulator_paused", "warning", text)


def judge_stick(gamepad: str | None, state: Literal["live", "lost"] | None, *, flies: bool) -> Finding | None:
    """`gamepad` is the one chosen as the pilot's stick; `flies`: the stick is the control source."""
    if gamepad is None or state != "lost":
        return None
    text = (
        f"Nothing arrives from the gamepad {gamepad}: the stick counts as let go, surfaces centred and then no "
        "throttle. Connect it, or go back to the simulator's joystick."
    )
    return Finding("stick_lost", "critical" if flies else "warning", text, {"gamepad": gamepad})


def judge_parameters(unconfirmed: Sequence[str]) -> Finding | None:
    """`unconfirmed` are the gains whose last write was refused or not answered."""
    if not unconfirmed:
        return None
    names = ", ".join(unconfirmed)
    text = f"The board did not confirm {names}: load the parameters and see what it has."
    return Finding("parameter_not_confirmed", "warning", text, {"names": names})


def judge_card(capabilities: Values) -> Finding | None:
    """`capabilities` are what the board reported about itself, empty while unknown."""
    if not capabilities.get("has_card_alarm"):
        return None
    text = (
        "The board's card failed: what it holds cannot be used or could not be stored. Defaults stand for what is "
        "missing: load the parameters, read the plans, and store them again."
    )
    return Finding("card_failed", "critical", text)


def judge_recording(failure: str | None) -> Finding | None:
    """`failure` is why the flight is not being recorded."""
    if failure is None:
        return None
    text = f"The flight is not being recorded ({failure}): free the disk or correct the folder's permissions."
    return Finding("recorder_failed", "critical", text, {"reason": failure})
