"""The state and the controls of the aircraft: values only, in X-Plane's signs.

Elevator + is nose up, aileron + right wing down, rudder + nose right; pitch + is up, roll + right;
p, q, r turn about the body's forward, right and down axes.
"""

from dataclasses import dataclass
from typing import Final


@dataclass(frozen=True, slots=True)
class Controls:
    """Surfaces -1..1 and throttle 0..1."""

    elevator: float
    aileron: float
    rudder: float
    throttle: float


NEUTRAL: Final = Controls(0.0, 0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class FlightState:
    """One instant of the flight. Angles deg, body rates rad/s, altitudes ft, speeds kt, loads g."""

    latitude_deg: float  # geodetic, north +
    longitude_deg: float  # east +
    altitude_ft: float  # above mean sea level
    altitude_agl_ft: float
    altitude_indicated_ft: float  # pressure altitude at 29.92 inHg
    roll_deg: float
    pitch_deg: float
    heading_deg: float  # true, 0..360
    p_rad_s: float
    q_rad_s: float
    r_rad_s: float
    airspeed_indicated_kt: float
    airspeed_true_kt: float
    speed_ground_kt: float
    mach: float
    vvi_ft_min: float  # climb +
    load_normal_g: float  # 1 in level flight
    load_axial_g: float  # forward +
    load_side_g: float  # right +
    alpha_deg: float  # nose above the airflow +
    beta_deg: float  # air from the right +
    track_deg: float  # ground track, true, 0..360
    path_deg: float  # flight path over the ground, climb +
    pressure_inhg: float
    temperature_degc: float
    on_ground: bool
    touching: str | None  # a part that touches the ground and must not
    surfaces: Controls  # where the surfaces and the throttle are now
