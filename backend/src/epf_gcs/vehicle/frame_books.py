"""The books on every type of frame that the board's line brought: good ones, damaged ones, and those nobody knows."""

from __future__ import annotations

from collections import Counter
from typing import Final

from epf_gcs.codec.checksum import checksum
from epf_gcs.codec.frame import Damage
from epf_gcs.codec.messages_gen import END, FORBIDDEN_TYPE_BITS, TELEMETRY, TO_PC_TYPE_BIT
from epf_gcs.vehicle.arrivals import Arrivals
from epf_gcs.vehicle.health import TASK_OF_TOPIC

_WORD: Final = 4
# A bad line makes up types at random: more than these are counted together.
_MOST_UNKNOWN: Final = 32


class FrameBooks:
    """`heard` and `damaged` are by the name of the message; `unknown` by the type's number.

    The decoder names what failed by its header alone: the type is the first word of the remains which follow.
    """

    def __init__(self) -> None:
        self.heard: dict[str, Arrivals] = {message.name: Arrivals() for message in TELEMETRY.values()}
        self.damaged: Counter[str] = Counter()
        self.unknown: dict[int, Arrivals] = {}
        self.unknown_damaged: Counter[int] = Counter()
        self._after_failure = False

    def clear(self) -> None:
        """What was heard were examples, or is about to be: it does not belong together with a board's."""
        for name in self.heard:
            self.heard[name] = Arrivals()
        self.damaged.clear()
        self.unknown.clear()
        self.unknown_damaged.clear()
        self._after_failure = False

    def rate_changed(self, rate_command: str) -> None:
        """A task of the board has another period now."""
        for topic, command in TASK_OF_TOPIC.items():
            if command == rate_command:
                self.heard[topic].forget_rate()

    def on_damage(self, damage: Damage, t_s: float) -> None:
        """Bytes in no frame came at `t_s`, in the order of the line."""
        if damage.kind == "remains" and self._after_failure and len(damage.data) >= _WORD:
            self._book(damage.data, t_s)
        self._after_failure = damage.is_failed_frame

    def _book(self, remains: bytes, t_s: float) -> None:
        word = int.from_bytes(remains[:_WORD], "little")
        type_id = word & ~TO_PC_TYPE_BIT
        known = TELEMETRY.get(type_id)
        if known is not None and word & TO_PC_TYPE_BIT:
            self.damaged[known.name] += 1
        elif word & TO_PC_TYPE_BIT and not word & FORBIDDEN_TYPE_BITS:
            self._book_unknown(type_id, remains, t_s)

    def _book_unknown(self, type_id: int, remains: bytes, t_s: float) -> None:
        if type_id not in self.unknown:
            if len(self.unknown) >= _MOST_UNKNOWN:
                return
            self.unknown[type_id] = Arrivals()
        if _is_whole(remains):
            self.unknown[type_id].heard(t_s, None)
        else:
            self.unknown_damaged[type_id] += 1


def _is_whole(remains: bytes) -> bool:
    """From the type to the end marker all is there, and the checksum holds: a frame of a newer firmware."""
    if not remains.endswith(END):
        return False
    body = remains[: -len(END)]
    return len(body) >= 2 * _WORD and len(body) % _WORD == 0 and checksum(body) == 0
