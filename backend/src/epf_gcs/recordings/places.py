"""Where recordings and all that is made of them lie in the data folder, and how a flight is named.

The recordings are the truth. What people say of one stands beside it, in a file of the same stem; everything else
can be made again from these two.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Final

ID_PATTERN: Final = r"^[0-9]{8}T[0-9]{6}Z(-[0-9]{1,4})?$"
_ID: Final = re.compile(ID_PATTERN)
_TRIES: Final = 5
SUMMARY: Final = "summary.json"
PACKING: Final = ".packing"
"""What the name of a file ends with while a recording is packed into it."""

Stamp = tuple[int, int]
"""Size in bytes and time of the last change (ns): another stamp, another content."""


@dataclass(frozen=True)
class Places:
    """Paths below the data folder; none of them needs to exist."""

    data_dir: Path

    @property
    def recordings(self) -> Path:
        """The recordings and what people say of them."""
        return self.data_dir / "recordings"

    @property
    def bin(self) -> Path:
        """Recordings that were deleted, and can be restored for a while."""
        return self.data_dir / "bin"

    @property
    def columns(self) -> Path:
        """What was made of the recordings: `vehicle=NAME/date=YYYY-MM-DD/flight=ID/`."""
        return self.data_dir / "columns"

    @property
    def library(self) -> Path:
        """The SQLite file that lists the recordings."""
        return self.data_dir / "library.sqlite"

    @property
    def incoming(self) -> Path:
        """Uploads on their way."""
        return self.data_dir / "incoming"

    @property
    def exports(self) -> Path:
        """Results of jobs, until they are fetched or the web process ends."""
        return self.data_dir / "exports"

    def recording(self, flight: str) -> Path:
        """The recording of this id."""
        return self.recordings / f"{flight}.mcap"

    def about(self, flight: str) -> Path:
        """What people say of this flight."""
        return self.recordings / f"{flight}.json"

    @property
    def all_keyframes(self) -> Path:
        """The key frames of all flights, a file each."""
        return self.data_dir / "keyframes"

    def keyframes(self, flight: str) -> Path:
        """The key frames that the replays of this flight share; made again when they are gone."""
        return self.all_keyframes / f"{flight}.keys"

    def made(self) -> dict[str, Path]:
        """The folders of all flights that have columns, by id."""
        return {path.name.removeprefix("flight="): path for path in self._folders("*")}

    def made_of(self, flight: str) -> Path | None:
        """The folder of this flight's columns; None while there is none."""
        return next(iter(self._folders(flight)), None)

    def _folders(self, flight: str) -> list[Path]:
        """Looked for again where a folder goes meanwhile, for a flight may be indexed anew just now."""
        for _ in range(_TRIES):
            try:
                return list(self.columns.glob(f"vehicle=*/date=*/flight={flight}"))
            except FileNotFoundError:
                continue
        return []


def is_id(text: str) -> bool:
    """Whether this is the id of a flight."""
    return _ID.fullmatch(text) is not None


def started_s(flight: str) -> float:
    """Unix time that an id tells. Raises ValueError where its digits are no date."""
    return datetime.strptime(flight.split("-", maxsplit=1)[0], "%Y%m%dT%H%M%SZ").replace(tzinfo=UTC).timestamp()


def id_of(t_ns: int) -> str:
    """The id of a flight that begins at this Unix time, before a number is added where it is taken."""
    return datetime.fromtimestamp(t_ns // 1_000_000_000, UTC).strftime("%Y%m%dT%H%M%SZ")


def free_id(t_ns: int, is_taken: set[str]) -> str:
    """An id for this Unix time that is not taken."""
    first = id_of(t_ns)
    flight, number = first, 2
    while flight in is_taken:
        flight = f"{first}-{number}"
        number += 1
    return flight


def stamp_of(path: Path) -> Stamp:
    """The stamp of a file. Raises OSError."""
    found = path.stat()
    return found.st_size, found.st_mtime_ns
