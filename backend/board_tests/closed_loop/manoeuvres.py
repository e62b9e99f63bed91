"""What is flown to be measured: a whole route, and steps out of steady cruise."""

import math
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Final

from epf_gcs.codec.messages_gen import ROUTES
from epf_gcs.lab.closed_loop import ClosedLoop, Sample
from epf_gcs.lab.figures import RouteEnd
from epf_gcs.simulator.simulation import SimulationOptions
from epf_gcs.simulator.situation import AIRPORT_LATITUDE_DEG, AIRPORT_LONGITUDE_DEG, RUNWAY_HEADING_DEG

CRUISE_FT: Final = 1000.0
CRUISE_KT: Final = 55.0
STEP_FT: Final = 300.0
STEP_DEG: Final = 90.0
STEP_SHARE_OF_SPEED: Final = 0.15

STRAIGHT_ON, CLIMB, TURN, FASTER = range(4)

_HIL_PLAN: Final = 1
_SETTLE_S: Final = 60.0
_FAR_M: Final = 60_000.0
_METRES_PER_DEGREE: Final = 111_195.0


def fly_route(loop: ClosedLoop, name: str, longest_s: float) -> list[Sample]:
    """Load a route, switch the autopilot on and fly until its last waypoint is captured."""
    loop.command(f"hil_load_{name}")
    loop.command("autopilot_on")
    return loop.fly(longest_s, RouteEnd(ROUTES[name].waypoints).reached)


def _far_away(course_deg: float) -> tuple[float, float]:
    """A place so far on this course that the bearing to it hardly changes on the way."""
    north_m = _FAR_M * math.cos(math.radians(course_deg))
    east_m = _FAR_M * math.sin(math.radians(course_deg))
    shrink = math.cos(math.radians(AIRPORT_LATITUDE_DEG))
    return (
        AIRPORT_LATITUDE_DEG + north_m / _METRES_PER_DEGREE,
        AIRPORT_LONGITUDE_DEG + east_m / (_METRES_PER_DEGREE * shrink),
    )


_AHEAD: Final = _far_away(RUNWAY_HEADING_DEG)
_RIGHT: Final = _far_away(RUNWAY_HEADING_DEG + STEP_DEG)
_PLAN: Final = {
    STRAIGHT_ON: (*_AHEAD, CRUISE_FT, CRUISE_KT),
    CLIMB: (*_AHEAD, CRUISE_FT + STEP_FT, CRUISE_KT),
    TURN: (*_RIGHT, CRUISE_FT, CRUISE_KT),
    FASTER: (*_AHEAD, CRUISE_FT, CRUISE_KT * (1.0 + STEP_SHARE_OF_SPEED)),
}


@contextmanager
def cruise(*, measured: bool = False, repeats: int = 0) -> Iterator[ClosedLoop]:
    """The rc aircraft in steady flight straight on, with the other waypoints of the steps in its plan."""
    with ClosedLoop(SimulationOptions(), measured=measured, repeats=repeats) as loop:
        loop.command("mission_begin", _HIL_PLAN, len(_PLAN))
        for index, waypoint in _PLAN.items():
            loop.command("mission_item", _HIL_PLAN, index, *waypoint)
        loop.command("mission_commit", _HIL_PLAN)
        loop.command("autopilot_on")
        loop.fly(_SETTLE_S)
        yield loop


def step(loop: ClosedLoop, index: int, seconds: float) -> list[Sample]:
    """Go to another waypoint; returns the samples from then on."""
    loop.command("go_to_waypoint", _HIL_PLAN, index)
    return loop.fly(seconds)


def climb_error_ft(sample: Sample) -> float:
    """From the altitude of CLIMB."""
    return sample.state.altitude_ft - (CRUISE_FT + STEP_FT)


def turn_error_deg(sample: Sample) -> float:
    """Track less the bearing to the waypoint of TURN; negative while the turn to the right is not complete."""
    north = _RIGHT[0] - sample.state.latitude_deg
    east = (_RIGHT[1] - sample.state.longitude_deg) * math.cos(math.radians(AIRPORT_LATITUDE_DEG))
    bearing_deg = math.degrees(math.atan2(east, north))
    return (sample.state.track_deg - bearing_deg + 180.0) % 360.0 - 180.0


def speed_error_kt(sample: Sample) -> float:
    """From the airspeed of FASTER."""
    return sample.state.airspeed_indicated_kt - CRUISE_KT * (1.0 + STEP_SHARE_OF_SPEED)
