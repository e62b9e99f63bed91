"""Takes the speeds out of a track that nobody flew: samples were read late, and each at its own.

A sample can only have been taken before it was read. So, from the last to the first, each is taken to be so early that
the step to the next is no faster than the aircraft flew there: by its own speed where it is sent and believable, or by
the way of some seconds.
"""

from __future__ import annotations

from pathlib import Path
from typing import Final

import numpy as np
import numpy.typing as npt

from epf_gcs.flights import over_ground
from epf_gcs.formats.samples import Samples

Column = npt.NDArray[np.float64]

# How much faster than was flown a step may be; times are whole milliseconds, which takes as much again at 50 Hz.
_FASTER: Final = 1.05
# The way around a sample that gives a speed.
_AROUND_S: Final = 5.0
# A sent speed that is less than this share of the way's is not one over the ground.
_BELIEVED: Final = 0.5
_LEAST_M_S: Final = 1.0
_ROWS: Final = 65_536
_T, _LATITUDE, _LONGITUDE, _SPEED = map(Samples._fields.index, ("t_s", "latitude_deg", "longitude_deg", "speed_mps"))


def pace(path: Path, lines: list[tuple[int, int]]) -> None:
    """Set the times of these lines (first row and end) of a file of `Samples`, in place. Raises OSError."""
    if not lines:
        return
    table = np.memmap(path, dtype="<f8", mode="r+")
    rows: Column = table.reshape(-1, len(Samples._fields))
    for first, end in lines:
        for begin in reversed(range(first, end, _ROWS)):
            # With the first row of the part behind, whose time is set already.
            _pace(rows[begin : min(end, begin + _ROWS + 1)])
    table.flush()


def steps_m(rows: Column) -> Column:
    """The way over the ground between each two rows of `Samples`."""
    return over_ground.steps_m(rows[:, _LATITUDE], rows[:, _LONGITUDE])


def _pace(rows: Column) -> None:
    t_s = np.array(rows[:, _T])
    if len(t_s) < 2:
        return
    step_m = steps_m(rows)
    speed = _speeds(t_s, step_m, np.array(rows[:, _SPEED]))
    least_s = step_m / (_FASTER * np.maximum(np.maximum(speed[1:], speed[:-1]), _LEAST_M_S))
    since_s = np.concatenate(([0.0], np.cumsum(np.maximum(least_s, 1.5e-3))))
    latest_s = np.minimum.accumulate((t_s - since_s)[::-1])[::-1] + since_s
    early = latest_s < t_s - 1e-6
    rows[early, _T] = np.floor(latest_s[early] * 1e3) / 1e3


def _speeds(t_s: Column, step_m: Column, sent: Column) -> Column:
    """Speed over the ground (m/s) at each point."""
    way_m = np.concatenate(([0.0], np.cumsum(step_m)))
    first = np.searchsorted(t_s, t_s - _AROUND_S)
    last = np.searchsorted(t_s, t_s + _AROUND_S, side="right") - 1
    around = (way_m[last] - way_m[first]) / np.maximum(t_s[last] - t_s[first], 1e-3)
    return np.where(sent >= _BELIEVED * around, sent, around)
