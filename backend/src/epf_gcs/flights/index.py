"""`index FILE`: makes the columns of a recording of this data folder; says what it counted."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from epf_gcs.flights.columns import Say, write_columns

_COLUMNS = "columns"


def run(arguments: list[str], say: Say) -> dict[str, Any]:
    """The columns go beside the folder that holds the recording. Raises RecordingError, OSError."""
    (path,) = (Path(argument).resolve() for argument in arguments)
    written = write_columns(path, path.parent.parent / _COLUMNS, say)
    return {"folder": str(written.folder), **written.counts.as_dict()}
