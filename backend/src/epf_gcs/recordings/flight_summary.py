"""What the index worker found in a recording: the figures of its row in the library, one file beside its columns."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

import msgspec

from epf_gcs.contract.flights import Thumbnail
from epf_gcs.recordings.places import SUMMARY, Stamp

VERSION: Final = 3
"""Summaries of another version are made again."""


@dataclass(frozen=True, slots=True)
class FlightSummary:
    """`stamp` is the recording's that was looked at; Unix times in ns. None: the recording does not say it.

    `gaps`: begin and end of the stretches without a byte of the board; `damage`: what is wrong with the file, a
    sentence. A flight's start is corrected by `clock_ahead_s`, its samples are not; `clock_unsure`: nobody gave the
    time. `fingerprint`: the same for every copy of one content.
    """

    started_ns: int
    ended_ns: int
    version: int = VERSION
    stamp: Stamp = (0, 0)
    clock_ahead_s: float = 0.0
    clock_unsure: bool = False
    station: str | None = None
    board: str | None = None
    firmware: str | None = None
    aircraft: str | None = None
    operator: str | None = None
    emulated: bool = False
    highest_ft: float | None = None
    fastest_kt: float | None = None
    distance_nm: float | None = None
    waypoints: int = 0
    alarms: int = 0
    marks: int = 0
    thumbnail: Thumbnail | None = None
    frames: int | None = None
    frames_damaged: int | None = None
    gaps: list[tuple[int, int]] = field(default_factory=list)
    is_whole: bool = True
    damage: str | None = None
    fingerprint: str | None = None

    @property
    def duration_ns(self) -> int:
        """From the first message to the last."""
        return self.ended_ns - self.started_ns

    def as_json(self) -> bytes:
        """For a file or a row."""
        return msgspec.json.encode(self)

    @classmethod
    def from_json(cls, text: bytes | str) -> FlightSummary:
        """Read it. Raises ValueError where it is no summary of this version."""
        try:
            found = msgspec.json.decode(text, type=cls)
        except msgspec.DecodeError as error:
            raise ValueError(str(error)) from error
        if found.version != VERSION or found.duration_ns < 0:
            raise ValueError("it is of another version, or ends before it begins")
        return found


def write_summary(folder: Path, found: FlightSummary) -> None:
    """Write it beside the columns: last, for it says that they are whole. Raises OSError."""
    part = folder / f".{SUMMARY}.part"
    part.write_bytes(found.as_json())
    part.replace(folder / SUMMARY)


def read_summary(folder: Path, stamp: Stamp) -> FlightSummary | None:
    """What was found in a recording of this stamp; None if nobody has looked at this content yet."""
    try:
        found = FlightSummary.from_json((folder / SUMMARY).read_bytes())
    except (OSError, ValueError):
        return None
    return found if found.stamp == stamp else None
