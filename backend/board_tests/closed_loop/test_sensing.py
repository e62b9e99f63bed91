"""What the board says of its attitude over the Gando circuit, through the sensors it models itself.

The board's own code from command 50 to the readings that it sends: models of the sensors with their errors, then the
estimator, at the sensor task's pace.
"""

from __future__ import annotations

import ctypes
import math
from dataclasses import dataclass
from typing import Final

import pytest

from board_tests.closed_loop.circuit import Circuit
from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.lab.figures import rms
from epf_gcs.lab.laws import library as laws_library
from epf_gcs.xplane.datagram import parse
from epf_gcs.xplane.gather import Gatherer

FRAME_S: Final = 0.02
STEPS_A_FRAME: Final = 2
SETTLED_S: Final = 10.0
RECOVERED_AFTER_S: Final = 5.0
AHRS, PITCH, ROLL = 0, 1, 2
READINGS: Final = 3 + 9 + 10

Info = tuple[float, ...]


@dataclass(frozen=True, slots=True)
class Errors:
    """What the board says less what the simulator told it, for every frame."""

    times_s: list[float]
    heading_deg: list[float]
    pitch_deg: list[float]
    roll_deg: list[float]

    def worst_deg(self, begin_s: float, end_s: float) -> float:
        """The largest error of any angle in this time."""
        return max(
            abs(error)
            for angle in (self.heading_deg, self.pitch_deg, self.roll_deg)
            for time_s, error in zip(self.times_s, angle, strict=True)
            if begin_s <= time_s < end_s
        )


@pytest.fixture(scope="module")
def told(circuit: Circuit) -> list[Info]:
    """Every command 50 of the flight."""
    gatherer = Gatherer("xp10")
    taken = (gatherer.take(parse(data) or [], 0.0) for data in circuit.bytes_to_station)
    return [tuple(info) for info in taken if info is not None]


def sense(told: list[Info], seed: int, gap_s: tuple[float, float] = (math.inf, math.inf)) -> Errors:
    """Fly the circuit past a board just switched on; its gyro is silent in the gap."""
    library = ctypes.CDLL(str(laws_library()))
    library.epf_sensing_observe.argtypes = (ctypes.c_char_p, ctypes.c_float)
    library.epf_sensing_step.argtypes = (ctypes.c_float, ctypes.c_uint32, ctypes.c_void_p)
    library.epf_sensing_start(seed)
    readings = (ctypes.c_float * READINGS)()
    pack = COMMANDS["xplane_info"].struct.pack
    errors = Errors([], [], [], [])
    for number, info in enumerate(told):
        time_s = number * FRAME_S
        library.epf_sensing_observe(pack(*info), 0.5)
        for _ in range(STEPS_A_FRAME):
            library.epf_sensing_step(FRAME_S / STEPS_A_FRAME, gap_s[0] <= time_s < gap_s[1], readings)
        if time_s >= SETTLED_S:
            yaw_deg, pitch_deg, roll_deg = readings[AHRS], readings[PITCH], readings[ROLL]
            errors.times_s.append(time_s)
            errors.heading_deg.append((yaw_deg - info[7] + 180.0) % 360.0 - 180.0)
            errors.pitch_deg.append(pitch_deg - info[8])
            errors.roll_deg.append((roll_deg - info[9] + 180.0) % 360.0 - 180.0)
    return errors


@pytest.mark.parametrize("seed", [1, 2])
def test_the_board_knows_its_attitude_over_the_whole_circuit(told: list[Info], seed: int) -> None:
    errors = sense(told, seed)
    assert len(errors.times_s) > 25_000
    assert rms(errors.pitch_deg) < 2.0
    assert rms(errors.roll_deg) < 2.0
    assert rms(errors.heading_deg) < 4.0


def test_what_the_board_says_is_its_own_estimate_and_not_what_the_simulator_told(told: list[Info]) -> None:
    once, other = sense(told[:3000], 1), sense(told[:3000], 2)
    assert min(map(abs, once.pitch_deg)) < 0.05 < max(map(abs, once.pitch_deg))
    assert all(a != b for a, b in zip(once.roll_deg, other.roll_deg, strict=True))


@pytest.mark.parametrize(
    "gap_s", [pytest.param((200.0, 210.0), id="in straight flight"), pytest.param((60.0, 70.0), id="while turning")]
)
def test_ten_seconds_without_the_gyro_are_recovered_from(told: list[Info], gap_s: tuple[float, float]) -> None:
    errors = sense(told, 1, gap_s)
    begin_s, end_s = gap_s
    assert errors.worst_deg(begin_s, end_s) < 15.0
    recovered_s = end_s + RECOVERED_AFTER_S
    assert errors.worst_deg(recovered_s, recovered_s + 60.0) < 6.0
