"""Names of the tables that are made of a recording, other than those of the wire's messages."""

from __future__ import annotations

from typing import Final

from epf_gcs.codec.messages_gen import TELEMETRY_BY_NAME

SENT: Final = "sent_"
"""Before the name of a command's table, for a command and a message of the board may have one name."""
KEYFRAMES: Final = "keyframes"
DAMAGE: Final = "damage"
LINK: Final = "link"
EVENTS: Final = "events"
RAW_ROWS: Final = "xplane_rows"
_OURS: Final = {"simulator", "xplane_info", "ahrs_test", KEYFRAMES, DAMAGE, LINK, EVENTS, RAW_ROWS, *TELEMETRY_BY_NAME}


def is_reserved(topic: str) -> bool:
    """Whether a table of this name, in whatever case, is one of the station's own: a log's topic has another."""
    return topic.lower() in _OURS or topic.lower().startswith(SENT)
