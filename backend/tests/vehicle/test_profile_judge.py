"""Whose rows they are, told by how an aircraft turns; and when the data do not say."""

from __future__ import annotations

import json
import math
from collections.abc import Callable

import pytest

from epf_gcs.vehicle.profile_judge import ProfileJudge

NO = -999.0
FRAME_S = 0.02
Rates = tuple[float, float, float]
Attitude = tuple[float, float, float]


def row_16(profile: str, p_rad_s: float, q_rad_s: float, r_rad_s: float) -> tuple[float, ...]:
    """Body rates as that generation of X-Plane sends them."""
    if profile == "xp10":
        return (q_rad_s, p_rad_s, r_rad_s, NO, NO, NO, NO, NO)
    return (math.degrees(p_rad_s), math.degrees(q_rad_s), math.degrees(r_rad_s), NO, NO, NO, NO, NO)


def moved(attitude: Attitude, rates: Rates) -> Attitude:
    """Pitch, roll and heading [deg] one frame later, by the equations of a rigid body, in small steps."""
    pitch, roll, heading = map(math.radians, attitude)
    p, q, r = rates
    for _ in range(20):
        turn = (q * math.sin(roll) + r * math.cos(roll)) / math.cos(pitch)
        pitch += (q * math.cos(roll) - r * math.sin(roll)) * FRAME_S / 20
        roll += (p + turn * math.sin(pitch)) * FRAME_S / 20
        heading += turn * FRAME_S / 20
    if abs(pitch) > math.pi / 2:
        pitch, roll, heading = math.copysign(math.pi, pitch) - pitch, roll + math.pi, heading + math.pi
    roll = (roll + math.pi) % math.tau - math.pi
    return math.degrees(pitch), math.degrees(roll), math.degrees(heading) % 360.0


class Flown:
    """An aircraft whose rows are told frame by frame. `pace`: the simulator's time against the clock."""

    def __init__(self, sent: str, attitude: Attitude = (2.0, 0.0, 90.0), pace: float = 1.0) -> None:
        self.judge = ProfileJudge()
        self.sent, self.attitude, self.pace = sent, attitude, pace
        self.t_s = 1.7e9

    def fly(self, seconds: float, rates: Callable[[float], Rates] | Rates) -> str | None:
        """Turn so for some seconds of the simulator; returns the profile that the data say."""
        for frame in range(round(seconds / FRAME_S)):
            now = rates(frame * FRAME_S) if callable(rates) else rates
            self.attitude = moved(self.attitude, now)
            self.t_s += FRAME_S / self.pace
            self.tell(now)
        return self.judge.fits

    def tell(self, rates: Rates) -> None:
        self.judge.take(16, row_16(self.sent, *rates), self.t_s)
        self.judge.take(17, (*self.attitude, NO, NO, NO, NO, NO), self.t_s)


BOTH = pytest.mark.parametrize("sent", ["xp10", "xp12"])
OTHER = {"xp10": "xp12", "xp12": "xp10"}


@BOTH
@pytest.mark.parametrize("pace", [0.25, 0.5, 1.0, 2.0, 4.0])
@pytest.mark.parametrize(
    "rates",
    [
        pytest.param((0.1, 0.0, 0.0), id="rolls"),
        pytest.param((0.0, 0.1, 0.0), id="pitches"),
        pytest.param((0.0, 0.0, -0.1), id="yaws"),
        pytest.param((0.05, -0.04, 0.06), id="all three"),
    ],
)
def test_ten_degrees_of_any_turn_say_whose_rows_they_are_at_any_pace(sent: str, pace: float, rates: Rates) -> None:
    flown = Flown(sent, pace=pace)
    assert flown.fly(2.0, rates) == sent
    assert flown.judge.is_wrong(OTHER[sent])
    assert not flown.judge.is_wrong(sent)


@BOTH
def test_it_is_known_before_the_aircraft_has_rolled_by_ten_degrees(sent: str) -> None:
    flown = Flown(sent)
    while flown.judge.fits is None:
        flown.fly(FRAME_S, (0.5, 0.0, 0.0))
    assert flown.attitude[1] < 10.0


@BOTH
def test_parked_straight_flight_and_a_creeping_turn_say_nothing_and_are_no_alarm(sent: str) -> None:
    flown = Flown(sent)
    assert flown.fly(60.0, (0.0, 0.0, 0.0)) is None
    assert flown.fly(60.0, lambda t: (0.002 * math.sin(9.0 * t), 0.002 * math.cos(5.0 * t), 0.005)) is None
    assert flown.judge.look(flown.t_s, OTHER[sent]) is None


