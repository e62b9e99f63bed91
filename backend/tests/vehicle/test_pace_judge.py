"""How fast a simulator's time runs, told by the way over ground."""

from __future__ import annotations

import json
import math
import struct

import pytest

from epf_gcs.vehicle.pace_judge import PaceJudge

NO = -999.0
FRAME_S = 0.02
M_PER_DEG = 111_195.0


def as_sent(value: float) -> float:
    """With the digits that a 32-bit number keeps."""
    return float(struct.unpack("<f", struct.pack("<f", value))[0])


class Flown:
    """An aircraft that flies east. `pace`: the simulator's time against the clock, None while it is paused."""

    def __init__(self, longitude_deg: float = -15.4) -> None:
        self.judge = PaceJudge()
        self.t_s = 1.7e9
        self.longitude_deg = longitude_deg

    def fly(self, seconds: float, pace: float, speed_kt: float = 55.0, said_kt: float | None = None) -> float | None:
        """Fly so for some seconds of the clock; returns the pace that is told at the end, None if it is normal."""
        for _ in range(round(seconds / FRAME_S)):
            self.t_s += FRAME_S
            way_m = pace * FRAME_S * speed_kt * 1852.0 / 3600.0
            self.longitude_deg += way_m / M_PER_DEG / math.cos(math.radians(28.0))
            self.tell(speed_kt if said_kt is None else said_kt)
        return self.told()

    def tell(self, speed_kt: float) -> None:
        self.judge.take(3, (speed_kt, NO, NO, as_sent(speed_kt), NO, NO, NO, NO), self.t_s)
        longitude_deg = as_sent((self.longitude_deg + 180.0) % 360.0 - 180.0)
        self.judge.take(20, (28.0, longitude_deg, 1000.0, 1000.0, NO, 1000.0, NO, NO), self.t_s)

    def told(self) -> float | None:
        finding = self.judge.look(self.t_s)
        return None if finding is None else float(str(finding.params["pace"]))


@pytest.mark.parametrize("longitude_deg", [-15.4, -117.0, 179.99])
@pytest.mark.parametrize("speed_kt", [15.0, 55.0, 450.0])
@pytest.mark.parametrize("pace", [0.5, 2.0, 4.0, 16.0])
def test_another_pace_is_told_within_five_seconds_and_its_end_too(
    pace: float, speed_kt: float, longitude_deg: float
) -> None:
    flown = Flown(longitude_deg)
    assert flown.fly(5.0, 1.0, speed_kt) is None
    assert flown.fly(7.0, pace, speed_kt) == pytest.approx(pace, rel=0.2)
    assert flown.fly(7.0, 1.0, speed_kt) is None


@pytest.mark.parametrize(("pace", "said"), [(0.5, 0.5), (2.0, 2.0), (4.0, 4.0)])
def test_at_the_speed_of_our_aircraft_five_seconds_are_enough(pace: float, said: float) -> None:
    flown = Flown()
    flown.fly(5.0, 1.0)
    assert flown.fly(5.0, pace) == said
    assert flown.fly(5.0, 1.0) is None


def test_what_is_not_another_pace() -> None:
    flown = Flown()
    assert flown.fly(30.0, 1.0, 0.0) is None, "parked"
    assert flown.fly(30.0, 0.9) is None, "a little slow"
    assert flown.fly(30.0, 0.0) is None, "paused"
    for _ in range(20):
        flown.longitude_deg += 0.02
        assert flown.fly(0.5, 1.0) is None, "put elsewhere"
    assert flown.fly(30.0, 2.0, said_kt=NO) is None, "no ground speed is sent"
    assert flown.fly(30.0, 2.0, said_kt=math.nan) is None


def test_a_stall_of_the_line_is_no_other_pace() -> None:
    flown = Flown()
    clock_s = flown.t_s
    for frame in range(3000):
        clock_s += FRAME_S
        if frame % 20 == 0:
            flown.t_s = clock_s
        flown.longitude_deg += FRAME_S * 28.3 / M_PER_DEG / math.cos(math.radians(28.0))
        flown.tell(55.0)
        assert flown.told() is None


def test_a_pace_that_cannot_be_seen_any_more_is_not_told_for_ever() -> None:
    flown = Flown()
    assert flown.fly(6.0, 2.0) == 2.0
    assert flown.fly(5.0, 2.0, 0.0) == 2.0
    assert flown.fly(10.0, 2.0, 0.0) is None
    assert flown.fly(1.5, 2.0) is None, "one second says too little again"


def test_a_judge_goes_on_from_what_was_kept_at_any_moment() -> None:
    flown = Flown()
    for _ in range(250):
        again = PaceJudge()
        again.restore(json.loads(json.dumps(flown.judge.kept())))
        assert json.dumps(again.kept()) == json.dumps(flown.judge.kept())
        flown.judge = again
        flown.fly(FRAME_S, 2.0)
    assert flown.told() == 2.0
    finding = flown.judge.look(flown.t_s)
    assert finding is not None
    assert (finding.id, finding.level) == ("simulator_pace", "warning")
    assert "x2 " in finding.text
