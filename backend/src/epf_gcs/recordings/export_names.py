"""The formats in which a flight is exported, and how the files are called."""

from __future__ import annotations

from typing import Final, Literal

ExportFormat = Literal["mcap", "mcap-decoded", "csv", "parquet", "kml", "kmz", "gpx", "czml"]

DECODED_FORMATS: Final = frozenset({"mcap-decoded", "csv", "parquet"})
"""Those that hold topics, which can be chosen."""
_ENDINGS: Final[dict[ExportFormat, str]] = {
    "mcap": ".mcap",
    "mcap-decoded": "-decoded.mcap",
    "csv": ".zip",
    "parquet": ".zip",
    "kml": ".kml",
    "kmz": ".kmz",
    "gpx": ".gpx",
    "czml": ".czml",
}
_SINGLE: Final = {"csv": ".csv", "parquet": ".parquet"}


def file_name(flight: str, kind: ExportFormat, topics: list[str] | tuple[str, ...] | None = None) -> str:
    """The name of the file: with the flight's own time, and the topic where it is a file of one topic."""
    if is_single(kind, topics) and topics:
        return f"{flight}-{topics[0]}{_SINGLE[kind]}"
    stem = f"{flight}-{kind}" if kind in _SINGLE else flight
    return stem + _ENDINGS[kind]


def is_single(kind: ExportFormat, topics: list[str] | tuple[str, ...] | None) -> bool:
    """Whether the export is one table and no archive."""
    return kind in _SINGLE and topics is not None and len(topics) == 1
