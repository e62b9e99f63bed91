"""The choice of ground and fence as a file of the data folder."""

from __future__ import annotations

import contextlib
import time
from pathlib import Path
from typing import Final

import structlog
from pydantic import ValidationError

from epf_gcs.disk import replace_file
from epf_gcs.errors import ConflictError
from epf_gcs.surroundings.choice import SurroundingsChange

FILE_NAME: Final = "surroundings.json"
OFF: Final = SurroundingsChange(
    terrain_on=False, margin_ft=150, fence_on=False, corners=[], ceiling_ft=None, fence_margin_ft=100
)
"""Nothing warns until somebody chooses it."""

log = structlog.get_logger("gateway")


class KeptSurroundings:
    """Blocks: called from a thread."""

    def __init__(self, data_dir: Path) -> None:
        self._path = data_dir / FILE_NAME

    def read(self) -> SurroundingsChange:
        """The choice. A file that cannot be read is kept aside under another name, and everything is off."""
        try:
            return SurroundingsChange.model_validate_json(self._path.read_bytes())
        except FileNotFoundError:
            return OFF
        except ValidationError:
            aside = self._path.with_name(f"{FILE_NAME}.damaged-{time.time_ns() // 1_000_000_000}")
            with contextlib.suppress(OSError):
                self._path.replace(aside)
            log.warning("the fence cannot be read and is kept aside", kept_as=str(aside))
            return OFF
        except OSError as error:
            log.warning("the fence cannot be read", reason=error.strerror or str(error))
            return OFF

    def write(self, choice: SurroundingsChange) -> None:
        """Keep the choice. Raises ConflictError if the disk does not take it."""
        try:
            replace_file(self._path, choice.model_dump_json().encode())
        except OSError as error:
            reason = error.strerror or str(error)
            raise ConflictError(
                "surroundings_not_kept",
                f"The fence cannot be kept: {reason}. Look at the disk of the station.",
                reason=reason,
            ) from error
