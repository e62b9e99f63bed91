"""The change between pilot and autopilot: nothing jumps, whichever way it goes."""

from itertools import pairwise

import pytest

from epf_gcs.lab.closed_loop import ClosedLoop, Sample
from epf_gcs.simulator.simulation import SimulationOptions
from epf_gcs.xplane.datagram import Record, build

# A surface moves in a frame (20 ms) by less than a fiftieth of its half travel: no eye sees it.
LARGEST_MOVE = 0.02
LARGEST_LOAD_CHANGE_G = 0.3

STICK_ROW = 8


def move_stick(loop: ClosedLoop, elevator: float, aileron: float, rudder: float) -> None:
    loop.simulation.receive(build([Record(STICK_ROW, (elevator, aileron, rudder, *[-999.0] * 5))]))


def largest_move(samples: list[Sample]) -> float:
    moves = [
        abs(after - before)
        for first, second in pairwise(samples)
        if first.surfaces is not None and second.surfaces is not None
        for before, after in zip(first.surfaces, second.surfaces, strict=True)
    ]
    assert len(moves) == 4 * (len(samples) - 1)
    return max(moves)


def largest_load_change_g(samples: list[Sample]) -> float:
    return max(abs(sample.state.load_normal_g - samples[0].state.load_normal_g) for sample in samples)


@pytest.mark.parametrize(
    "stick",
    [
        pytest.param((0.0, 0.0, 0.0), id="hands off"),
        pytest.param((0.02, 0.02, 0.0), id="climbing in a left turn"),
        pytest.param((-0.03, 0.03, 0.1), id="descending with rudder"),
    ],
)
def test_the_autopilot_takes_over_and_hands_back_without_a_bump(stick: tuple[float, float, float]) -> None:
    with ClosedLoop(SimulationOptions()) as loop:
        loop.fly(5.0)
        move_stick(loop, *stick)
        loop.fly(10.0)

        before = loop.samples[-1]
        loop.command("autopilot_on")
        taken_over = [before, *loop.fly(2.0)]
        assert largest_move(taken_over) < LARGEST_MOVE
        assert largest_load_change_g(taken_over) < LARGEST_LOAD_CHANGE_G

        # Without a plan it holds what it found, so it has levelled off by now.
        loop.fly(20.0)
        held = loop.samples[-1]
        assert abs(held.state.roll_deg) < 3.0
        assert abs(held.state.altitude_ft - before.state.altitude_ft) < 60.0

        move_stick(loop, 0.0, 0.0, 0.0)
        loop.command("autopilot_off")
        handed_back = [held, *loop.fly(2.0)]
        assert largest_move(handed_back) < LARGEST_MOVE
        assert largest_load_change_g(handed_back) < LARGEST_LOAD_CHANGE_G
        # The pilot's throttle lever has its say again.
        assert handed_back[-1].surfaces is not None
        lever = loop.simulation.inputs.stick().throttle
        assert handed_back[-1].surfaces.throttle == pytest.approx(lever, abs=0.02)


def test_the_stick_moves_nothing_while_the_autopilot_flies() -> None:
    with ClosedLoop(SimulationOptions()) as loop:
        loop.command("autopilot_on")
        loop.fly(20.0)
        before = loop.samples[-1]
        move_stick(loop, 1.0, 1.0, 1.0)
        samples = [before, *loop.fly(2.0)]
        assert largest_move(samples) < LARGEST_MOVE
        loop.command("autopilot_off")
        # Now it does: full stick is more than a nudge.
        assert largest_move(loop.fly(2.0)) > LARGEST_MOVE
