"""What the board does when something it flies by fails, as a station sees it. Case by case: tests/flight in C."""

import math

from board_tests.line.station import LEVEL_FLIGHT, Station


def test_a_transmitter_that_is_off_is_told_and_heard_again(text: Station) -> None:
    assert text.table("status")["failsafe"] == "-"
    assert text.line("rc power off") == "ok"
    text.wait(lambda: text.table("status")["failsafe"] == "receiver silent")
    assert text.line("rc power on") == "ok"
    text.wait(lambda: text.table("status")["failsafe"] == "-")


def test_the_autopilot_stays_on_without_the_transmitter(text: Station) -> None:
    text.line("rc auto on")
    text.wait(lambda: text.table("status")["autopilot"] == "on")
    text.line("rc power off")
    text.wait(lambda: text.table("status")["failsafe"] == "receiver silent")
    assert text.table("status")["autopilot"] == "on"


def test_channels_of_a_silent_receiver_are_sent_as_no_data(text: Station) -> None:
    text.line("rc power off")
    text.open_binary()
    text.command("servos_in_on")
    text.wait(lambda: all(map(math.isnan, text.next("servos_in").values)))


def test_servos_that_follow_a_simulator_are_centred_when_it_stops(binary: Station) -> None:
    binary.command("control_source", 1)
    binary.command("servos_control_mode_hil")
    binary.command("xplane_info", 0.3, -0.2, 0.1, 0.7, *LEVEL_FLIGHT[4:])
    elevator, aileron, rudder, throttle = binary.next("hil_surfaces").values
    assert min(abs(elevator), abs(aileron), abs(rudder), throttle) > 0.05
    binary.command("exit_binary_mode")
    binary.wait(lambda: binary.table("status")["failsafe"] == "simulator silent")
    assert binary.lines("servos")[1].split()[:8] == ["0:", "0", "1:", "0", "2:", "0", "3:", "0"]
