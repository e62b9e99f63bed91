"""Which sending an acknowledgement belongs to: it names the command's type and nothing else."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from typing import Final

from epf_gcs.codec.frame import Frame
from epf_gcs.codec.messages_gen import COMMANDS, TELEMETRY_BY_NAME
from epf_gcs.codec.values import Meaning

# Changes nothing, and every board that acknowledges at all acknowledges it, in the order in which it was asked.
FENCE: Final = COMMANDS["capabilities"]
# The board acknowledges this one when its card is done, and meanwhile others: a fence says nothing of it.
_OUT_OF_ORDER: Final = frozenset({COMMANDS["store_parameters"].id})
# A card that did not answer for this long will not answer.
_OWED_S: Final = 10.0

_RESULTS: Final = {
    number: name
    for value in TELEMETRY_BY_NAME["acknowledgement"].values
    if value.name == "result"
    for name, number in value.names.items()
}


class Owed:
    """How many acknowledgements of each type are still to come for what was sent."""

    def __init__(self, steady_s: Callable[[], float]) -> None:
        self._steady_s = steady_s
        self._counts: Counter[int] = Counter()
        self._last_s: dict[int, float] = {}

    def sent(self, command_id: int) -> None:
        """One more was sent."""
        self._counts[command_id] += 1
        self._last_s[command_id] = self._steady_s()

    def on_frame(self, frame: Frame, meant: Meaning) -> None:
        """A frame of the board: one less is owed where it acknowledges something."""
        if frame.message.name == "acknowledgement":
            command_id = meant.values["command_type"]
            if isinstance(command_id, int) and self._counts[command_id] > 0:
                self._counts[command_id] -= 1

    def none_before(self, command_id: int, sendings: int) -> None:
        """What was sent before these last sendings will not be acknowledged any more."""
        self._counts[command_id] = min(self._counts[command_id], sendings)

    def of(self, command_id: int) -> int:
        """How many acknowledgements of this type may come that belong to earlier sendings."""
        if command_id in _OUT_OF_ORDER and self._steady_s() - self._last_s.get(command_id, -_OWED_S) >= _OWED_S:
            return 0
        return self._counts[command_id]


class AcknowledgementJudge:
    """Sees in a frame what became of one command, and passes over the acknowledgements of earlier ones of its type.

    While earlier ones are owed, a fence is sent before the command: the board answers in order, so whatever comes
    before the fence's acknowledgement is old. Where the board does not keep the order, the owed ones are counted.
    """

    def __init__(self, command_id: int, owed: Owed) -> None:
        self._id = command_id
        self._owed = owed
        self._sendings = 0
        before = owed.of(command_id)
        keeps_order = command_id not in _OUT_OF_ORDER and command_id != FENCE.id
        self.is_fenced = keeps_order and before > 0
        self._passes = 0 if keeps_order else before

    def sent(self) -> None:
        """The command went out, behind a fence where `is_fenced`."""
        self._sendings += 1
        self._owed.sent(self._id)

    def __call__(self, frame: Frame, meant: Meaning) -> tuple[bool, str] | None:
        """Whether it was done, and the board's word for it; None where the frame does not tell."""
        if frame.message.name != "acknowledgement":
            return None
        command_id = meant.values["command_type"]
        if self.is_fenced:
            if command_id == FENCE.id:
                self.is_fenced = False
                self._owed.none_before(self._id, self._sendings)
            return None
        if command_id != self._id:
            return None
        if self._passes > 0:
            self._passes -= 1
            return None
        result = _RESULTS.get(frame.values[1], "unknown")
        return result == "done", result
