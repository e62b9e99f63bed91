"""What the simulator flew, a column for each quantity. Every judgement is made from this, never from what a board says
of itself."""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, fields
from typing import Final, Protocol

import numpy as np
import numpy.typing as npt

Column = npt.NDArray[np.float64]
"""One value for each frame."""


class State(Protocol):
    """What of the aircraft is judged."""

    @property
    def latitude_deg(self) -> float:
        """North is positive."""

    @property
    def longitude_deg(self) -> float:
        """East is positive."""

    @property
    def altitude_ft(self) -> float:
        """Above mean sea level."""

    @property
    def airspeed_indicated_kt(self) -> float:
        """Forward."""


class Sample(Protocol):
    """One instant of a flight, from whatever flew it."""

    @property
    def time_s(self) -> float:
        """Simulated time."""

    @property
    def state(self) -> State:
        """The aircraft."""

    @property
    def waypoint(self) -> int:
        """From 0; -1 without a plan."""


@dataclass(frozen=True, slots=True)
class Truth:
    """Columns of equal length, in the order of time. `waypoint`: where the board says that it flies to; -1 without."""

    time_s: Column
    latitude_deg: Column
    longitude_deg: Column
    altitude_ft: Column
    airspeed_kt: Column
    waypoint: Column

    @classmethod
    def of(cls, samples: Iterable[Sample]) -> Truth:
        """The columns of a list of samples."""
        flat = array("d")
        for sample in samples:
            state = sample.state
            flat.extend(
                (
                    sample.time_s,
                    state.latitude_deg,
                    state.longitude_deg,
                    state.altitude_ft,
                    state.airspeed_indicated_kt,
                    sample.waypoint,
                )
            )
        return cls.from_rows(flat)

    @classmethod
    def from_rows(cls, flat: array[float]) -> Truth:
        """The columns of a flat list of rows, each with one value for each column."""
        table = np.array(flat, dtype=np.float64).reshape(-1, len(NAMES))
        return cls(*table.T.copy())

    def __len__(self) -> int:
        return len(self.time_s)

    def part(self, first: int, end: int) -> Truth:
        """The frames from `first` until before `end`."""
        return Truth(*(column[first:end] for column in self.columns()))

    def columns(self) -> Iterator[Column]:
        """In the order of `NAMES`."""
        return (getattr(self, name) for name in NAMES)


NAMES: Final = tuple(field.name for field in fields(Truth))
