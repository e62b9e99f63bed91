"""What an export was asked for, and how it tells its progress and watches the disk."""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path
from typing import Final, get_args

from epf_gcs.errors import InvalidInputError, NotFoundError
from epf_gcs.flights.room import FreeBytes, check_room, free_bytes_of
from epf_gcs.flights.worker import Say
from epf_gcs.formats.kml_words import Language
from epf_gcs.recordings.export_names import ExportFormat, check_export, file_name

RESERVE_BYTES: Final = 1_500_000_000
"""Space that an export leaves free, so that no viewer's file ever stops the recording of a flight."""
_STEP: Final = 0.002
_THINNED: Final[tuple[ExportFormat, ...]] = ("kml", "kmz", "gpx")


@dataclass(frozen=True)
class ExportRequest:
    """`from_s` and `to_s` are seconds since the flight's start, None for its ends; `topics` None for all."""

    recording: Path
    format: ExportFormat
    topics: tuple[str, ...] | None = None
    from_s: float | None = None
    to_s: float | None = None
    language: Language = "en"
    every_point: bool = False

    @property
    def flight(self) -> str:
        """The flight's id."""
        return self.recording.stem

    @property
    def is_whole(self) -> bool:
        """Whether the whole time of the flight is asked for."""
        return self.from_s is None and self.to_s is None

    @property
    def is_thinned(self) -> bool:
        """Whether points that say nothing more are left out: in what is drawn, unless all are asked for."""
        return self.format in _THINNED and not self.every_point

    @property
    def name(self) -> str:
        """What the file is called."""
        return file_name(self.flight, self.format, self.topics)

    def span_ns(self, start_ns: int) -> tuple[int, int]:
        """First and last Unix time (ns) that are asked for, of a flight that begins at `start_ns`."""
        first_ns = start_ns + round((self.from_s or 0.0) * 1e9)
        last_ns = (1 << 63) - 1 if self.to_s is None else start_ns + round(self.to_s * 1e9)
        return (0 if self.from_s is None else first_ns), last_ns


class Progress:
    """Tells the progress in steps, and ends the export before the disk is full."""

    def __init__(
        self,
        say: Say,
        folder: Path,
        name: str,
        free_bytes: FreeBytes = free_bytes_of,
    ) -> None:
        self._say = say
        self._folder = folder
        self._name = name
        self._free_bytes = free_bytes
        self._said = -1.0

    def at(self, share: float, doing: str = "exporting") -> None:
        """0 to 1. Raises ConflictError where too little of the disk is free."""
        if share - self._said < _STEP and share < 1.0:
            return
        self._said = share
        check_room(self._folder, self._name, RESERVE_BYTES, self._free_bytes)
        self._say(share, doing)


def read_arguments(arguments: list[str]) -> tuple[ExportRequest, Path]:
    """`FILE FORMAT OUT [--topics A,B] [--from-s X] [--to-s Y] [--language L] [--every-point]`.

    Raises InvalidInputError.
    """
    parser = argparse.ArgumentParser("export")
    parser.add_argument("file", type=Path)
    parser.add_argument("format", choices=get_args(ExportFormat))
    parser.add_argument("out", type=Path)
    parser.add_argument("--topics", type=lambda text: tuple(text.split(",")))
    parser.add_argument("--from-s", type=float)
    parser.add_argument("--to-s", type=float)
    parser.add_argument("--language", choices=get_args(Language), default="en")
    parser.add_argument("--every-point", action="store_true")
    given = parser.parse_args(arguments)
    asked = ExportRequest(
        given.file.resolve(),
        given.format,
        given.topics,
        given.from_s,
        given.to_s,
        given.language,
        given.every_point,
    )
    check_export(asked.format, asked.topics, asked.from_s, asked.to_s)
    return asked, given.out


def unknown_topic(topic: str) -> NotFoundError:
    """This flight has no such topic."""
    return NotFoundError(
        "export_topic_unknown", f"This flight has no topic '{topic}': its topics list those that it has.", topic=topic
    )


def no_position() -> InvalidInputError:
    """A format of positions, and a flight without."""
    return InvalidInputError(
        "export_no_position", "This flight has no position to be drawn: export it as CSV, Parquet or MCAP."
    )
