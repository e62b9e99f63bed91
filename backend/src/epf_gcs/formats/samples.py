"""Points of a flown line as numpy columns, which the writers of track files process fast."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

Column = npt.NDArray[np.float64]


class Samples(NamedTuple):
    """Columns of equal length: Unix time, position (degrees, metres above mean sea level) and attitude of each point.

    Heading clockwise from true north; pitch + nose up, roll + right wing down; all three NaN if not known. Speed and
    course over the ground (clockwise from true north) are NaN where nobody sent them.
    """

    t_s: Column
    latitude_deg: Column
    longitude_deg: Column
    altitude_m: Column
    heading_deg: Column
    pitch_deg: Column
    roll_deg: Column
    speed_mps: Column
    course_deg: Column
