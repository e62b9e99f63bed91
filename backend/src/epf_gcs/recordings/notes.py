"""The notes in a recording: what was known or done that the bytes of the lines do not say.

A note is an MCAP Metadata record. `t_ns` is its time (Unix nanoseconds, as decimal text) and `json` its content.
Notes that describe what is known hold the whole of it each time: the newest one before a moment is what was known then.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final

import orjson

# {"station": version, "board": {...capabilities}, "firmware": text or null, "aircraft": text or null,
#  "operator": text or null, "emulated": bool}
IDENTITY: Final = "epf/identity"
# The gains as GET /api/v1/parameters gives them.
PARAMETERS: Final = "epf/parameters"
# {"plan": "flight" or "hil", "waypoints": [...] or null} as GET /api/v1/missions/{plan} gives it.
PLAN: Final = "epf/plan"
# {"event": kind, "data": {...}} as the stream sends it: command, alarm, link, parameter, mission, board_restarted,
# simulator_jumped, control, advice, stick, fault, wind, and console lines that were sent; and, known whole each time,
# hil ("path" and "source"), limits (of alarms, by name) and faults ("flown", as the status has them). Other things that
# the bytes themselves bring about are not noted.
EVENT: Final = "epf/event"
# {"text": words of the person, "by": name or null, "id": text}
MARK: Final = "epf/mark"
# {"bytes": number of bytes that reached no file, "reason": text}
LOST: Final = "epf/lost"
# {"bytes_cut": number of bytes}: the writer was ended without warning, and the incomplete end was cut off since then.
REPAIRED: Final = "epf/repaired"
# {"line": "board" or "simulator", "open": bool, "url": text or null, "baud": number or null, "profile": text or null,
#  "emulated": bool}: from here on the bytes of this line belong to this device.
LINE: Final = "epf/line"
# {"ahead_s": by how much the system's clock is ahead of the times in this file, "synchronised": bool or null}: a
# computer without a battery for its clock may learn the time in the middle of a flight, whose stamps go on unbroken.
# The newest note holds for the whole file.
CLOCK: Final = "epf/clock"


Content = dict[str, Any]
"""What a note says, of the shapes above; a stranger's file may say anything in any shape."""


@dataclass(frozen=True, slots=True)
class Note:
    """One note and its time."""

    t_ns: int
    name: str
    content: Any


def written(t_ns: int, content: Any) -> dict[str, str]:
    """The values of the note's Metadata record."""
    return {"t_ns": str(t_ns), "json": orjson.dumps(content).decode()}


def read(name: str, values: Mapping[str, str]) -> Note | None:
    """A note from its Metadata record; None for a record that is not one of ours, or is damaged."""
    try:
        return Note(int(values["t_ns"]), name, orjson.loads(values["json"]))
    except (KeyError, ValueError):
        return None
