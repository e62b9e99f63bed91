"""Step responses of the autopilot on the rc aircraft at 55 kt, within a fifth of the reference figures.

The reference was measured once with the same laws and gains on the same aircraft: +300 ft with 12 ft of
overshoot, settled to 30 ft in 33 s; +90 degrees without overshoot, within 3 degrees in 17 s; airspeed
+15 % within 1 kt in 18 s.
"""

import math
from collections.abc import Iterator

import pytest

from simulator.simulation import SimulationOptions
from simulator.situation import AIRPORT_LATITUDE_DEG, AIRPORT_LONGITUDE_DEG, RUNWAY_HEADING_DEG
from tests.flight.closed_loop import ClosedLoop, Sample
from tests.flight.figures import settling_s

HIL_PLAN = 1
CRUISE_FT = 1000.0
CRUISE_KT = 55.0
SETTLED_S = 60.0
FAR_M = 60_000.0
METRES_PER_DEGREE = 111_195.0

STRAIGHT_ON, CLIMB, TURN, FASTER = range(4)


def far_away(course_deg: float) -> tuple[float, float]:
    """A place so far on this course that the bearing to it hardly changes on the way."""
    north_m = FAR_M * math.cos(math.radians(course_deg))
    east_m = FAR_M * math.sin(math.radians(course_deg))
    shrink = math.cos(math.radians(AIRPORT_LATITUDE_DEG))
    return (
        AIRPORT_LATITUDE_DEG + north_m / METRES_PER_DEGREE,
        AIRPORT_LONGITUDE_DEG + east_m / (METRES_PER_DEGREE * shrink),
    )


AHEAD = far_away(RUNWAY_HEADING_DEG)
RIGHT = far_away(RUNWAY_HEADING_DEG + 90.0)
PLAN = {
    STRAIGHT_ON: (*AHEAD, CRUISE_FT, CRUISE_KT),
    CLIMB: (*AHEAD, CRUISE_FT + 300.0, CRUISE_KT),
    TURN: (*RIGHT, CRUISE_FT, CRUISE_KT),
    FASTER: (*AHEAD, CRUISE_FT, CRUISE_KT * 1.15),
}


@pytest.fixture
def cruise() -> Iterator[ClosedLoop]:
    """In steady flight straight on."""
    with ClosedLoop(SimulationOptions()) as loop:
        loop.command("mission_begin", HIL_PLAN, len(PLAN))
        for index, waypoint in PLAN.items():
            loop.command("mission_item", HIL_PLAN, index, *waypoint)
        loop.command("mission_commit", HIL_PLAN)
        loop.command("autopilot_on")
        loop.fly(SETTLED_S)
        now = loop.samples[-1]
        assert now.waypoint == STRAIGHT_ON
        assert now.state.altitude_ft == pytest.approx(CRUISE_FT, abs=3.0)
        assert now.state.airspeed_indicated_kt == pytest.approx(CRUISE_KT, abs=0.2)
        yield loop


def step(loop: ClosedLoop, index: int, seconds: float) -> list[Sample]:
    loop.command("go_to_waypoint", HIL_PLAN, index)
    samples = loop.fly(seconds)
    assert samples[-1].waypoint == index
    return samples


def test_300_ft_up(cruise: ClosedLoop) -> None:
    def error_ft(sample: Sample) -> float:
        return sample.state.altitude_ft - (CRUISE_FT + 300.0)

    samples = step(cruise, CLIMB, 90.0)
    assert error_ft(samples[0]) == pytest.approx(-300.0, abs=5.0)
    assert settling_s(samples, error_ft, band=30.0) <= 33.0 * 1.2
    assert max(map(error_ft, samples)) <= 12.0 * 1.2
    assert abs(error_ft(samples[-1])) < 5.0


def test_90_degrees_to_the_right(cruise: ClosedLoop) -> None:
    def error_deg(sample: Sample) -> float:
        north = RIGHT[0] - sample.state.latitude_deg
        east = (RIGHT[1] - sample.state.longitude_deg) * math.cos(math.radians(AIRPORT_LATITUDE_DEG))
        bearing_deg = math.degrees(math.atan2(east, north))
        return (sample.state.track_deg - bearing_deg + 180.0) % 360.0 - 180.0

    samples = step(cruise, TURN, 60.0)
    assert error_deg(samples[0]) == pytest.approx(-90.0, abs=5.0)
    assert settling_s(samples, error_deg, band=3.0) <= 17.0 * 1.2
    assert max(map(error_deg, samples)) <= 0.0
    # The turn is flown with the full bank and no more, and costs no altitude to speak of.
    assert max(sample.state.roll_deg for sample in samples) == pytest.approx(30.0, abs=3.0)
    assert min(sample.state.altitude_ft for sample in samples) > CRUISE_FT - 60.0


def test_15_percent_faster(cruise: ClosedLoop) -> None:
    def error_kt(sample: Sample) -> float:
        return sample.state.airspeed_indicated_kt - CRUISE_KT * 1.15

    samples = step(cruise, FASTER, 60.0)
    assert settling_s(samples, error_kt, band=1.0) <= 18.0 * 1.2
    assert max(map(error_kt, samples)) < 1.0
    assert all(abs(sample.state.altitude_ft - CRUISE_FT) < 40.0 for sample in samples)
