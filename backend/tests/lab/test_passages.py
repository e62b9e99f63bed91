"""Captures of a law that turns before a waypoint, on flights made up so that the answer is known."""

from dataclasses import replace

import pytest

from epf_gcs.codec.tables import Waypoint
from epf_gcs.lab.closed_loop import Sample
from epf_gcs.lab.figures import Figures, measure
from epf_gcs.lab.passages import in_passing
from epf_gcs.lab.routes import Route
from epf_gcs.lab.truth import Truth
from epf_gcs.simulator.simulation import Simulation, SimulationOptions
from epf_gcs.xplane.datagram import Surfaces

STATE = Simulation(SimulationOptions(), print).state
DEG_PER_M = 1.0 / 111_195.0
CORNER = Waypoint(2000.0 * DEG_PER_M, 0.0, 1000.0, 55.0)
ROUTE = Route("plan", (CORNER, Waypoint(2000.0 * DEG_PER_M, 2000.0 * DEG_PER_M, 1000.0, 55.0)))


def place_at(way_m: float, beside_m: float) -> tuple[float, float]:
    """North and east, m, on the way north, over a chord that is `beside_m` from the corner, and east."""
    cut_m = beside_m * 2**0.5
    north_m = min(way_m, 2000.0 - cut_m)
    chord_m = min(max(way_m - north_m, 0.0), 2.0 * beside_m)
    east_m = max(way_m - north_m - chord_m, 0.0)
    return north_m + chord_m / 2**0.5, chord_m / 2**0.5 + east_m


def judged(beside_m: float, altitude_ft: float) -> Figures:
    """A flight by `place_at` at 30 m/s; the plan goes on 200 m before the corner."""
    rows = []
    for second in range(132):
        north_m, east_m = place_at(30.0 * second, beside_m)
        state = replace(
            STATE,
            latitude_deg=north_m * DEG_PER_M,
            longitude_deg=east_m * DEG_PER_M,
            altitude_ft=altitude_ft,
            airspeed_indicated_kt=55.0,
        )
        waypoint = 0 if 30.0 * second < 1800.0 else 1
        rows.append(Sample(float(second), state, waypoint, Surfaces(0.0, 0.0, 0.0, 0.0)))
    truth = Truth.of(rows)
    return in_passing(measure(truth, ROUTE.waypoints), truth, ROUTE, 30.0)


def test_a_waypoint_counts_where_the_aircraft_is_nearest_to_it_after_the_plan_went_on() -> None:
    corner, end = judged(60.0, 1020.0).captures
    assert corner.distance_m == pytest.approx(60.0, abs=15.0)
    assert corner.altitude_error_ft == pytest.approx(20.0)
    assert corner.within_m == pytest.approx(1.2 * 30.0**2 / (9.80665 * 0.57735), rel=0.01)
    assert corner.is_honest
    assert end.is_honest


def test_a_passage_further_than_1_2_radii_or_100_ft_off_is_no_capture() -> None:
    assert not judged(300.0, 1000.0).captures[0].is_honest
    assert not judged(60.0, 1130.0).captures[0].is_honest
