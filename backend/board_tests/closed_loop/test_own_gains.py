"""The law that is chosen over the line, in flight, is the one that flies."""

from __future__ import annotations

from epf_gcs.lab.closed_loop import ClosedLoop
from epf_gcs.simulator.simulation import SimulationOptions
from epf_gcs.xplane.datagram import Surfaces

LAW, K_BANK = 0, 4
LINE = 1.0


def flown(*gains: tuple[int, float], after_s: float = 2.0, seconds: float = 3.0) -> list[Surfaces | None]:
    """What moves the aircraft in its first seconds on a route, with these own gains set meanwhile."""
    with ClosedLoop(SimulationOptions()) as loop:
        loop.command("hil_load_gando")
        loop.command("autopilot_on")
        loop.fly(after_s)
        for row, value in gains:
            loop.command("own_gain_set", row, value)
        return [sample.surfaces for sample in loop.fly(seconds)]


def test_the_aircraft_is_flown_by_the_law_and_the_gain_that_were_set_over_the_line() -> None:
    deployed, line, slack = flown(), flown((LAW, LINE)), flown((K_BANK, 1.0), (LAW, LINE))
    assert deployed != line
    assert line != slack


def test_a_gain_of_the_line_law_changes_nothing_while_the_deployed_law_flies() -> None:
    assert flown((K_BANK, 1.0)) == flown()