@BOTH
def test_a_heading_through_north_and_a_loop_through_the_vertical_are_turns_like_others(sent: str) -> None:
    flown = Flown(sent, attitude=(0.0, 0.0, 358.0))
    assert flown.fly(1.0, (0.0, 0.0, 0.15)) == sent
    loop = Flown(sent, attitude=(70.3, 0.0, 10.0))
    assert loop.fly(4.0, (0.0, 0.35, 0.0)) == sent
    assert not loop.judge.is_wrong(sent)


@BOTH
def test_a_pause_a_jump_and_values_that_are_none_are_no_evidence(sent: str) -> None:
    flown = Flown(sent)
    for roll_deg in range(-170, 170, 4):
        # Rows that say that nothing turns, while the attitude is another after each gap.
        flown.attitude = (0.0, float(roll_deg), 0.0)
        flown.t_s += 0.3
        flown.tell((0.0, 0.0, 0.0))
    for heading_deg in range(0, 3600, 40):
        flown.attitude = (0.0, 0.0, float(heading_deg % 360))
        flown.t_s += FRAME_S
        flown.tell((0.3, 0.3, 0.3))
    for bad in (math.nan, math.inf, NO, 1e9):
        flown.attitude = (bad, 1.0, 2.0)
        flown.t_s += FRAME_S
        flown.tell((0.3, 0.3, 0.3))
        flown.attitude = (0.0, 1.0, 2.0)
        flown.t_s += FRAME_S
        flown.tell((bad, 0.3, 0.3))
    for _ in range(500):
        # Paused in a turn: the rates go on, the attitude stands.
        flown.t_s += FRAME_S
        flown.tell((0.5, 0.5, 0.5))
    assert flown.judge.fits is None


@BOTH
def test_rows_that_come_in_bunches_after_stalls_of_the_line_are_judged_rightly(sent: str) -> None:
    flown = Flown(sent)
    clock_s = flown.t_s
    for frame in range(500):
        rates = (0.4 * math.sin(0.11 * frame), 0.2 * math.cos(0.07 * frame), 0.1)
        flown.attitude = moved(flown.attitude, rates)
        clock_s += FRAME_S
        if frame % 8 == 0:
            flown.t_s = clock_s
        flown.tell(rates)
        assert not flown.judge.is_wrong(sent)
    assert flown.judge.fits == sent


def test_what_was_found_stands_in_straight_flight_and_changes_only_by_as_much_evidence_against_it() -> None:
    flown = Flown("xp12")
    assert flown.fly(2.0, (0.1, 0.0, 0.0)) == "xp12"
    assert flown.fly(300.0, (0.0, 0.0, 0.0)) == "xp12"
    flown.sent = "xp10"
    assert flown.fly(0.6, (0.1, 0.0, 0.0)) == "xp12"
    assert flown.fly(2.0, (0.1, 0.0, 0.0)) == "xp10"


def test_a_simulator_that_was_silent_for_long_may_be_another_one_now() -> None:
    flown = Flown("xp12")
    flown.fly(2.0, (0.1, 0.0, 0.0))
    finding = flown.judge.look(flown.t_s, "xp10")
    assert finding is not None
    assert (finding.id, finding.level) == ("profile_wrong", "critical")
    assert finding.params == {"profile": "X-Plane 10 / 11", "fits": "X-Plane 12"}
    assert "Choose the profile X-Plane 12" in finding.text
    assert flown.judge.look(flown.t_s, "xp12") is None
    assert flown.judge.look(flown.t_s + 11.0, "xp10") is None
    flown.t_s += 11.0
    assert flown.fly(FRAME_S, (0.0, 0.0, 0.0)) is None


def test_a_judge_goes_on_from_what_was_kept_at_any_moment() -> None:
    first = Flown("xp12")
    for frame in range(60):
        again = ProfileJudge()
        again.restore(json.loads(json.dumps(first.judge.kept())))
        assert json.dumps(again.kept()) == json.dumps(first.judge.kept())
        first.judge = again
        first.fly(FRAME_S, (0.1 + 0.001 * frame, 0.05, 0.0))
    assert first.judge.fits == "xp12"
