"""The chosen online sources, kept across restarts in a small file."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Final

import orjson

from epf_gcs.disk import KeptFile
from epf_gcs.errors import GatewayError
from epf_gcs.maps.sources import OnlineChoice

_FILE: Final = "online-maps.json"


class OnlineFile:
    """Read once at the start, written at each choice, both blocking. `report` is called when the disk fails."""

    def __init__(self, data_dir: Path, report: Callable[[GatewayError], None]) -> None:
        self._file = KeptFile(
            data_dir / _FILE,
            OnlineChoice.from_json,
            lambda choice: orjson.dumps(choice, option=orjson.OPT_INDENT_2),
        )
        self._report = report

    def read(self) -> OnlineChoice:
        """The last choice; off if there is none, or if the file cannot be read: then it is kept aside."""
        try:
            return self._file.read_or_set_aside(self._complain_of_damage) or OnlineChoice()
        except OSError as error:
            self._complain("read", error.strerror or str(error))
            return OnlineChoice()

    def write(self, choice: OnlineChoice) -> None:
        """Replace the file as a whole: after a power cut it holds the old or the new choice."""
        try:
            self._file.path.parent.mkdir(parents=True, exist_ok=True)
            self._file.write(choice)
        except OSError as error:
            self._complain("written", error.strerror or str(error))

    def _complain_of_damage(self, kept: Path | None) -> None:
        self._complain("read", "its content makes no sense" + ("" if kept is None else f"; it is kept as {kept.name}"))

    def _complain(self, done: str, why: str) -> None:
        self._report(
            GatewayError(
                "memory_not_written" if done == "written" else "memory_unreadable",
                f"The choice of online maps in {self._file.path} could not be {done} ({why}): "
                "free the disk or correct its permissions.",
                path=str(self._file.path),
            )
        )
