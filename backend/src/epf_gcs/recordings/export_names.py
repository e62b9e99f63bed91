"""The formats in which a flight is exported, what can be asked of them, and how the files are called."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, Literal

from epf_gcs.errors import InvalidInputError

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


def check_export(kind: ExportFormat, topics: Sequence[str] | None, from_s: float | None, to_s: float | None) -> None:
    """Raises InvalidInputError where this can never be exported."""
    if topics is not None and kind not in DECODED_FORMATS:
        raise InvalidInputError(
            "export_topics_unused", f"The format {kind} has no topics to choose from: leave them out.", format=kind
        )
    if (from_s or 0.0) < 0.0 or (to_s is not None and to_s <= (from_s or 0.0)):
        raise stretch_empty()


def stretch_empty() -> InvalidInputError:
    """There is nothing in the stretch that was asked for."""
    return InvalidInputError(
        "export_stretch_empty", "There is nothing of the flight in this stretch: it ends before it begins, or is empty."
    )


def file_name(flight: str, kind: ExportFormat, topics: Sequence[str] | None = None) -> str:
    """The name of the file: with the flight's own time, and the topic where it is a file of one topic."""
    if is_single(kind, topics) and topics:
        return f"{flight}-{topics[0]}{_SINGLE[kind]}"
    stem = f"{flight}-{kind}" if kind in _SINGLE else flight
    return stem + _ENDINGS[kind]


def is_single(kind: ExportFormat, topics: Sequence[str] | None) -> bool:
    """Whether the export is one table and no archive."""
    return kind in _SINGLE and topics is not None and len(topics) == 1
