"""Shapes of the checklist."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from epf_gcs.contract.shapes import Input, Output

Watched = Literal["gps", "battery", "gains", "plan", "recorder", "alarms"]
"""What the page can see for itself."""
MOST_LINES = 100


class ChecklistLine(Input):
    """One line. `watched`: the page ticks it by itself while it is so; null: a person ticks it."""

    text: Annotated[str, Field(min_length=1, max_length=200, pattern=r"\S")]
    watched: Watched | None


class ChecklistChange(Input):
    """The whole list as it shall be."""

    lines: Annotated[list[ChecklistLine], Field(max_length=MOST_LINES)]


class Checklist(Output):
    """`lines` is null while nobody has changed the list: the page then shows its own, in the reader's language."""

    lines: list[ChecklistLine] | None
