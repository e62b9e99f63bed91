"""The report's figures of flights of the closed loop are those that were flown."""

from __future__ import annotations

from board_tests.closed_loop.stepped_flights import WITHIN, errors, f1_of, fly

# In calm air, in wind and in light turbulence; `python -m bench report` flies fifty.
SEEDS = range(3)
STEPS = 3


def test_every_step_is_found_with_the_rise_time_overshoot_and_settled_error_that_were_flown_and_nothing_else() -> None:
    flights = [fly(seed, STEPS) for seed in SEEDS]
    assert sum(len(flight.flown) for flight in flights) >= STEPS * len(SEEDS)
    assert f1_of(flights) == 1.0
    for name, found in errors(flights).items():
        assert len(found) >= 2 * len(SEEDS), name
        assert max(found) <= WITHIN, name
