"""Which of several sendings an acknowledgement belongs to: it names only the command's type."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from typing import Final

from epf_gcs.codec.frame import Frame
from epf_gcs.codec.messages_gen import COMMANDS, TELEMETRY_BY_NAME
from epf_gcs.codec.values import Meaning

# A command without effect that every acknowledging board acknowledges, in the order of sending.
FENCE: Final = COMMANDS["capabilities"]
# Acknowledged only when the card has written, after commands that were sent later: a fence proves nothing here.
_OUT_OF_ORDER: Final = frozenset({COMMANDS["store_parameters"].id})
# After this long without the card's acknowledgement, expect it no more.
_OWED_S: Final = 10.0

_RESULTS: Final = {
    number: name
    for value in TELEMETRY_BY_NAME["acknowledgement"].values
    if value.name == "result"
    for name, number in value.names.items()
}


class OutstandingAcknowledgements:
    """How many acknowledgements of each command type are still outstanding."""

    def __init__(self, steady_s: Callable[[], float]) -> None:
        self._steady_s = steady_s
        self._counts: Counter[int] = Counter()
        self._last_s: dict[int, float] = {}

    def sent(self, command_id: int) -> None:
        """One more was sent."""
        # From `of`: what is expected no longer is not expected again because of this one.
        self._counts[command_id] = self.of(command_id) + 1
        self._last_s[command_id] = self._steady_s()

    def on_frame(self, frame: Frame, meant: Meaning) -> None:
        """Take an acknowledgement of the board: it lowers the count of its type."""
        command_id = meant.values["command_type"]
        if isinstance(command_id, int) and self._counts[command_id] > 0:
            self._counts[command_id] -= 1

    def none_before(self, command_id: int, sendings: int) -> None:
        """Expect acknowledgements only for the last `sendings` commands of this type, not for earlier ones."""
        self._counts[command_id] = min(self._counts[command_id], sendings)

    def of(self, command_id: int) -> int:
        """How many acknowledgements of this type may still come for earlier sendings."""
        if command_id in _OUT_OF_ORDER and self._steady_s() - self._last_s.get(command_id, -_OWED_S) >= _OWED_S:
            return 0
        return self._counts[command_id]


class AcknowledgementJudge:
    """Finds the outcome of one command and skips the acknowledgements of earlier commands of its type.

    While earlier ones are owed, a fence is sent before the command: the board answers in order, so whatever comes
    before the fence's acknowledgement is old. Where the board does not keep the order, the owed ones are counted.
    """

    def __init__(self, command_id: int, owed: OutstandingAcknowledgements) -> None:
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
        """Whether the command was done, and the board's result name; None if the frame says nothing about it."""
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
