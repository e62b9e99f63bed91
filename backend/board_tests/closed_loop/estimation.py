"""The firmware's estimator in this process, out of `libepf-flight.so`, and how its errors are measured."""

import ctypes
import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import Final, Self

from board_tests.closed_loop.sensors import Samples, SensorModel
from epf_gcs.lab.closed_loop import Sample
from epf_gcs.lab.figures import rms
from epf_gcs.lab.laws import library as laws_library
from epf_gcs.simulator.state import FlightState

GYRO, ACCELEROMETER, MAGNETOMETER, STATIC_PRESSURE, PITOT = SENSORS = tuple(range(5))

_FT_PER_M: Final = 1.0 / 0.3048
_FT_MIN_PER_M_S: Final = 60.0 * _FT_PER_M
_KT_PER_M_S: Final = 1.0 / 0.514444
_Vector: Final = ctypes.c_float * 3


class _EstimatorSamples(ctypes.Structure):
    """`estimator_samples_t`."""

    _fields_ = (
        ("gyro_rad_s", _Vector),
        ("accelerometer_m_s2", _Vector),
        ("magnetometer", _Vector),
        ("static_pa", ctypes.c_float),
        ("pitot_pa", ctypes.c_float),
        ("is_measured", ctypes.c_bool * len(SENSORS)),
    )


class _Estimate(ctypes.Structure):
    """`estimate_t`."""

    _fields_ = (
        ("yaw_deg", ctypes.c_float),
        ("pitch_deg", ctypes.c_float),
        ("roll_deg", ctypes.c_float),
        ("rate_rad_s", _Vector),
        ("altitude_m", ctypes.c_float),
        ("vertical_speed_m_s", ctypes.c_float),
        ("calibrated_airspeed_m_s", ctypes.c_float),
    )


@dataclass(frozen=True, slots=True)
class Error:
    """Estimate less truth at one instant."""

    time_s: float
    heading_deg: float
    pitch_deg: float
    roll_deg: float
    altitude_ft: float
    vvi_ft_min: float
    speed_kt: float

    def tilt_deg(self) -> float:
        """The larger one of pitch and roll."""
        return max(abs(self.pitch_deg), abs(self.roll_deg))


class Estimator:
    """The board's estimator, knowing nothing yet."""

    def __init__(self) -> None:
        library = ctypes.CDLL(str(laws_library()))
        library.epf_estimation_new.restype = ctypes.c_void_p
        library.epf_estimation_new.argtypes = ()
        library.epf_estimation_free.argtypes = (ctypes.c_void_p,)
        library.epf_estimation_locate.argtypes = (ctypes.c_void_p, ctypes.c_float, ctypes.c_float)
        library.epf_estimation_step.argtypes = (
            ctypes.c_void_p,
            ctypes.POINTER(_EstimatorSamples),
            ctypes.c_float,
            ctypes.POINTER(_Estimate),
        )
        library.epf_estimation_refused.restype = ctypes.c_uint32
        library.epf_estimation_refused.argtypes = (ctypes.c_void_p, ctypes.c_uint32)
        self._library = library
        self._estimator = library.epf_estimation_new()
        self._estimate = _Estimate()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._library.epf_estimation_free(self._estimator)

    def locate(self, latitude_deg: float, longitude_deg: float) -> None:
        """Say where the aircraft is, as its GPS does."""
        self._library.epf_estimation_locate(self._estimator, latitude_deg, longitude_deg)

    def step(self, samples: Samples, dt_s: float, silent: Collection[int] = ()) -> None:
        """Take one sample of every sensor that is not silent."""
        measured = _EstimatorSamples(
            _Vector(*samples.gyro_rad_s),
            _Vector(*samples.accelerometer_m_s2),
            _Vector(*samples.magnetometer),
            samples.static_pa,
            samples.pitot_pa,
            (ctypes.c_bool * len(SENSORS))(*(sensor not in silent for sensor in SENSORS)),
        )
        self._library.epf_estimation_step(self._estimator, ctypes.byref(measured), dt_s, ctypes.byref(self._estimate))

    def error(self, state: FlightState, time_s: float) -> Error:
        """The newest estimate less the truth; NaN where the estimator does not know."""
        estimate = self._estimate
        return Error(
            time_s=time_s,
            heading_deg=(estimate.yaw_deg - state.heading_deg + 180.0) % 360.0 - 180.0,
            pitch_deg=estimate.pitch_deg - state.pitch_deg,
            roll_deg=(estimate.roll_deg - state.roll_deg + 180.0) % 360.0 - 180.0,
            altitude_ft=estimate.altitude_m * _FT_PER_M - state.altitude_indicated_ft,
            vvi_ft_min=estimate.vertical_speed_m_s * _FT_MIN_PER_M_S - state.vvi_ft_min,
            speed_kt=estimate.calibrated_airspeed_m_s * _KT_PER_M_S - state.airspeed_indicated_kt,
        )

    def refused(self, sensor: int) -> int:
        """Samples of that sensor that were refused."""
        return int(self._library.epf_estimation_refused(self._estimator, sensor))


@dataclass(frozen=True, slots=True)
class Gap:
    """A time in which the gyro is silent (or sends rubbish, where `rubbish` is a number)."""

    begin_s: float
    end_s: float
    rubbish: float | None = None

    def holds(self, time_s: float) -> bool:
        """Whether this instant lies in the gap."""
        return self.begin_s <= time_s < self.end_s


NO_GAP: Final = Gap(math.inf, math.inf)


def estimate_flight(flight: Sequence[Sample], seed: int, gap: Gap = NO_GAP) -> tuple[list[Error], int]:
    """Let the estimator see a flight through its sensors; returns its errors and the gyro samples it refused.

    The first instants, while it finds out where down is, are left out.
    """
    sensors = SensorModel(seed)
    errors = []
    dt_s = flight[1].time_s - flight[0].time_s
    with Estimator() as estimator:
        for number, sample in enumerate(flight):
            samples = sensors.read(sample.state, sample.time_s)
            silent: tuple[int, ...] = ()
            if gap.holds(sample.time_s):
                if gap.rubbish is None:
                    silent = (GYRO,)
                else:
                    rubbish = (samples.gyro_rad_s[0], gap.rubbish, samples.gyro_rad_s[2])
                    samples = Samples(
                        rubbish,
                        samples.accelerometer_m_s2,
                        samples.magnetometer,
                        samples.static_pa,
                        samples.pitot_pa,
                    )
            estimator.locate(sample.state.latitude_deg, sample.state.longitude_deg)
            estimator.step(samples, dt_s, silent)
            if number * dt_s >= ALIGNED_AFTER_S:
                errors.append(estimator.error(sample.state, sample.time_s))
        return errors, estimator.refused(GYRO)


ALIGNED_AFTER_S: Final = 0.5


def root_mean_squares(errors: Sequence[Error]) -> dict[str, float]:
    """Of each figure; NaN as soon as one was not known."""
    names = ("heading_deg", "pitch_deg", "roll_deg", "altitude_ft", "vvi_ft_min", "speed_kt")
    return {name: rms([getattr(error, name) for error in errors]) for name in names}
