"""Where and how a flight begins: the place, the wind, and the three starts."""

import math
from dataclasses import dataclass
from enum import StrEnum
from typing import Final

from epf_gcs.earth import M_PER_DEG
from epf_gcs.units import M_PER_FT, MPS_PER_KT

# Gran Canaria (GCLP), reference point and elevation. The runway's direction is that of the Gando
# route's last legs, 27.9045 N 15.4041 W to 27.9319 N 15.3866 W.
AIRPORT_LATITUDE_DEG: Final = 27.9319
AIRPORT_LONGITUDE_DEG: Final = -15.3866
AIRPORT_ELEVATION_FT: Final = 78.0
RUNWAY_HEADING_DEG: Final = 29.4

FT_PER_M: Final = 1.0 / M_PER_FT
FT_S_PER_KT: Final = MPS_PER_KT * FT_PER_M

AIR_ALTITUDE_FT: Final = 1000.0
FINAL_PATH_DEG: Final = -3.0
FINAL_DISTANCE_M: Final = 1500.0
FINAL_ALTITUDE_FT: Final = AIRPORT_ELEVATION_FT - FINAL_DISTANCE_M * math.tan(math.radians(FINAL_PATH_DEG)) * FT_PER_M


class Start(StrEnum):
    """How a flight begins."""

    AIR = "air"
    RUNWAY = "runway"
    FINAL = "final"


class Turbulence(StrEnum):
    """Turbulence of MIL-F-8785C, by name."""

    NONE = "none"
    LIGHT = "light"
    MODERATE = "moderate"
    SEVERE = "severe"


@dataclass(frozen=True, slots=True)
class Wind:
    """Steady wind: the true direction it blows from, and its speed."""

    from_deg: float
    speed_kt: float

    def towards_ft_s(self) -> tuple[float, float]:
        """Velocity of the air, north and east [ft/s]."""
        speed = self.speed_kt * FT_S_PER_KT
        angle = math.radians(self.from_deg)
        return -speed * math.cos(angle), -speed * math.sin(angle)


CALM: Final = Wind(0.0, 0.0)


@dataclass(frozen=True, slots=True)
class Loading:
    """How this aircraft differs from the one that its model describes.

    `mass_factor` of its mass; centre of gravity further aft by `cg_aft_m`; `control_power`: what share of its usual
    deflection a surface reaches.
    """

    mass_factor: float = 1.0
    cg_aft_m: float = 0.0
    control_power: float = 1.0

    @property
    def moves_mass(self) -> bool:
        """Whether weights have to be put into the aircraft."""
        return self.mass_factor != 1.0 or self.cg_aft_m != 0.0


@dataclass(frozen=True, slots=True)
class Situation:
    """The beginning of a flight and its weather. On final the place is the threshold ahead."""

    start: Start = Start.AIR
    latitude_deg: float = AIRPORT_LATITUDE_DEG
    longitude_deg: float = AIRPORT_LONGITUDE_DEG
    heading_deg: float = RUNWAY_HEADING_DEG
    wind: Wind = CALM
    turbulence: Turbulence = Turbulence.NONE
    seed: int = 1
    loading: Loading = Loading()

    def place(self) -> tuple[float, float]:
        """Latitude and longitude [deg] of the first instant."""
        if self.start is not Start.FINAL:
            return self.latitude_deg, self.longitude_deg
        angle = math.radians(self.heading_deg)
        north_m = -FINAL_DISTANCE_M * math.cos(angle)
        east_m = -FINAL_DISTANCE_M * math.sin(angle)
        shrink = math.cos(math.radians(self.latitude_deg))
        return (
            self.latitude_deg + north_m / M_PER_DEG,
            self.longitude_deg + east_m / (M_PER_DEG * shrink),
        )


def parse_wind(text: str) -> Wind:
    """Read `FROM/SPEED`, degrees true and knots, as in `330/20`; raises ValueError with what is wrong."""
    direction, slash, speed = text.partition("/")
    try:
        wind = Wind(float(direction) % 360.0, float(speed))
    except ValueError:
        raise ValueError(f"wind {text!r} is not FROM/SPEED, as in 330/20") from None
    if not slash or not math.isfinite(wind.from_deg) or not 0.0 <= wind.speed_kt <= 100.0:
        raise ValueError(f"wind {text!r} is not a direction and a speed of 0..100 kt, as in 330/20")
    return wind
