"""A pause of the simulator and a new start in it: rows keep coming, but the aircraft in them hangs still, or jumps.

A frame of a pause brings the board command 50 once more while the simulator's time stands still.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Final

import pytest

from board_tests.closed_loop.manoeuvres import CLIMB, TURN, cruise, step
from epf_gcs.lab.closed_loop import ClosedLoop, Sample
from epf_gcs.simulator.simulation import Simulation, SimulationOptions
from epf_gcs.simulator.situation import AIRPORT_LATITUDE_DEG, Situation, Start
from epf_gcs.xplane.datagram import Record, build

ALTITUDE_WITHIN_FT: Final = 30.0
ATTITUDE_WITHIN_DEG: Final = 5.0
# Long enough to settle in a manoeuvre that was cut in two by the pause, and to fall out of the sky.
AFTER_S: Final = 40.0
STICK_ROW: Final = 8


def level(_: ClosedLoop) -> None:
    """Steady flight straight on."""


def turn(loop: ClosedLoop) -> None:
    """In the middle of a turn."""
    step(loop, TURN, 4.0)


def climb(loop: ClosedLoop) -> None:
    """In the middle of a climb."""
    step(loop, CLIMB, 8.0)


@cache
def flown(enter: Callable[[ClosedLoop], None], pause_s: float, *, stick_trembles: bool = False) -> list[Sample]:
    """The flight after a pause of this length (0: without one), flown once for all tests that compare with it."""
    with cruise() as loop:
        enter(loop)
        loop.pause(pause_s, stick_trembles=stick_trembles)
        after = loop.fly(AFTER_S)
        assert loop.crashes == []
        return after


def furthest(one: list[Sample], other: list[Sample]) -> tuple[float, float]:
    """Largest difference of altitude (ft) and of pitch or roll (deg) between two flights, moment by moment."""
    pairs = list(zip(one, other, strict=True))
    return (
        max(abs(a.state.altitude_ft - b.state.altitude_ft) for a, b in pairs),
        max(
            max(abs(a.state.pitch_deg - b.state.pitch_deg), abs(a.state.roll_deg - b.state.roll_deg)) for a, b in pairs
        ),
    )


@pytest.mark.parametrize("enter", [level, turn, climb])
def test_after_a_pause_of_any_length_the_flight_goes_on_as_if_there_had_been_none(
    enter: Callable[[ClosedLoop], None],
) -> None:
    for pause_s in (10.0, 60.0, 300.0):
        altitude_ft, attitude_deg = furthest(flown(enter, pause_s), flown(enter, 0.0))
        assert altitude_ft < ALTITUDE_WITHIN_FT, pause_s
        assert attitude_deg < ATTITUDE_WITHIN_DEG, pause_s


def test_a_joystick_that_trembles_in_the_pause_changes_nothing() -> None:
    altitude_ft, attitude_deg = furthest(flown(turn, 60.0, stick_trembles=True), flown(turn, 0.0))
    assert altitude_ft < ALTITUDE_WITHIN_FT
    assert attitude_deg < ATTITUDE_WITHIN_DEG


def test_in_assisted_flight_the_automatic_trim_waits_in_a_pause() -> None:
    """By hand the trim is all that is integrated; paused while the nose comes up, it ran to its stop."""

    def by_hand(pause_s: float) -> list[Sample]:
        with ClosedLoop(SimulationOptions()) as loop:
            loop.command("autotrim_on")
            loop.fly(15.0)
            loop.simulation.receive(build([Record(STICK_ROW, (0.1, 0.0, 0.0, *[-999.0] * 5))]))
            loop.fly(0.1)
            loop.pause(pause_s)
            return loop.fly(10.0)

    altitude_ft, attitude_deg = furthest(by_hand(60.0), by_hand(0.0))
    assert altitude_ft < ALTITUDE_WITHIN_FT
    assert attitude_deg < ATTITUDE_WITHIN_DEG


@pytest.mark.parametrize("enter", [level, turn, climb])
def test_a_simulator_that_sends_each_picture_twice_is_flown_the_same(enter: Callable[[ClosedLoop], None]) -> None:
    """The board measures the time of its steps here, as deployed: a repeat takes none, the next picture the whole."""

    def pictures(repeats: int) -> list[Sample]:
        with cruise(measured=True, repeats=repeats) as loop:
            enter(loop)
            return loop.fly(AFTER_S)

    altitude_ft, attitude_deg = furthest(pictures(1), pictures(0))
    assert altitude_ft < 0.1
    assert attitude_deg < 0.1


@pytest.mark.parametrize("start", [Start.AIR, Start.FINAL])
def test_after_a_new_start_elsewhere_it_flies_as_a_board_that_has_just_been_switched_on(start: Start) -> None:
    elsewhere = SimulationOptions(situation=Situation(start=start, latitude_deg=AIRPORT_LATITUDE_DEG + 0.3))

    def started(before_s: float) -> list[Sample]:
        with ClosedLoop(SimulationOptions()) as loop:
            loop.command("hil_load_gando")
            loop.command("autopilot_on")
            loop.fly(before_s)
            loop.simulation = Simulation(elsewhere, loop.crashes.append)
            return loop.fly(AFTER_S)

    assert furthest(started(12.0), started(0.0)) == (0.0, 0.0)
