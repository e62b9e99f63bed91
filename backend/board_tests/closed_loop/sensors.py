"""Sensors of a small aircraft, made of the simulator's truth: bias, drift with temperature, noise and delay.

Body axes are forward, right, down. The figures are those of cheap MEMS parts after calibration.
"""

import math
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from random import Random
from typing import Final

from pygeomag import GeoMag

from epf_gcs.simulator.state import FlightState

# The year that the board's table of the magnetic field holds for.
FIELD_YEAR: Final = 2027.5

_GRAVITY_M_S2: Final = 9.80665
_M_PER_FT: Final = 0.3048
_M_S_PER_KT: Final = 0.514444
_SEA_LEVEL_PA: Final = 101_325.0
_SOUND_M_S: Final = 340.294

_GYRO_BIAS_RAD_S: Final = math.radians(0.5)
_GYRO_DRIFT_RAD_S: Final = math.radians(0.2)  # between a cold and a warm board
_GYRO_NOISE_RAD_S: Final = math.radians(0.3)
_ACCELEROMETER_BIAS_M_S2: Final = 0.05
_ACCELEROMETER_NOISE_M_S2: Final = 0.3  # a motor shakes it
_MAGNETOMETER_BIAS: Final = 0.01
_MAGNETOMETER_NOISE: Final = 0.01
_STATIC_BIAS_PA: Final = 10.0
_STATIC_NOISE_PA: Final = 3.0
_PITOT_BIAS_PA: Final = 2.0
_PITOT_NOISE_PA: Final = 4.0

_WARM_AFTER_S: Final = 180.0
_DELAY_FRAMES: Final = 1

_MODEL: Final = GeoMag(coefficients_file="wmm/WMM_2025.COF")

Vector = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Samples:
    """One reading of every sensor, in the units of the firmware's `estimator_samples_t`."""

    gyro_rad_s: Vector
    accelerometer_m_s2: Vector
    magnetometer: Vector
    static_pa: float
    pitot_pa: float


class SensorModel:
    """The sensors of one board: the seed decides their errors. Each call is the next frame."""

    def __init__(self, seed: int) -> None:
        self._random = Random(seed)
        self._gyro_bias = self._sizes(_GYRO_BIAS_RAD_S)
        self._gyro_drift = self._sizes(_GYRO_DRIFT_RAD_S)
        self._accelerometer_bias = self._sizes(_ACCELEROMETER_BIAS_M_S2)
        self._magnetometer_bias = self._sizes(_MAGNETOMETER_BIAS)
        self._under_way: deque[Samples] = deque(maxlen=_DELAY_FRAMES + 1)

    def read(self, state: FlightState, time_s: float) -> Samples:
        """Measure this instant; what comes out is a frame old."""
        warmth = 1.0 - math.exp(-time_s / _WARM_AFTER_S)
        gyro_bias = [bias + drift * warmth for bias, drift in zip(self._gyro_bias, self._gyro_drift, strict=True)]
        # The simulator's loads are felt forces over g: normal is up, the body's z axis down.
        force = [g * _GRAVITY_M_S2 for g in (state.load_axial_g, state.load_side_g, -state.load_normal_g)]
        rates = (state.p_rad_s, state.q_rad_s, state.r_rad_s)
        altitude_m = state.altitude_indicated_ft * _M_PER_FT
        speed_m_s = state.airspeed_indicated_kt * _M_S_PER_KT
        static_pa = _SEA_LEVEL_PA * (1.0 - altitude_m / 44_330.8) ** 5.25588
        pitot_pa = _SEA_LEVEL_PA * ((1.0 + 0.2 * (speed_m_s / _SOUND_M_S) ** 2) ** 3.5 - 1.0)
        self._under_way.append(
            Samples(
                gyro_rad_s=self._measured(rates, gyro_bias, _GYRO_NOISE_RAD_S),
                accelerometer_m_s2=self._measured(force, self._accelerometer_bias, _ACCELEROMETER_NOISE_M_S2),
                magnetometer=self._measured(field(state), self._magnetometer_bias, _MAGNETOMETER_NOISE),
                static_pa=static_pa + _STATIC_BIAS_PA + self._random.gauss(0.0, _STATIC_NOISE_PA),
                pitot_pa=pitot_pa + _PITOT_BIAS_PA + self._random.gauss(0.0, _PITOT_NOISE_PA),
            )
        )
        return self._under_way[0]

    def _sizes(self, size: float) -> list[float]:
        """An error of this size along each axis, of either sign."""
        return [self._random.choice((-size, size)) for _ in range(3)]

    def _measured(self, truth: Sequence[float], bias: list[float], noise: float) -> Vector:
        x, y, z = (value + error + self._random.gauss(0.0, noise) for value, error in zip(truth, bias, strict=True))
        return x, y, z


@cache
def _unit_field(latitude_deg: float, longitude_deg: float) -> Vector:
    """North, east and down, of length 1, at sea level."""
    strength = reference_field_nt(latitude_deg, longitude_deg)
    length = math.hypot(*strength)
    return strength[0] / length, strength[1] / length, strength[2] / length


def reference_field_nt(latitude_deg: float, longitude_deg: float) -> Vector:
    """North, east and down at sea level, by an implementation of the World Magnetic Model that is not the board's."""
    result = _MODEL.calculate(glat=latitude_deg, glon=longitude_deg, alt=0.0, time=FIELD_YEAR)
    return result.x, result.y, result.z


def field(state: FlightState) -> Vector:
    """The earth's magnetic field in body axes."""
    north, east, down = _unit_field(round(state.latitude_deg, 1), round(state.longitude_deg, 1))
    yaw, pitch, roll = (math.radians(angle) for angle in (state.heading_deg, state.pitch_deg, state.roll_deg))
    ahead = math.cos(yaw) * north + math.sin(yaw) * east
    aside = -math.sin(yaw) * north + math.cos(yaw) * east
    below = math.sin(pitch) * ahead + math.cos(pitch) * down
    return (
        math.cos(pitch) * ahead - math.sin(pitch) * down,
        math.cos(roll) * aside + math.sin(roll) * below,
        -math.sin(roll) * aside + math.cos(roll) * below,
    )
