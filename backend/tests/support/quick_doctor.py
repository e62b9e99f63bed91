"""A doctor that takes no time: the real one starts a program for each look."""

from __future__ import annotations

from epf_gcs.web.setup.schemas import DoctorFinding


class QuickDoctor:
    """In the place of `Doctor` in a station's parts. It says what it was asked."""

    async def look(self, port: int, language: str) -> list[DoctorFinding]:
        """One finding."""
        return [DoctorFinding(state="note", what=f"{port} {language}", mend="sudo")]
