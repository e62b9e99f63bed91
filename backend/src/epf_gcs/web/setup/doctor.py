"""Has `epf-gcs doctor` look at this computer, in a process of its own that lets all others go first."""

from __future__ import annotations

import asyncio
import subprocess
import sys
from pathlib import Path
from typing import Final

import structlog
from pydantic import TypeAdapter

from epf_gcs.errors import ConflictError
from epf_gcs.formats.kml_words import Language
from epf_gcs.system.priority import WAITED_FOR, slow_down
from epf_gcs.web.setup.schemas import DoctorFinding
from epf_gcs.workers.child import child

LONGEST_S: Final = 60.0
"""Of each question, with the wait for those before it."""
# Known as a program only: it looks at the other programs from outside.
_PROGRAM: Final = ("-m", "epf_gcs.launcher.gateway", "doctor", "--json")
_FINDINGS: Final = TypeAdapter(list[DoctorFinding])

log = structlog.get_logger("web")


class Doctor:
    """Owned by the event loop."""

    def __init__(self, data_dir: Path, program: tuple[str, ...] = _PROGRAM, longest_s: float = LONGEST_S) -> None:
        self._program = program
        self._data = data_dir
        self._longest_s = longest_s
        self._one_at_a_time = asyncio.Lock()

    async def look(self, port: int, language: Language) -> list[DoctorFinding]:
        """What is there now, in the order in which it was looked at. `port`: TCP, the station's own.

        Raises ConflictError if it could not be found out.
        """
        try:
            async with asyncio.timeout(self._longest_s), self._one_at_a_time:
                return _FINDINGS.validate_json(await self._run(port, language))
        except TimeoutError:
            raise ConflictError(
                "doctor_late",
                f"Looking at this computer took more than {self._longest_s:.0f} s and was given up: try again later.",
                seconds=self._longest_s,
            ) from None
        except (OSError, ValueError) as error:
            log.error("the doctor failed", reason=str(error))
            raise ConflictError(
                "doctor_failed", "The doctor failed: run `epf-gcs doctor` on the station's computer."
            ) from error

    async def _run(self, port: int, language: Language) -> bytes:
        asked = ("--data-dir", str(self._data), "--port", str(port), "--language", language)
        streams = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE}
        async with child(sys.executable, *self._program, *asked, **streams) as process:
            slow_down(process.pid, WAITED_FOR)
            said, _ = await process.communicate()
        return said
