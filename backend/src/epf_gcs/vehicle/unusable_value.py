"""A value of the simulator's rows that the board needs and that cannot be used."""

from __future__ import annotations

from typing import NamedTuple

from epf_gcs.codec.messages_gen import XPLANE_ROWS
from epf_gcs.contract import status


class UnusableValue(NamedTuple):
    """Not a number, "no value" (-999), or beyond its range; as it came in its row, in the simulator's unit."""

    row: int
    name: str
    value: float

    @property
    def state(self) -> status.UnusableValue:
        """As it is shown; the value as text, for JSON knows no NaN."""
        return status.UnusableValue(self.row, self._row_name, self.name, f"{self.value:g}")

    @property
    def sentence(self) -> str:
        """Why the loop is open, and what to do."""
        return (
            f"The HIL loop is open: in row {self.row} ({self._row_name}) the simulator sends {self.value:g} as "
            f"{self.name}, which cannot be used. Load the aircraft in the simulator again, and look at that row there."
        )

    @property
    def _row_name(self) -> str:
        return XPLANE_ROWS["xp10"][self.row].name
