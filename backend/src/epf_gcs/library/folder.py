"""Moves recordings with what is said of them: into the bin, back, and away for good."""

from __future__ import annotations

import contextlib
import os
import shutil
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from epf_gcs.disk import regular_files
from epf_gcs.errors import ConflictError, NotFoundError
from epf_gcs.library.about import About, read_about, write_about
from epf_gcs.recordings.places import PACKING, Places, is_id, started_s

KEPT_S: Final = 30 * 86400.0
"""How long the bin keeps a flight."""


@dataclass(frozen=True, slots=True)
class BinEntry:
    """A flight in the bin."""

    id: str
    about: About
    started_s: float
    bytes: int
    deleted_s: float


class FlightFolder:
    """Every method reads or writes the disk: call it in a thread. Raises OSError."""

    def __init__(self, places: Places) -> None:
        self._places = places

    def delete(self, flight: str, now_s: float) -> None:
        """Move a flight to the bin. What was made of it goes: it is made again after `restore`."""
        source, about = self._places.recording(flight), read_about(self._places.about(flight))
        about.deleted_s = now_s
        # What is said of it first: if the power goes between the two steps, it lies beside the recording in any case.
        write_about(self._places.bin / f"{flight}.json", about)
        source.replace(self._places.bin / source.name)
        self._places.about(flight).unlink(missing_ok=True)
        self.drop_made(flight)

    def restore(self, flight: str) -> None:
        """Move a flight back. Raises NotFoundError, and ConflictError where the id is taken meanwhile."""
        source, target = self._places.bin / f"{flight}.mcap", self._places.recording(flight)
        if not source.exists():
            raise NotFoundError("flight_unknown", f"There is no flight '{flight}' in the bin.", flight=flight)
        if target.exists():
            raise ConflictError(
                "flight_exists", f"There is a flight '{flight}' in the library already: delete it first.", flight=flight
            )
        about = read_about(self._places.bin / f"{flight}.json")
        about.deleted_s = None
        write_about(self._places.about(flight), about)
        source.replace(target)
        (self._places.bin / f"{flight}.json").unlink(missing_ok=True)

    def bin(self) -> list[BinEntry]:
        """What lies in the bin, deleted last first."""
        found: list[BinEntry] = []
        for path in regular_files(self._places.bin, "*.mcap"):
            if is_id(path.stem):
                with contextlib.suppress(FileNotFoundError, ValueError):
                    about = read_about(path.with_suffix(".json"))
                    size, changed_s = path.stat().st_size, path.stat().st_mtime
                    gone_s = changed_s if about.deleted_s is None else about.deleted_s
                    found.append(BinEntry(path.stem, about, started_s(path.stem), size, gone_s))
        return sorted(found, key=lambda one: one.deleted_s, reverse=True)

    def purge(self, now_s: float) -> list[str]:
        """Remove for good what the bin has kept long enough."""
        late = [one.id for one in self.bin() if one.deleted_s + KEPT_S <= now_s]
        for flight in late:
            self.remove_from_bin(flight)
        return late

    def remove_from_bin(self, flight: str) -> None:
        """Remove a flight of the bin for good."""
        (self._places.bin / f"{flight}.mcap").unlink(missing_ok=True)
        (self._places.bin / f"{flight}.json").unlink(missing_ok=True)

    def remove(self, flight: str) -> None:
        """Remove a flight for good, to make room."""
        self._places.recording(flight).unlink(missing_ok=True)
        self._places.about(flight).unlink(missing_ok=True)
        self.drop_made(flight)

    def drop_made(self, flight: str) -> None:
        """Remove what was made of a flight, and the folders that are empty then."""
        self._places.keyframes(flight).unlink(missing_ok=True)
        for folder in self._places.columns.glob(f"vehicle=*/date=*/flight={flight}"):
            shutil.rmtree(folder, ignore_errors=True)
            for parent in (folder.parent, folder.parent.parent):
                with contextlib.suppress(OSError):
                    parent.rmdir()

    def drop_half_packed(self, flight: str) -> None:
        """Remove what a packing left that was killed; `*`: of all flights. None may be under way."""
        for path in regular_files(self._places.recordings, f"{flight}.mcap{PACKING}"):
            with contextlib.suppress(OSError):
                path.unlink(missing_ok=True)

    def drop_orphans(self) -> list[str]:
        """Remove what was made of flights whose recording has gone; returns their ids.

        Where the folder of the recordings itself is not there, all stays: its disk may come back.
        """
        if not self._places.recordings.is_dir():
            return []
        made = {*self._places.made(), *(path.stem for path in self._places.all_keyframes.glob("*.keys"))}
        orphans = sorted(flight for flight in made if is_id(flight) and not self._places.recording(flight).exists())
        for flight in orphans:
            self.drop_made(flight)
        return orphans

    def made_bytes(self, flight: str) -> int:
        """What was made of a flight takes so much of the disk: its columns and its key frames."""
        folder = self._places.made_of(flight)
        return (0 if folder is None else _size(folder)) + _size(self._places.keyframes(flight))

    def used_bytes(self) -> int:
        """What all flights take of the disk, with the bin, what was made of them, and the results of jobs."""
        places = self._places
        kept = (places.recordings, places.bin, places.columns, places.all_keyframes, places.exports, places.incoming)
        return sum(_size(path) for path in kept)

    def free_bytes(self) -> int:
        """Free space on the disk of the recordings."""
        folder = self._places.recordings.absolute()
        return shutil.disk_usage(next(path for path in (folder, *folder.parents) if path.exists())).free


def _size(path: Path) -> int:
    """Bytes of a file, or of all files in a folder; those that go meanwhile, and what is not there, count nothing."""
    try:
        if not path.is_dir():
            return path.stat().st_size
        return sum(_size(Path(entry.path)) for entry in os.scandir(path))
    except OSError:
        return 0


def unknown(flight: str) -> NotFoundError:
    """There is no such flight."""
    return NotFoundError(
        "flight_unknown", f"There is no flight '{flight}': GET /api/v1/flights lists all of them.", flight=flight
    )
