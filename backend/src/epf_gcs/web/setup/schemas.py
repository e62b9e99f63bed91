"""Shapes of setting a station up."""

from __future__ import annotations

from typing import Literal

from epf_gcs.contract.shapes import Output


class FirstStartState(Output):
    """`is_due`: nobody has set this station up yet, and nobody has put it off."""

    is_due: bool


class DoctorFinding(Output):
    """One thing that was looked at: what was found, and what to do about it ("" if nothing)."""

    state: Literal["ok", "note", "fault"]
    what: str
    mend: str


class DoctorReport(Output):
    """All that was looked at, in that order."""

    findings: list[DoctorFinding]
