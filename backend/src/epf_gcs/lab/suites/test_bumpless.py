"""The change between pilot and autopilot: nothing jumps, whichever way it goes, and who does not fly moves nothing."""

from __future__ import annotations

import pytest

from epf_gcs.lab.bounds import Bounds
from epf_gcs.lab.plugin import Lab

# In a frame of 20 ms, of half a surface's travel: no eye sees less.
_MOVE = 0.02


@pytest.mark.parametrize(
    "stick",
    [
        pytest.param((0.0, 0.0, 0.0), id="hands off"),
        pytest.param((0.02, 0.02, 0.0), id="climbing in a left turn"),
        pytest.param((-0.03, 0.03, 0.1), id="descending with rudder"),
    ],
)
def test_the_autopilot_takes_over_and_hands_back(lab: Lab, bounds: Bounds, stick: tuple[float, float, float]) -> None:
    with lab.watch() as loop:
        loop.go(3.0)
        loop.stick = stick
        before = loop.go(8.0)
        loop.command("autopilot_on")
        over = loop.go(2.0)
        bounds.below("largest move on taking over", over.largest_move(), _MOVE)
        bounds.below("change of load", abs(over.load_g - before.load_g[-1]).max(), 0.3, "g")
        held = loop.go(14.0)
        bounds.below("bank held", abs(held.roll_deg[-1]), 3.0, "deg")
        bounds.below("change of altitude", abs(held.altitude_ft[-1] - before.altitude_ft[-1]), 60.0, "ft")
        loop.stick = (0.0, 0.0, 0.0)
        loop.command("autopilot_off")
        back = loop.go(2.0)
        bounds.below("largest move on handing back", back.largest_move(), _MOVE)
        bounds.below("change of load", abs(back.load_g - held.load_g[-1]).max(), 0.3, "g")


def test_the_stick_moves_nothing_while_the_autopilot_flies(lab: Lab, bounds: Bounds) -> None:
    with lab.watch() as loop:
        loop.command("autopilot_on")
        loop.go(8.0)
        loop.stick = (1.0, 1.0, 1.0)
        bounds.below("largest move by the stick", loop.go(2.0).largest_move(), _MOVE)
        loop.command("autopilot_off")
        bounds.above("largest move once the pilot flies", loop.go(1.0).largest_move(), _MOVE)


@pytest.mark.parametrize(
    ("stick", "angle", "sign"),
    [
        pytest.param((0.1, 0.0, 0.0), "pitch_deg", 1.0, id="nose up"),
        pytest.param((-0.1, 0.0, 0.0), "pitch_deg", -1.0, id="nose down"),
        pytest.param((0.0, 0.15, 0.0), "roll_deg", 1.0, id="right"),
        pytest.param((0.0, -0.15, 0.0), "roll_deg", -1.0, id="left"),
    ],
)
def test_the_pilots_stick_turns_the_aircraft_the_way_it_says(
    lab: Lab, bounds: Bounds, stick: tuple[float, float, float], angle: str, sign: float
) -> None:
    with lab.watch() as loop:
        loop.go(2.0)
        loop.stick = stick
        turned_deg = sign * getattr(loop.go(1.5), angle)
        bounds.above("turned", turned_deg[-1] - turned_deg[0], 3.0, "deg")


def test_the_throttle_lever_is_the_pilots_with_the_autopilot_off(lab: Lab, bounds: Bounds) -> None:
    with lab.watch() as loop:
        lever = loop.go(1.0).throttle[0]
        bounds.below("difference from the lever", abs(loop.go(3.0).throttle[-1] - lever), 0.02)
