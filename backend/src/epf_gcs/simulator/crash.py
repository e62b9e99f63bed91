"""When a flight is over: the reasons for which the aircraft is put back to its start."""

import math
from dataclasses import fields
from operator import attrgetter
from typing import Final

from epf_gcs.simulator.state import FlightState

LOAD_LIMIT_G: Final = 15.0
# No quantity of a real flight comes near this, in any unit used here.
_LARGEST: Final = 1e9
_numbers: Final = attrgetter(*(field.name for field in fields(FlightState) if field.type is float))


def crash_cause(state: FlightState) -> str | None:
    """Say why this instant is a crash; None while the flight goes on."""
    if not all(abs(value) <= _LARGEST for value in _numbers(state)):
        return "the flight model lost its numbers (a value is not finite, or beyond all reason)"
    load_g = math.sqrt(state.load_normal_g**2 + state.load_axial_g**2 + state.load_side_g**2)
    if load_g > LOAD_LIMIT_G:
        return f"the load reached {load_g:.0f} g (limit {LOAD_LIMIT_G:.0f} g)"
    if state.touching is not None:
        return f"the {state.touching} touched the ground"
    return None
