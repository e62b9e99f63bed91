"""The chosen online sources, kept across restarts in a small file."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, Final

import orjson

from epf_gcs.errors import GatewayError

_FILE: Final = "online-maps.json"
# The file of versions before 1.0.0.
_OLD_FILE: Final = "state.json"


class OnlineFile:
    """Read once at the start, written at each choice. `report` is called when the disk fails."""

    def __init__(self, data_dir: Path, report: Callable[[GatewayError], None]) -> None:
        self._path = data_dir / _FILE
        self._old_path = data_dir / _OLD_FILE
        self._report = report

    def read(self) -> dict[str, Any]:
        """The last choice; empty if there is none, or if the file cannot be read."""
        try:
            return dict(orjson.loads(self._path.read_bytes()))
        except FileNotFoundError:
            return self._read_old()
        except (OSError, ValueError, TypeError) as error:
            self._complain("read", error)
            return {}

    def write(self, choice: dict[str, Any]) -> None:
        """Replace the file as a whole."""
        temporary = self._path.with_suffix(".new")
        try:
            self._path.parent.mkdir(parents=True, exist_ok=True)
            temporary.write_bytes(orjson.dumps(choice, option=orjson.OPT_INDENT_2))
            temporary.replace(self._path)
        except OSError as error:
            self._complain("written", error)

    def _read_old(self) -> dict[str, Any]:
        try:
            return dict(orjson.loads(self._old_path.read_bytes()).get("online") or {})
        except (OSError, ValueError, TypeError, AttributeError):
            return {}

    def _complain(self, done: str, error: Exception) -> None:
        self._report(
            GatewayError(
                "memory_not_written" if done == "written" else "memory_unreadable",
                f"The choice of online maps in {self._path} could not be {done} ({error}): "
                "free the disk or correct its permissions.",
                path=str(self._path),
            )
        )
