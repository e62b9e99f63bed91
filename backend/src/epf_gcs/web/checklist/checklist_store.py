"""The checklist as a file of the data folder."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import structlog

from epf_gcs.disk import KeptFile
from epf_gcs.errors import ConflictError
from epf_gcs.web.checklist.schemas import Checklist, ChecklistChange

FILE_NAME: Final = "checklist.json"

log = structlog.get_logger("gateway")


class KeptChecklist:
    """Blocks: called from a thread."""

    def __init__(self, data_dir: Path) -> None:
        self._file = KeptFile(
            data_dir / FILE_NAME, ChecklistChange.model_validate_json, lambda change: change.model_dump_json().encode()
        )

    def read(self) -> Checklist:
        """The list. A file that cannot be read is kept aside under another name, and the list is the page's own again.

        Raises ConflictError if the disk cannot be read.
        """
        try:
            kept = self._file.read_or_set_aside(
                lambda aside: log.warning(
                    "the checklist cannot be read and is kept aside", kept_as=None if aside is None else str(aside)
                )
            )
        except OSError as error:
            raise _fault(error) from error
        return Checklist(lines=None if kept is None else kept.lines)

    def write(self, change: ChecklistChange | None) -> Checklist:
        """Keep the list; None: forget it. Raises ConflictError if the disk does not take it."""
        try:
            self._file.write(change)
        except OSError as error:
            raise _fault(error) from error
        return Checklist(lines=None if change is None else change.lines)


def _fault(error: OSError) -> ConflictError:
    reason = error.strerror or str(error)
    return ConflictError(
        "checklist_not_kept", f"The checklist cannot be kept: {reason}. Look at the disk of the station.", reason=reason
    )
