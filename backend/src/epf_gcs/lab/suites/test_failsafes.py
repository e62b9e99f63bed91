"""The failsafe table, each cause with the autopilot on and with the pilot at the stick: what is done, and when."""

from __future__ import annotations

import math
from typing import Final

import numpy as np
import pytest

from epf_gcs.lab.bounds import Bounds
from epf_gcs.lab.plugin import Lab
from epf_gcs.lab.suites.places import CRUISE_FT, CRUISE_KT
from epf_gcs.lab.watched import Watch

_BEGIN_S: Final = 4.0
# A frame or two may pass until an action shows in the surfaces.
_FRAMES_S: Final = 0.05
_LEVEL_FT: Final = 60.0


def _flown(lab: Lab, faults: list[str], seconds: float, *, autopilot: bool) -> Watch:
    """From the start of the faults on."""
    with lab.watch_aircraft([f"{fault}@{_BEGIN_S:g}" for fault in faults]) as loop:
        if autopilot:
            loop.command("autopilot_on")
        else:
            loop.channels[:4] = [0.1, 0.03, 0.6, 0.2]
        loop.go(_BEGIN_S)
        flown = loop.go(seconds)
        loop.evidence()
        return flown


def _surfaces(flown: Watch) -> np.ndarray:
    return np.array([flown.elevator, flown.aileron, flown.rudder, flown.throttle])


def _neutral_from_s(flown: Watch) -> float:
    """How long after the fault all surfaces are neutral without throttle, for good; infinite: they are not."""
    is_neutral = np.abs(_surfaces(flown)).max(axis=0) < 1e-6
    if not is_neutral[-1]:
        return math.inf
    others = np.flatnonzero(~is_neutral)
    return float(flown.time_s[others[-1]] - _BEGIN_S) if len(others) else 0.0


def test_simulator_silent_the_autopilot_keeps_its_surfaces_and_goes_on(lab: Lab, bounds: Bounds) -> None:
    with lab.watch() as loop:
        loop.command("servos_control_mode_hil")
        loop.command("autopilot_on")
        loop.go(5.0)
        before = loop.servos()
        loop.silence(5.0)
        bounds.equal("servos after 5 s of silence", loop.servos(), before)
        after = loop.go(6.0)
        bounds.below("change of altitude after it", abs(after.altitude_ft - CRUISE_FT).max(), 40.0, "ft")


def test_simulator_silent_the_pilots_surfaces_go_neutral_after_500_ms(lab: Lab, bounds: Bounds) -> None:
    with lab.watch() as loop:
        loop.command("servos_control_mode_hil")
        loop.stick = (0.05, 0.1, 0.2)
        loop.go(3.0)
        before = loop.servos()
        loop.silence(0.44)
        bounds.equal("servos after 440 ms", loop.servos(), before)
        loop.silence(0.1)
        bounds.equal("servos after 540 ms", loop.servos(), [0.0] * 4)


def test_a_paused_simulator_that_repeats_its_frame_winds_nothing_up(lab: Lab, bounds: Bounds) -> None:
    with lab.watch() as loop:
        loop.command("autopilot_on")
        loop.go(2.0)
        loop.stick = (0.0, 0.0, 0.0)
        before = loop.go(0.5)
        loop.repeat(30.0)
        after = loop.go(6.0)
        bounds.below("move at the end of the pause", abs(after.elevator[2] - before.elevator[-1]), 0.02)
        bounds.below("change of altitude after it", abs(after.altitude_ft - CRUISE_FT).max(), 30.0, "ft")


def test_receiver_silent_the_autopilot_flies_on(lab: Lab, bounds: Bounds) -> None:
    flown = _flown(lab, ["receiver.dropout"], 12.0, autopilot=True)
    bounds.below("change of altitude", abs(flown.altitude_ft - CRUISE_FT).max(), _LEVEL_FT, "ft")
    bounds.below("change of airspeed", abs(flown.airspeed_kt - CRUISE_KT).max(), 5.0, "kt")


def test_receiver_silent_the_stick_counts_as_neutral_after_500_ms(lab: Lab, bounds: Bounds) -> None:
    flown = _flown(lab, ["receiver.dropout"], 3.0, autopilot=False)
    since_s = flown.time_s - _BEGIN_S
    bounds.above("throttle just before 500 ms", flown.throttle[since_s < 0.5 - _FRAMES_S][-1], 0.5)
    bounds.below("throttle after 500 ms", flown.throttle[since_s > 0.5 + _FRAMES_S].max(), 1e-6)
    bounds.below("aileron against the roll", abs(flown.aileron[since_s > 0.5 + _FRAMES_S]).max(), 0.1)


@pytest.mark.parametrize("cause", ["gyro", "attitude"])
def test_rates_or_attitude_unknown_the_autopilot_goes_neutral_after_200_ms(
    lab: Lab, bounds: Bounds, cause: str
) -> None:
    flown = _flown(lab, [f"{cause}.dropout"], 2.0, autopilot=True)
    from_s = _neutral_from_s(flown)
    bounds.above("neutral from", from_s, 0.2 - _FRAMES_S, "s")
    bounds.below("neutral from", from_s, 0.2 + _FRAMES_S, "s")


def test_rates_unknown_the_pilots_stick_moves_the_surfaces_directly(lab: Lab, bounds: Bounds) -> None:
    flown = _flown(lab, ["gyro.dropout"], 2.0, autopilot=False)
    late = flown.time_s - _BEGIN_S > 0.2 + _FRAMES_S
    for name, stick in (("aileron", 0.1), ("elevator", 0.03), ("throttle", 0.6), ("rudder", 0.2)):
        bounds.below(f"difference of {name} from the stick", abs(getattr(flown, name)[late] - stick).max(), 1e-6)


def test_attitude_unknown_the_pilot_flies_on(lab: Lab, bounds: Bounds) -> None:
    known, unknown = (_flown(lab, [f"{place}.dropout"], 2.0, autopilot=False) for place in ("pitot", "attitude"))
    bounds.below("difference of the aileron", abs(known.aileron - unknown.aileron).max(), 0.05)
    bounds.below("change of throttle", abs(unknown.throttle - 0.6).max(), 0.02)


def test_altitude_unknown_the_autopilot_flies_level_at_once(lab: Lab, bounds: Bounds) -> None:
    flown = _flown(lab, ["barometer.dropout", "gps.dropout"], 15.0, autopilot=True)
    bounds.below("change of altitude", abs(flown.altitude_ft - CRUISE_FT).max(), _LEVEL_FT, "ft")
    bounds.below("bank", abs(flown.roll_deg).max(), 5.0, "deg")
    bounds.above("throttle", flown.throttle.min(), 0.05)


def test_altitude_unknown_the_pilot_flies_on(lab: Lab, bounds: Bounds) -> None:
    flown = _flown(lab, ["barometer.dropout", "gps.dropout"], 2.0, autopilot=False)
    bounds.below("change of throttle", abs(flown.throttle - 0.6).max(), 0.02)
