"""`report FILE [--compare FILE2] [--page LANGUAGE]`: the report of an indexed flight, kept beside its columns."""

from __future__ import annotations

import contextlib
from pathlib import Path
from typing import Final

import msgspec

from epf_gcs.contract.report import FlightReport
from epf_gcs.flights.worker import Say
from epf_gcs.recordings.places import SUMMARY, Places

FILE: Final = "report.json"
VERSION: Final = 3
"""Reports of another version are made anew."""


class KeptReport(msgspec.Struct):
    """The file. `stamp` is of the columns that the report was made of."""

    version: int
    stamp: int
    report: FlightReport


def run(arguments: list[str], say: Say) -> dict[str, FlightReport | str]:
    """{"report"}, or {"page"} as HTML; the earlier flight stands beside its own. Raises GatewayError, OSError."""
    file, options = arguments[0], dict(zip(arguments[1::2], arguments[2::2], strict=True))
    found = report_of(Path(file).resolve(), say, 0.5)
    if "--compare" in options:
        earlier = report_of(Path(options["--compare"]).resolve(), say, 0.9)
        from epf_gcs.flights.report.compare import compare  # noqa: PLC0415 - loads numpy

        found = compare(found, earlier)
    if "--page" in options:
        from epf_gcs.flights.report.page import page  # noqa: PLC0415 - only where it is asked for

        return {"page": page(found, options["--page"])}
    return {"report": found}


def report_of(recording: Path, say: Say, share: float) -> FlightReport:
    """The report that is kept, or a new one. Raises ConflictError while the flight is not indexed, OSError."""
    folder = Places(recording.parent.parent).made_of(recording.stem)
    if folder is not None:
        kept = _kept(folder)
        if kept is not None:
            say(share, "report")
            return kept
    from epf_gcs.flights.report.making import make  # noqa: PLC0415 - loads the query engine

    found = make(recording, folder)
    if folder is not None:
        keep(folder, found)
    say(share, "report")
    return found


def keep(folder: Path, report: FlightReport) -> None:
    """Keep it beside the columns, whole or not at all; a full disk only costs the time to make it again."""
    part = folder / f".{FILE}.part"
    with contextlib.suppress(OSError):
        part.write_bytes(msgspec.json.encode(KeptReport(VERSION, _stamp(folder), report)))
        part.replace(folder / FILE)


def _kept(folder: Path) -> FlightReport | None:
    with contextlib.suppress(OSError, msgspec.DecodeError):
        kept = msgspec.json.decode((folder / FILE).read_bytes(), type=KeptReport)
        if kept.version == VERSION and kept.stamp == _stamp(folder):
            return kept.report
    return None


def _stamp(folder: Path) -> int:
    """Columns that are made again have a summary of another time."""
    return (folder / SUMMARY).stat().st_mtime_ns
