"""Names of a log's topics and fields as ours are made: letters, digits and underscores, each once whatever its case."""

from __future__ import annotations

import re
from collections.abc import Callable, Hashable
from typing import Final

from epf_gcs.codec.messages_gen import TELEMETRY_BY_NAME
from epf_gcs.recordings.log_table import T_NS

_UNSAFE: Final = re.compile(r"[^A-Za-z0-9_]+")
_LONGEST: Final = 60
_OURS: Final = frozenset(
    {"simulator", "xplane_info", "xplane_rows", "ahrs_test", "events", "keyframes", "damage", "link"}
    | set(TELEMETRY_BY_NAME)
)
_SENT: Final = "sent_"


def is_reserved(topic: str) -> bool:
    """Whether a table of this name is made of the station's own recordings."""
    return topic.lower() in _OURS or topic.lower().startswith(_SENT)


class Names:
    """Gives each thing a name of its own, as near to the one that it has as can be, and none that `is_taken`."""

    def __init__(self, is_taken: Callable[[str], bool]) -> None:
        self._is_taken = is_taken
        self._taken: set[str] = set()
        self._given: dict[Hashable, str] = {}

    def of(self, name: Hashable) -> str:
        """Its name here, always the same."""
        given = self._given.get(name)
        if given is None:
            plain = _UNSAFE.sub("_", str(name)).strip("_")[:_LONGEST] or "unnamed"
            plain = f"log_{plain}" if self._is_taken(plain) else plain
            given, number = plain, 2
            while given.lower() in self._taken:
                given, number = f"{plain}_{number}", number + 1
            self._taken.add(given.lower())
            self._given[name] = given
        return given


def topic_names() -> Names:
    """For the topics of one log: those of the station's own stay free."""
    return Names(is_reserved)


def field_names() -> Names:
    """For the fields of one topic."""
    return Names(lambda name: name.lower() == T_NS)
