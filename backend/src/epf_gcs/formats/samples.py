"""Some points of a flown line as columns, for the writers of track files: one column is one fast operation."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

Column = npt.NDArray[np.float64]


class Samples(NamedTuple):
    """Unix time, place (degrees, metres above mean sea level) and attitude of as many points as each column is long.

    Heading from true north, pitch nose up, roll right wing down; all three NaN where the attitude was not known.
    """

    t_s: Column
    latitude_deg: Column
    longitude_deg: Column
    altitude_m: Column
    heading_deg: Column
    pitch_deg: Column
    roll_deg: Column
