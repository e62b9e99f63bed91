"""Every fault, with three seeds: while it lasts the aircraft stays within bounds, and some seconds later it flies as
before. What no board can hold lasts so short here that the aircraft can be caught again.
"""

from __future__ import annotations

from typing import Final, NamedTuple

import pytest

from epf_gcs.contract.simulator_faults import KINDS
from epf_gcs.lab.bounds import Bounds
from epf_gcs.lab.plugin import Lab
from epf_gcs.lab.routes import FLIGHT_PLAN, HIL_PLAN, Route
from epf_gcs.lab.suites.places import CRUISE_FT, CRUISE_KT, waypoint
from epf_gcs.lab.watched import Watched, WatchedAircraft

_BEGIN_S: Final = 3.0
_LENGTH_S: Final = 8.0
_AFTER_S: Final = 11.0
_AHEAD: Final = Route("ahead", (waypoint(0.0, 60_000.0),))


class Holds(NamedTuple):
    """How far the aircraft may leave altitude, speed and level wings meanwhile. `text`: strength and length."""

    altitude_ft: float
    speed_kt: float
    roll_deg: float
    text: str = f"+{_LENGTH_S:g}"


_AS_EVER: Final = Holds(40.0, 6.0, 12.0)
_SHORT: Final = "+0.4"

# As they are flown with light turbulence, with room for gusts of other seeds.
_HOLDS: Final[dict[str, Holds]] = {
    "pitot.bias": Holds(40.0, 10.0, 12.0),
    "barometer.bias": Holds(90.0, 8.0, 12.0),
    "barometer.drift": Holds(50.0, 6.0, 12.0),
    "engine.out": Holds(140.0, 25.0, 12.0),
    "engine.weak": Holds(70.0, 20.0, 12.0),
    "elevator.reversed": Holds(150.0, 20.0, 25.0, _SHORT),
    "aileron.reversed": Holds(80.0, 12.0, 60.0, _SHORT),
    "attitude.stuck": Holds(40.0, 6.0, 25.0),
    "elevator.jammed": Holds(200.0, 20.0, 12.0),
    "aileron.jammed": Holds(60.0, 8.0, 30.0),
    "simulator.pause": Holds(40.0, 6.0, 12.0, "+20"),
    "simulator.silent": Holds(40.0, 6.0, 12.0, "+3"),
    "wind.gust": Holds(40.0, 14.0, 12.0),
    "line.cut": Holds(60.0, 8.0, 25.0, "+1"),
}
# Of the real aircraft's table: surfaces neutral and no throttle while rates or attitude are unknown.
_AIRCRAFT: Final[dict[str, Holds]] = {
    "gyro.dropout": Holds(150.0, 30.0, 45.0, "+2"),
    "attitude.dropout": Holds(150.0, 30.0, 45.0, "+2"),
    "pitot.dropout": _AS_EVER,
    "barometer.dropout": _AS_EVER,
    "gps.dropout": _AS_EVER,
    "receiver.dropout": _AS_EVER,
}
_OF_HIL: Final = [
    f"{place}.{kind}"
    for place, kinds in KINDS.items()
    for kind in kinds
    if f"{place}.{kind}" not in _AIRCRAFT and place != "board"
]


def _judge(loop: Watched | WatchedAircraft, plan: int, holds: Holds, bounds: Bounds) -> None:
    for name, values in _AHEAD.commands(plan):
        loop.command(name, *values)
    loop.command("autopilot_on")
    loop.go(_BEGIN_S)
    meanwhile = loop.go(_LENGTH_S + _AFTER_S)
    shown = loop.evidence()
    bounds.equal("fault that was there", len(shown), 1)
    bounds.equal("loss of the aircraft", loop.upset, None)
    bounds.below("from the altitude", abs(meanwhile.altitude_ft - CRUISE_FT).max(), holds.altitude_ft, "ft")
    bounds.below("from the speed", abs(meanwhile.airspeed_kt - CRUISE_KT).max(), holds.speed_kt, "kt")
    bounds.below("bank", abs(meanwhile.roll_deg).max(), holds.roll_deg, "deg")
    end = loop.go(2.0)
    bounds.below("bank in the end", abs(end.roll_deg).mean(), 8.0, "deg")


@pytest.mark.parametrize("fault", _OF_HIL)
def test_the_autopilot_holds_the_aircraft_through(lab: Lab, bounds: Bounds, fault: str, lab_seed: int) -> None:
    holds = _HOLDS.get(fault, _AS_EVER)
    length, _, strength = holds.text.partition("=")
    # A gust must ask for more than a slow servo gives.
    strength = "0.02" if fault.endswith(".slow") else strength
    asked = f"{fault}@{_BEGIN_S:g}{length}" + (f"={strength}" if strength else "")
    with lab.watch([asked], turbulence="light", seed=lab_seed) as loop:
        _judge(loop, HIL_PLAN, holds, bounds)


@pytest.mark.parametrize("fault", _AIRCRAFT)
def test_the_real_aircrafts_autopilot_goes_on_without(lab: Lab, bounds: Bounds, fault: str, lab_seed: int) -> None:
    holds = _AIRCRAFT[fault]
    with lab.watch_aircraft([f"{fault}@{_BEGIN_S:g}{holds.text}"], turbulence="light", seed=lab_seed) as loop:
        _judge(loop, FLIGHT_PLAN, holds, bounds)


def test_a_board_that_starts_anew_lets_the_aircraft_glide(lab: Lab, bounds: Bounds, lab_seed: int) -> None:
    with lab.watch([f"board.reset@{_BEGIN_S:g}"], turbulence="light", seed=lab_seed) as loop:
        for name, values in _AHEAD.commands():
            loop.command(name, *values)
        loop.command("autopilot_on")
        loop.go(_BEGIN_S + 3.0)
        glide = loop.go(4.0)
        loop.evidence()
        bounds.below("throttle", glide.throttle.max(), 1e-6)
        # Nothing but the dampers moves them.
        surfaces = (glide.elevator, glide.aileron, glide.rudder)
        bounds.below("largest surface", max(abs(one).max() for one in surfaces), 0.3)
