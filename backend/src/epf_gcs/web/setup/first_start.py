"""Whether this data folder was ever set up."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import orjson

from epf_gcs.disk import replace_file
from epf_gcs.errors import NotKeptError

FILE_NAME: Final = "first-start.json"
# What the flight process remembers: it writes the file in a folder that nobody has set up, too, but without a link.
_MEMORY: Final = "state.json"
_LINKS: Final = ("board_url", "simulator")
_RECORDINGS: Final = "recordings"


class FirstStart:
    """Blocks: called from a thread."""

    def __init__(self, data_dir: Path) -> None:
        self._data = data_dir

    def is_due(self) -> bool:
        """Whether nobody has set this station up: it has no link and no flight, and nobody has put it off."""
        has_flights = any((self._data / _RECORDINGS).glob("*"))
        return not (has_flights or (self._data / FILE_NAME).exists() or self._has_link())

    def end(self) -> None:
        """Remember that it is over, done or put off; may be repeated. Raises NotKeptError."""
        try:
            replace_file(self._data / FILE_NAME, b'{"over": true}\n')
        except OSError as error:
            reason = error.strerror or str(error)
            raise NotKeptError(
                "first_start_not_kept",
                f"That the first start is over cannot be kept: {reason}. Look at the disk of the station.",
                reason=reason,
            ) from error

    def _has_link(self) -> bool:
        """Whether one is remembered. Where the memory cannot be read, the folder is no new one."""
        try:
            memory = orjson.loads((self._data / _MEMORY).read_bytes())
            return any(memory[link] is not None for link in _LINKS)
        except FileNotFoundError:
            return False
        except (OSError, ValueError, KeyError, TypeError):
            return True
