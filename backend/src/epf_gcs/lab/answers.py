"""What the station takes of a board's frames: where the surfaces go, and which waypoint it flies to."""

from __future__ import annotations

from struct import Struct
from typing import Final

from epf_gcs.codec.checksum import MASK
from epf_gcs.codec.frame import FROM_BOARD, Damage, Frame, FrameDecoder
from epf_gcs.codec.messages_gen import END, TELEMETRY_BY_NAME
from epf_gcs.lab.errors import LabError
from epf_gcs.xplane.datagram import Surfaces

_WORD: Final = Struct("<I")
_ANSWER: Final = TELEMETRY_BY_NAME["hil_surfaces"]
_HEAD: Final = FROM_BOARD.header + _WORD.pack(FROM_BOARD.type_bit | _ANSWER.id)
_BYTES: Final = len(_HEAD) + _ANSWER.size + _WORD.size + len(END)
_WORDS: Final = Struct(f"<{(_WORD.size + _ANSWER.size + _WORD.size) // 4}I")


class Answers:
    """Decodes what one board sends. `waypoint`: of the plan that the message `plan` tells of; -1 before it told one.
    `is_line_sound`: what cannot be read is the board's fault."""

    def __init__(self, plan: str = "fms_hil_plan", *, is_line_sound: bool = True) -> None:
        self._plan = plan
        self._is_line_sound = is_line_sound
        self._decoder = FrameDecoder()
        self.waypoint = -1

    def take(self, data: bytes) -> list[Surfaces]:
        """The surfaces in it, within the simulator's limits. Raises LabError for damage, and surfaces that are no
        numbers."""
        # Nearly all is one answer, whole and right.
        if len(data) == _BYTES and data.startswith(_HEAD) and data.endswith(END):
            words = _WORDS.unpack_from(data, len(FROM_BOARD.header))
            if not sum(words) & MASK:
                return [within_limits(Surfaces(*_ANSWER.struct.unpack_from(data, len(_HEAD))))]
        moved = []
        for found in self._decoder.feed(data):
            match found:
                case Frame(message=message) if message is _ANSWER:
                    moved.append(within_limits(Surfaces(*found.values)))
                case Frame(message=message) if message.name == self._plan:
                    self.waypoint = int(found.values[-1])
                case Frame():
                    pass
                case Damage() if self._is_line_sound:
                    raise LabError(f"the board sent {found}")
        return moved


def within_limits(surfaces: Surfaces) -> Surfaces:
    """Raises LabError for surfaces that are no numbers."""
    safe = surfaces.clamped()
    if safe is None:
        raise LabError(f"the board sent surfaces that are no numbers: {surfaces}")
    return safe
