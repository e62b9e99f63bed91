"""`export FILE FORMAT OUT ...`: writes a recording, or what was made of it, as a file of another program.

`OUT` is whole or not there. It says {"bytes"}.
"""

from __future__ import annotations

import shutil
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import Final

from epf_gcs.flights.export.asked import ExportRequest, Progress, read_arguments
from epf_gcs.flights.worker import Say

Write = Callable[[ExportRequest, Path, Path, Progress], None]
"""Writes the target; the other path is a folder for what is kept aside meanwhile."""

_MODULES: Final = {
    "mcap": "recorded_mcap",
    "mcap-decoded": "decoded_mcap",
    "csv": "csv_tables",
    "parquet": "parquet_tables",
    "kml": "track_files",
    "kmz": "track_files",
    "gpx": "track_files",
    "czml": "track_files",
}


def run(arguments: list[str], say: Say) -> dict[str, int]:
    """Raises GatewayError, OSError."""
    asked, target = read_arguments(arguments)
    progress = Progress(say, target.parent, asked.name)
    target.parent.mkdir(parents=True, exist_ok=True)
    part, aside = target.with_name(f".{target.name}.part"), target.with_name(f".{target.name}.aside")
    try:
        aside.mkdir(exist_ok=True)
        progress.at(0.0)
        # Loaded here, so that no format pays for the libraries of another.
        write: Write = import_module(f"epf_gcs.flights.export.{_MODULES[asked.format]}").write
        write(asked, part, aside, progress)
        progress.at(1.0)
        part.replace(target)
    finally:
        part.unlink(missing_ok=True)
        shutil.rmtree(aside, ignore_errors=True)
    return {"bytes": target.stat().st_size}
