"""Whether a simulator is paused, and whether it threw the aircraft elsewhere, judged from its rows."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from typing import Final, cast

import msgspec
import pytest

from epf_gcs.vehicle.simulator_motion import MOTION_ROWS, Jump, MotionState, SimulatorMotion
from epf_gcs.xplane.datagram import Eight
from tests.support.simulator import NO, ROWS

START_S: Final = 1.7e9
FRAME_S: Final = 0.02


class Flown:
    """A simulator whose rows come 50 times a second."""

    def __init__(self) -> None:
        self.jumps: list[Jump] = []
        self.motion = SimulatorMotion(self.jumps.append)
        self.rows = {row: cast(Eight, ROWS[row]) for row in MOTION_ROWS}
        self.now_s = START_S

    def change(self, row: int, place: int, value: float) -> None:
        """One value of a row changes."""
        values = list(self.rows[row])
        values[place] = value
        self.rows[row] = cast(Eight, tuple(values))

    def send(self, seconds: float = 0.0, *, without: int = -1) -> None:
        """The rows come as they are for so long; once at least."""
        for _ in range(max(1, round(seconds / FRAME_S))):
            self.now_s += FRAME_S
            for row in sorted(self.rows.keys() - {without}):
                self.motion.take(row, self.rows[row], self.now_s, "xp10")

    def fly(self, seconds: float) -> None:
        """The rows come, and the aircraft moves."""
        for _ in range(round(seconds / FRAME_S)):
            self.change(20, 0, self.rows[20][0] + 1e-5)
            self.send()

    def is_paused(self) -> bool:
        return self.motion.is_paused(self.now_s)


def test_an_aircraft_that_hangs_still_for_longer_than_three_tenths_of_a_second_is_paused() -> None:
    flown = Flown()
    flown.fly(1.0)
    assert not flown.is_paused()
    flown.send(0.28)
    assert not flown.is_paused()
    flown.send(0.04)
    assert flown.is_paused()
    flown.send(300.0)
    assert flown.is_paused()


def test_a_simulator_that_was_paused_before_it_was_heard_is_paused_too() -> None:
    flown = Flown()
    flown.send(0.4)
    assert flown.is_paused()


@pytest.mark.parametrize("row", sorted(MOTION_ROWS))
def test_one_bit_that_changes_in_any_of_the_rows_is_no_pause(row: int) -> None:
    flown = Flown()
    flown.send(1.0)
    assert flown.is_paused()
    flown.change(row, 0, math.nextafter(flown.rows[row][0], 1000.0) + 1e-5)
    flown.send()
    assert not flown.is_paused()


def test_without_one_of_the_rows_nobody_knows() -> None:
    for row in MOTION_ROWS:
        flown = Flown()
        flown.send(2.0, without=row)
        assert not flown.is_paused()


@pytest.mark.parametrize("speed_kt", [0.0, 19.9, NO, math.nan, 1e9])
def test_an_aircraft_that_does_not_fly_is_not_paused(speed_kt: float) -> None:
    flown = Flown()
    flown.change(3, 0, speed_kt)
    flown.send(2.0)
    assert not flown.is_paused()


def test_a_value_that_is_no_number_is_equal_to_itself() -> None:
    flown = Flown()
    flown.change(4, 5, math.nan)
    for _ in range(40):
        flown.rows = {row: cast(Eight, tuple(float(value) for value in values)) for row, values in flown.rows.items()}
        flown.change(4, 5, float("nan"))
        flown.send()
    assert flown.is_paused()


def test_a_paused_simulator_that_falls_silent_is_lost_and_no_longer_paused() -> None:
    flown = Flown()
    flown.send(2.0)
    assert flown.motion.is_paused(flown.now_s + 0.9)
    assert not flown.motion.is_paused(flown.now_s + 1.1)


def test_a_slow_simulator_is_not_called_paused_between_its_frames() -> None:
    flown = Flown()
    for _ in range(20):
        flown.now_s += 0.5
        flown.change(20, 0, flown.rows[20][0] + 1e-4)
        flown.send()
        assert not flown.motion.is_paused(flown.now_s + 0.49)


@pytest.mark.parametrize(
    ("values", "after_s", "distance_m"),
    [
        pytest.param({0: 27.9319 + 0.0008}, 0.0, None, id="90 m"),
        pytest.param({0: 27.9319 + 0.001}, 0.0, 111, id="110 m to the north"),
        pytest.param({1: -15.3866 + 0.3}, 0.0, 29_472, id="29 km to the east"),
        pytest.param({5: 1235.75 + 300.0}, 0.0, None, id="300 ft up"),
        pytest.param({5: 1235.75 + 919.0}, 0.0, 280, id="919 ft up, from a crash to its start"),
        pytest.param({0: 27.9319 + 0.01}, 20.0, None, id="1.1 km in a silence of 20 s"),
        pytest.param({0: 27.9319 + 0.1}, 20.0, 11_120, id="11 km in a silence of 20 s"),
        pytest.param({0: math.nan}, 0.0, None, id="no number"),
        pytest.param({1: NO}, 0.0, None, id="no value"),
    ],
)
def test_an_aircraft_that_cannot_have_flown_there_was_put_there(
    values: Mapping[int, float], after_s: float, distance_m: int | None
) -> None:
    flown = Flown()
    flown.send(0.1)
    flown.now_s += after_s
    for place, value in values.items():
        flown.change(20, place, value)
    flown.send(0.5)
    assert [round(jump.distance_m) for jump in flown.jumps] == ([] if distance_m is None else [distance_m])


def test_a_place_set_in_a_pause_is_a_jump_of_one_frame() -> None:
    flown = Flown()
    flown.fly(1.0)
    flown.send(60.0)
    flown.change(20, 0, flown.rows[20][0] + 0.02)
    flown.send()
    (jump,) = flown.jumps
    assert (jump.t_s, jump.to.latitude_deg) == (flown.now_s, flown.rows[20][0])


def test_a_simulator_that_throws_the_aircraft_about_is_told_of_once_a_second() -> None:
    flown = Flown()
    for index in range(500):
        flown.change(20, 0, float(index % 2))
        flown.send()
    assert len(flown.jumps) == 10


def test_what_is_kept_goes_on_as_it_was() -> None:
    flown, again = Flown(), Flown()
    flown.fly(1.0)
    flown.send(0.2)
    kept = json.dumps(msgspec.to_builtins(flown.motion.kept()))
    again.motion.restore(msgspec.convert(json.loads(kept), MotionState, str_keys=True))
    again.rows, again.now_s = dict(flown.rows), flown.now_s
    for one in (flown, again):
        one.send(0.2)
        assert one.is_paused()
        one.change(20, 1, 0.0)
        one.send()
    assert again.jumps == flown.jumps
    assert again.motion.kept() == flown.motion.kept()


def test_of_another_simulator_nothing_is_known() -> None:
    flown = Flown()
    flown.send(1.0)
    flown.motion.forget()
    assert not flown.is_paused()
    flown.change(20, 0, 0.0)
    flown.send()
    assert flown.jumps == []
