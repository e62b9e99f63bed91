"""Hardware in the loop: command 50 in, surfaces out."""

import math
from collections.abc import Callable

from board_tests.line.station import LEVEL_FLIGHT, Station

FIELDS = ("elevator", "aileron", "rudder", "throttle", "gx", "gy", "gz", "yaw", "pitch", "roll", "altitude", "vvi",
          "speed", "latitude", "longitude")  # fmt: skip


def flight(**changes: float) -> tuple[float, ...]:
    """Level flight with some values changed."""
    return tuple((dict(zip(FIELDS, LEVEL_FLIGHT, strict=True)) | changes).values())


LET_GO = (0.0, 0.0, 0.0, 0.0)
"""What a board sends by itself where a busy computer is late with the next frame."""


def surfaces(station: Station, values: tuple[float, ...]) -> tuple[float, ...]:
    """The answer: elevator, aileron, rudder, throttle."""
    station.command("xplane_info", *values)
    station.frames.clear()

    def answer() -> tuple[float, ...] | None:
        told = (frame.values for frame in station.frames if frame.message.name == "hil_surfaces")
        return next((values for values in told if values != LET_GO), None)

    return station.wait(answer)


def test_each_frame_is_answered_by_one(binary: Station) -> None:
    for _ in range(20):
        binary.frames.clear()
        for _ in range(10):
            binary.command("xplane_info", *LEVEL_FLIGHT)
        binary.wait(lambda: binary.count("hil_surfaces") >= 10)
    binary.command("load_autopilot_parameters")
    binary.wait(lambda: binary.newest("autopilot_parameters"))
    assert binary.count("hil_surfaces") == 10


def test_the_joystick_flies_by_wire_when_it_is_the_source(binary: Station) -> None:
    binary.command("control_source", 1)
    elevator, aileron, rudder, throttle = surfaces(binary, flight(elevator=0.2, aileron=-0.1, rudder=0.3, throttle=0.7))
    assert math.isclose(elevator, 0.4, abs_tol=1e-5)  # twofold stick, gain 1
    assert math.isclose(aileron, -0.18, abs_tol=1e-5)  # threefold stick, gain 0.6
    assert math.isclose(rudder, 0.3, abs_tol=1e-5)
    assert math.isclose(throttle, 0.7, abs_tol=1e-5)


def test_with_the_transmitter_as_source_its_sticks_fly(binary: Station) -> None:
    # The modelled transmitter follows the simulator's stick, as a pilot with both in hand would.
    def rudder() -> bool:
        return math.isclose(surfaces(binary, flight(rudder=0.5))[2], 0.5, abs_tol=0.01)

    binary.wait(rudder)


def test_damping_works_against_the_rates(binary: Station) -> None:
    binary.command("control_source", 1)
    elevator, aileron, rudder, _ = surfaces(binary, flight(gx=0.5, gy=0.5, gz=0.5))
    assert elevator < 0
    assert aileron < 0
    assert rudder < 0


def test_the_autopilot_turns_to_the_waypoint(binary: Station) -> None:
    binary.command("control_source", 1)
    binary.command("hil_load_gando")
    binary.command("autopilot_on")
    # The first waypoint lies to the north; from a heading of west the short way is to the right.
    towards = [surfaces(binary, flight(yaw=270.0, latitude=27.90, longitude=-15.3741)) for _ in range(100)][-1]
    assert towards[1] > 0.1
    assert binary.heartbeat()["autopilot_hil"] == 3


def test_values_that_are_no_numbers_never_reach_the_surfaces(binary: Station) -> None:
    binary.command("control_source", 1)
    good = surfaces(binary, flight(elevator=0.1))
    for index in range(len(FIELDS)):
        for wrong in (math.nan, math.inf, -math.inf):
            values = list(flight(elevator=0.1))
            values[index] = wrong
            payload = binary.command_struct("xplane_info").pack(*values)
            binary.frames.clear()
            binary.send(binary.raw_command("xplane_info", payload))
            assert binary.next("hil_surfaces").values in (good, LET_GO)
    assert surfaces(binary, flight(elevator=0.1))[0] == good[0]


def test_a_stick_beyond_its_stop_gives_limited_surfaces(binary: Station) -> None:
    binary.command("control_source", 1)
    payload = binary.command_struct("xplane_info").pack(*flight(elevator=9.0, aileron=-9.0, rudder=9.0, throttle=9.0))
    binary.send(binary.raw_command("xplane_info", payload))
    assert binary.next("hil_surfaces").values == (1.0, -1.0, 1.0, 1.0)


def test_a_fixed_period_makes_the_loop_repeatable(plug: Callable[..., Station]) -> None:
    flights = []
    for _ in range(2):
        station = plug("--hil-period-ms", "20")
        station.open_binary()
        for command in ("hil_load_gando", "autopilot_on"):
            station.command("control_source", 1)
            station.command(command)
        flown = [surfaces(station, flight(altitude=900.0 + step, yaw=step * 2.0)) for step in range(100)]
        flights.append(flown)
    assert flights[0] == flights[1]
    assert len(set(flights[0])) > 50


def test_one_step_of_the_period_moves_the_throttle_by_the_law(plug: Callable[..., Station]) -> None:
    station = plug("--hil-period-ms", "1000")
    station.open_binary()
    station.command("control_source", 1)
    station.command("hil_load_gando")
    surfaces(station, flight())
    station.command("autopilot_on")
    throttles = [surfaces(station, flight(speed=48.0, roll=0.01 * (step % 2)))[3] for step in range(20)]
    # 7 kt too slow, 700 kt s for full throttle: a hundredth each second, once the change-over has faded.
    assert math.isclose(throttles[-1] - throttles[-2], 0.01, abs_tol=1e-4)


def test_the_servos_follow_the_surfaces_in_hil_mode(binary: Station) -> None:
    binary.command("control_source", 1)
    binary.command("servos_control_mode_hil")
    surfaces(binary, flight(elevator=0.25, rudder=-0.5))
    binary.command("exit_binary_mode")
    outputs = binary.lines("servos")[1]
    assert "1: 0.5 " in outputs
    assert "3: -0.5" in outputs
