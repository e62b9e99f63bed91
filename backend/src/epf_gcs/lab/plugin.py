"""The lab's pytest plug-in: the fixture `lab`, which flies, and the option that says which board's laws fly.

def test_gando_in_a_crosswind(lab):
    flight = lab.fly("gando", wind_kt=15, wind_from_deg=250, seed=7)
    assert flight.waypoints_reached == 8
    assert flight.cross_track.rms_m < 60
    assert flight.altitude.settled.rms_ft < 20
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from epf_gcs.codec.tables import Waypoint
    from epf_gcs.lab.faults import Asked
    from epf_gcs.lab.flight import Flight

# What flies is imported where it is used: pytest loads a plug-in in every run on a computer that has it.


class Lab:
    """Flies a board's laws in the simulator. `library`: the laws; None: those of this station's own board. `usual`:
    conditions of every flight that does not say otherwise."""

    def __init__(self, library: Path | None = None, **usual: Any) -> None:
        self._library = library
        self._usual = usual
        self.flights: list[Flight] = []

    def fly(
        self,
        route: str | Path | Sequence[Waypoint],
        *,
        gains: Mapping[str, float] | None = None,
        faults: Iterable[Asked] = (),
        longest_s: float = math.inf,
        **conditions: Any,
    ) -> Flight:
        """Fly a route by name (`gando`), from a plan file, or of waypoints. `gains`: by the board's names, as `k_roll`.
        `faults`: as `gyro.drift@60+30=0.002` (see `epf_gcs.lab.faults`). `longest_s`: it ends then at the latest.

        The conditions are those of `epf_gcs.lab.conditions.Conditions`, as `wind_kt=15, seed=7`. Raises LabError for a
        route, a gain, a condition or a fault that there is none of, and for a fault that was not there.
        """
        from epf_gcs.lab.flying import fly_wanted  # noqa: PLC0415 - see above

        flown = fly_wanted(route, {**self._usual, **conditions}, gains, self._library, faults, longest_s)
        self.flights.append(flown)
        return flown


def pytest_addoption(parser: pytest.Parser) -> None:
    """The lab's options."""
    group = parser.getgroup("lab", "epf-lab: flights of a board's laws in the simulator")
    group.addoption("--laws", type=Path, help="the shared library with the board's laws; usual: this station's own")
    group.addoption("--aircraft", default=None, help="what they are flown in: rc (usual) or c172p")


@pytest.fixture(scope="session")
def lab(pytestconfig: pytest.Config) -> Lab:
    """Flies what the command line names."""
    aircraft = pytestconfig.getoption("--aircraft")
    return Lab(pytestconfig.getoption("--laws"), **({} if aircraft is None else {"aircraft": aircraft}))
