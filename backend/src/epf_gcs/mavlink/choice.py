"""What a person chose when the program was started."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Aircraft = Literal["flight", "hil"]


@dataclass(frozen=True, slots=True)
class Home:
    """Where heights above home begin: degrees, metres above mean sea level."""

    latitude_deg: float
    longitude_deg: float
    altitude_m: float


@dataclass(frozen=True, slots=True)
class Choice:
    """Which of the board's two aircraft is told of. `usual_speed_kt`: of waypoints before which a plan names none."""

    aircraft: Aircraft = "flight"
    home: Home | None = None
    usual_speed_kt: float | None = None
