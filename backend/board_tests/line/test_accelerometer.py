"""What the accelerometer of a board without hardware feels: the path's acceleration and gravity, nothing else."""

import math
import time
from statistics import fmean

from board_tests.line.station import LEVEL_FLIGHT, Station
from tests.support.waiting import eventually

BANK_DEG = 30.0
GRAVITY_M_S2 = 9.80665
SPEED_M_S = 55 * 0.514444
TURN_DEG_S = math.degrees(GRAVITY_M_S2 * math.tan(math.radians(BANK_DEG)) / SPEED_M_S)
READINGS = 60


def forces(station: Station) -> list[tuple[float, ...]]:
    """Every specific force since the frames were last forgotten: forward, right, down."""
    return [frame.values[3:6] for frame in station.frames if frame.message.name == "inertial"]


def say(station: Station, *, yaw_deg: float, roll_deg: float) -> None:
    values = list(LEVEL_FLIGHT)
    values[7], values[8], values[9] = yaw_deg, 0.0, roll_deg
    station.command("xplane_info", *values)


def test_an_aircraft_that_appears_in_the_air_has_not_accelerated_there(binary: Station) -> None:
    binary.command("set_parameter_task_rate", 20)
    binary.command("inertial_on")
    binary.next("inertial")
    while len(forces(binary)) < READINGS:
        say(binary, yaw_deg=200.0, roll_deg=0.0)
        binary.pump(0.02)
    assert max(abs(force[0]) for force in forces(binary)) < 1
    assert max(abs(force[1]) for force in forces(binary)) < 1
    assert all(-11 < force[2] < -9 for force in forces(binary))


def test_a_clean_turn_is_felt_as_weight_and_not_to_the_side(binary: Station) -> None:
    binary.command("set_parameter_task_rate", 20)
    binary.command("inertial_on")
    began_s = time.monotonic()

    def turn(readings: int) -> None:
        binary.frames.clear()
        while len(forces(binary)) < readings:
            say(binary, yaw_deg=TURN_DEG_S * (time.monotonic() - began_s) % 360, roll_deg=BANK_DEG)
            binary.pump(0.02)

    turn(READINGS)
    weight_m_s2 = GRAVITY_M_S2 / math.cos(math.radians(BANK_DEG))

    def is_felt() -> bool:
        turn(2 * READINGS)
        to_the_side, down = (fmean(force[axis] for force in forces(binary)) for axis in (1, 2))
        return abs(to_the_side) < 1 and abs(down + weight_m_s2) < 0.8

    # 4.9 to the left if it did not turn. On a busy machine the turn comes to the board in steps: then the next one.
    eventually(is_felt, "a turn without a slip")
