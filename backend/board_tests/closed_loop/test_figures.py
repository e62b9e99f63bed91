"""The definitions of the figures, on flights made up so that the answer is known."""

from dataclasses import replace

import pytest

from board_tests.closed_loop.closed_loop import Sample
from board_tests.closed_loop.figures import measure, percentile, rms, settling_s, split
from epf_gcs.codec.tables import Waypoint
from epf_gcs.simulator.simulation import Simulation, SimulationOptions
from epf_gcs.xplane.datagram import Surfaces

STATE = Simulation(SimulationOptions(), print).state
NORTH_1_KM = 1000.0 / 111_195.0


def sample(time_s: float, waypoint: int, north: float, east_deg: float = 0.0, altitude_ft: float = 1000.0) -> Sample:
    state = replace(
        STATE,
        latitude_deg=north * NORTH_1_KM,
        longitude_deg=east_deg,
        altitude_ft=altitude_ft,
        airspeed_indicated_kt=55.0,
    )
    return Sample(time_s, state, waypoint, Surfaces(0.0, 0.0, 0.0, 0.0))


ROUTE = (Waypoint(3 * NORTH_1_KM, 0.0, 1000.0, 55.0), Waypoint(6 * NORTH_1_KM, 0.0, 1200.0, 55.0))


def test_cross_track_is_the_distance_from_the_line_and_positive_to_its_right() -> None:
    flight = [sample(0.0, 0, 0.0), sample(1.0, 0, 1.0, east_deg=NORTH_1_KM * 0.03), sample(2.0, 0, 2.0)]
    (leg,) = split(flight, ROUTE)
    assert leg.cross_track_m() == pytest.approx([0.0, 30.0, 0.0], abs=0.01)


def test_altitude_counts_from_the_first_time_within_30_ft() -> None:
    altitudes = [900.0, 969.0, 971.0, 1040.0, 1000.0]
    flight = [sample(float(n), 0, float(n), altitude_ft=altitude) for n, altitude in enumerate(altitudes)]
    (leg,) = split(flight, ROUTE)
    assert leg.altitude_errors_ft() == [-29.0, 40.0, 0.0]


def test_a_leg_begins_where_the_plan_goes_on_and_unflown_legs_are_not_reached() -> None:
    flight = [sample(0.0, -1, 0.0), sample(1.0, 0, 0.0), sample(2.0, 0, 3.0), sample(3.0, 1, 3.1), sample(4.0, 1, 4.0)]
    legs = split(flight, ROUTE)
    assert [len(leg.samples) for leg in legs] == [2, 2]
    assert legs[1].begin == (ROUTE[0].latitude_deg, ROUTE[0].longitude_deg)
    assert measure(flight, ROUTE).waypoints_reached == 1
    assert measure([*flight, sample(5.0, 1, 5.9)], ROUTE).waypoints_reached == 2


def test_settling_ends_with_the_last_sample_outside_the_band() -> None:
    flight = [sample(10.0 + n, 0, 0.0, altitude_ft=1000.0 + error) for n, error in enumerate([300, 20, -31, 5, 30])]
    assert settling_s(flight, lambda s: s.state.altitude_ft - 1000.0, 30.0) == 2.0


def test_figures_of_nothing_pass_no_limit() -> None:
    assert not rms([]) < 1e9
    assert not percentile([], 0.95) < 1e9
    assert percentile([1.0, -5.0, 2.0, 3.0], 0.5) == 2.0
