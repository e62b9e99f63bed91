"""Statistics for each type of frame received from the board: good, damaged and of unknown type."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from typing import Any, Final

from epf_gcs.codec.checksum import checksum
from epf_gcs.codec.frame import Damage
from epf_gcs.codec.messages_gen import END, FORBIDDEN_TYPE_BITS, TELEMETRY, TO_PC_TYPE_BIT
from epf_gcs.codec.tables import Message
from epf_gcs.vehicle.arrivals import Arrivals
from epf_gcs.vehicle.health import TASK_OF_TOPIC

_WORD: Final = 4
# A bad line produces random types; unknown types beyond this number are not recorded.
_MOST_UNKNOWN: Final = 32


class FrameStatistics:
    """`heard` and `damaged` are by name of the message, the others by number of the type; `own` are the board's.

    A failed candidate's event holds its header only, so the type is read from the `remains` that follow it.
    """

    def __init__(self) -> None:
        self.heard: dict[str, Arrivals] = {message.name: Arrivals() for message in TELEMETRY.values()}
        self.damaged: Counter[str] = Counter()
        self.unknown: dict[int, Arrivals] = {}
        self.unknown_damaged: Counter[int] = Counter()
        self.own: dict[int, Message] = {}
        self._after_failure = False

    def learn(self, own: Iterable[Message]) -> None:
        """From now on the board's own messages are these; an earlier one's counts stay under its name."""
        self.own = {message.id: message for message in own}
        for message in self.own.values():
            self.heard.setdefault(message.name, Arrivals())

    def clear(self) -> None:
        """Discard all counts, when switching to or from emulation: examples must not mix with a board's frames."""
        for name in self.heard:
            self.heard[name] = Arrivals()
        self.damaged.clear()
        self.unknown.clear()
        self.unknown_damaged.clear()
        self._after_failure = False

    def rate_changed(self, rate_command: str) -> None:
        """The period of a task of the board was changed: measure the rates of its topics anew."""
        for topic, command in TASK_OF_TOPIC.items():
            if command == rate_command:
                self.heard[topic].forget_rate()

    def kept(self) -> list[Any]:
        """All counts, as plain values for `restore`; jitter is measured anew after it."""
        return [
            [[name, *one.kept()] for name, one in self.heard.items() if one.count],
            dict(self.damaged),
            [[number, *one.kept()] for number, one in self.unknown.items()],
            [[number, count] for number, count in self.unknown_damaged.items()],
            self._after_failure,
        ]

    def restore(self, kept: list[Any]) -> None:
        """Go on from a state that `kept` gave."""
        self.clear()
        heard, damaged, unknown, unknown_damaged, self._after_failure = kept
        for name, *one in heard:
            self.heard[name] = Arrivals.restored(*one)
        self.damaged.update(damaged)
        self.unknown.update({number: Arrivals.restored(*one) for number, *one in unknown})
        self.unknown_damaged.update(dict(unknown_damaged))

    def on_damage(self, damage: Damage, t_s: float) -> None:
        """Count damage that came at Unix time `t_s`. Call it in the order of the line."""
        if damage.kind == "remains" and self._after_failure and len(damage.data) >= _WORD:
            self._count_failed(damage.data, t_s)
        self._after_failure = damage.is_failed_frame

    def _count_failed(self, remains: bytes, t_s: float) -> None:
        word = int.from_bytes(remains[:_WORD], "little")
        type_id = word & ~TO_PC_TYPE_BIT
        known = TELEMETRY.get(type_id) or self.own.get(type_id)
        if known is not None and word & TO_PC_TYPE_BIT:
            self.damaged[known.name] += 1
        elif word & TO_PC_TYPE_BIT and not word & FORBIDDEN_TYPE_BITS:
            self._count_unknown(type_id, remains, t_s)

    def _count_unknown(self, type_id: int, remains: bytes, t_s: float) -> None:
        if type_id not in self.unknown:
            if len(self.unknown) >= _MOST_UNKNOWN:
                return
            self.unknown[type_id] = Arrivals()
        if _is_whole(remains):
            self.unknown[type_id].heard(t_s, None)
        else:
            self.unknown_damaged[type_id] += 1


def _is_whole(remains: bytes) -> bool:
    """Whether a complete frame with a correct checksum is there: a message of a newer firmware."""
    if not remains.endswith(END):
        return False
    body = remains[: -len(END)]
    return len(body) >= 2 * _WORD and len(body) % _WORD == 0 and checksum(body) == 0
