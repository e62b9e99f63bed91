"""MAVLink's messages and numbers, as pymavlink generates them: the dialect that has the standard modes."""

from __future__ import annotations

from typing import Any, Final

from pymavlink.dialects.v20 import development

WIRE: Final[Any] = development
Message = Any
"""One of its messages; its type is made by pymavlink and says nothing to a checker."""

SYSTEM_ID: Final = 1
COMPONENT_ID: Final = WIRE.MAV_COMP_ID_AUTOPILOT1
# Packs nothing itself: it only makes messages, which every peer packs with numbers of its own.
MAKE: Final[Any] = WIRE.MAVLink(None, SYSTEM_ID, COMPONENT_ID)

_TEXT_PIECE: Final = 50
_MOST_TEXT: Final = 250


def status_texts(severity: int, text: str, number: int) -> list[Message]:
    """A sentence for people, in pieces of 50 bytes that belong together by their number (not 0)."""
    raw = text.encode("ascii", errors="replace")[:_MOST_TEXT]
    pieces = [raw[at : at + _TEXT_PIECE] for at in range(0, len(raw), _TEXT_PIECE)]
    number = number if len(pieces) > 1 else 0
    return [MAKE.statustext_encode(severity, piece, number, at) for at, piece in enumerate(pieces)]
