"""The choice of ground and fence as a file of the data folder."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import structlog

from epf_gcs.disk import DamagedFileError, KeptFile, set_aside
from epf_gcs.errors import ConflictError
from epf_gcs.surroundings.choice import SurroundingsChange, crossing

FILE_NAME: Final = "surroundings.json"
OFF: Final = SurroundingsChange(
    terrain_on=False, margin_ft=150, fence_on=False, corners=[], ceiling_ft=None, fence_margin_ft=100
)
"""Nothing warns until somebody chooses it."""

log = structlog.get_logger("gateway")


class KeptSurroundings:
    """Blocks: called from a thread."""

    def __init__(self, data_dir: Path) -> None:
        self._file = KeptFile(
            data_dir / FILE_NAME,
            SurroundingsChange.model_validate_json,
            lambda choice: choice.model_dump_json().encode(),
        )

    def read(self) -> SurroundingsChange | None:
        """The choice; None if there is one that cannot be read. Its file stays until another choice replaces it, so
        that no restart takes an unknown choice for none."""
        try:
            choice = self._file.read() or OFF
            if crossing(choice) is None:
                return choice
            log.warning("the fence that was chosen crosses itself", file=str(self._file.path))
        except DamagedFileError:
            log.warning("the choice of ground and fence is damaged", file=str(self._file.path))
        except OSError as error:
            log.warning("the choice of ground and fence cannot be read", reason=error.strerror or str(error))
        return None

    def write(self, choice: SurroundingsChange) -> None:
        """Keep the choice, and one that cannot be read beside it. Raises ConflictError if the disk does not take it."""
        try:
            if self.read() is None:
                set_aside(self._file.path)
            self._file.write(choice)
        except OSError as error:
            reason = error.strerror or str(error)
            raise ConflictError(
                "surroundings_not_kept",
                f"The fence cannot be kept: {reason}. Look at the disk of the station.",
                reason=reason,
            ) from error
