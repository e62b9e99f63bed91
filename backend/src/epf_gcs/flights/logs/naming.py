"""Names of a log's topics and fields as ours are made: letters, digits and underscores, each once whatever its case."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Final

from epf_gcs.recordings.log_table import T_NS
from epf_gcs.recordings.table_names import is_reserved

_UNSAFE: Final = re.compile(r"[^A-Za-z0-9_]+")
_LONGEST: Final = 60


class Names:
    """Gives each thing a name of its own, as near to the one that it has as can be, and none that `is_taken`."""

    def __init__(self, is_taken: Callable[[str], bool]) -> None:
        self._is_taken = is_taken
        self._taken: set[str] = set()

    def new(self, name: str) -> str:
        """A name that none has yet."""
        plain = _UNSAFE.sub("_", name).strip("_")[:_LONGEST] or "unnamed"
        plain = f"log_{plain}" if self._is_taken(plain) else plain
        given, number = plain, 2
        while given.lower() in self._taken:
            given, number = f"{plain}_{number}", number + 1
        self._taken.add(given.lower())
        return given


def topic_names() -> Names:
    """For the topics of one log: those of the station's own stay free."""
    return Names(is_reserved)


def field_names() -> Names:
    """For the fields of one topic."""
    return Names(lambda name: name.lower() == T_NS)
