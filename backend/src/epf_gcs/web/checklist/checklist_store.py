"""The checklist as a file of the data folder."""

from __future__ import annotations

import contextlib
import time
from pathlib import Path
from typing import Final

import structlog
from pydantic import ValidationError

from epf_gcs.disk import replace_file
from epf_gcs.errors import ConflictError
from epf_gcs.web.checklist.schemas import Checklist, ChecklistChange

FILE_NAME: Final = "checklist.json"

log = structlog.get_logger("gateway")


class KeptChecklist:
    """Blocks: called from a thread."""

    def __init__(self, data_dir: Path) -> None:
        self._path = data_dir / FILE_NAME

    def read(self) -> Checklist:
        """The list. A file that cannot be read is kept aside under another name, and the list is the page's own again.

        Raises ConflictError if the disk cannot be read.
        """
        try:
            return Checklist(lines=ChecklistChange.model_validate_json(self._path.read_bytes()).lines)
        except FileNotFoundError:
            return Checklist(lines=None)
        except ValidationError:
            aside = self._path.with_name(f"{FILE_NAME}.damaged-{time.time_ns() // 1_000_000_000}")
            with contextlib.suppress(OSError):
                self._path.replace(aside)
            log.warning("the checklist cannot be read and is kept aside", kept_as=str(aside))
            return Checklist(lines=None)
        except OSError as error:
            raise _fault(error) from error

    def write(self, change: ChecklistChange | None) -> Checklist:
        """Keep the list; None: forget it. Raises ConflictError if the disk does not take it."""
        try:
            if change is None:
                self._path.unlink(missing_ok=True)
                return Checklist(lines=None)
            replace_file(self._path, change.model_dump_json().encode())
        except OSError as error:
            raise _fault(error) from error
        return Checklist(lines=change.lines)


def _fault(error: OSError) -> ConflictError:
    reason = error.strerror or str(error)
    return ConflictError(
        "checklist_not_kept", f"The checklist cannot be kept: {reason}. Look at the disk of the station.", reason=reason
    )
