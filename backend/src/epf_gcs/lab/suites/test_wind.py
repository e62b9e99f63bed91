"""Wind from every side, and turbulence: the plan is flown all the same."""

from __future__ import annotations

import pytest

from epf_gcs.lab.bounds import Bounds
from epf_gcs.lab.plugin import Lab
from epf_gcs.lab.suites.places import SHORT


@pytest.mark.parametrize("wind_from_deg", [33.0, 123.0, 303.0])
def test_15_kt_of_wind(lab: Lab, bounds: Bounds, wind_from_deg: float) -> None:
    flight = lab.fly(SHORT, wind_kt=15.0, wind_from_deg=wind_from_deg)
    bounds.equal("waypoints at which the aircraft was", flight.captured_honestly, len(SHORT))
    bounds.below("off the way, rms", flight.near.rms_m, 50.0, "m")
    bounds.below("altitude, rms", flight.altitude.settled.rms_ft, 14.0, "ft")


def test_moderate_turbulence_in_10_kt(lab: Lab, bounds: Bounds, lab_seed: int) -> None:
    flight = lab.fly(SHORT, wind_kt=10.0, wind_from_deg=330.0, turbulence="moderate", seed=lab_seed)
    bounds.equal("waypoints at which the aircraft was", flight.captured_honestly, len(SHORT))
    bounds.below("off the way, rms", flight.near.rms_m, 55.0, "m")
    bounds.below("altitude, rms", flight.altitude.settled.rms_ft, 30.0, "ft")
