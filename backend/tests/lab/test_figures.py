"""The definitions of the figures, on flights made up so that the answer is known."""

from dataclasses import replace

import pytest

from epf_gcs.codec.tables import Waypoint
from epf_gcs.lab.closed_loop import Sample
from epf_gcs.lab.figures import measure, percentile, rms, settling_s, split
from epf_gcs.lab.truth import Truth
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
    (leg,) = split(Truth.of(flight), ROUTE)
    assert leg.cross_track_m() == pytest.approx([0.0, 30.0, 0.0], abs=0.01)


def test_altitude_counts_from_the_first_time_within_30_ft() -> None:
    altitudes = [900.0, 969.0, 971.0, 1040.0, 1000.0]
    flight = [sample(float(n), 0, float(n), altitude_ft=altitude) for n, altitude in enumerate(altitudes)]
    (leg,) = split(Truth.of(flight), ROUTE)
    assert leg.altitude_errors_ft() == pytest.approx([-29.0, 40.0, 0.0])


def test_a_leg_begins_where_the_plan_goes_on_and_unflown_legs_are_not_reached() -> None:
    flight = [sample(0.0, -1, 0.0), sample(1.0, 0, 0.0), sample(2.0, 0, 3.0), sample(3.0, 1, 3.1), sample(4.0, 1, 4.0)]
    legs = split(Truth.of(flight), ROUTE)
    assert [len(leg.truth) for leg in legs] == [2, 2]
    assert legs[1].begin == (ROUTE[0].latitude_deg, ROUTE[0].longitude_deg)
    assert measure(Truth.of(flight), ROUTE).waypoints_reached == 1
    assert measure(Truth.of([*flight, sample(5.0, 1, 5.9)]), ROUTE).waypoints_reached == 2


def test_settling_ends_with_the_last_sample_outside_the_band() -> None:
    flight = [sample(10.0 + n, 0, 0.0, altitude_ft=1000.0 + error) for n, error in enumerate([300, 20, -31, 5, 30])]
    assert settling_s(flight, lambda s: s.state.altitude_ft - 1000.0, 30.0) == 2.0


def test_figures_of_nothing_pass_no_limit() -> None:
    assert not rms([]) < 1e9
    assert not percentile([], 0.95) < 1e9
    assert percentile([1.0, -5.0, 2.0, 3.0], 0.5) == 2.0


def test_a_capture_is_honest_within_the_laws_radius_and_100_ft() -> None:
    def end(north: float, altitude_ft: float) -> bool:
        flight = [sample(0.0, 0, 0.0), sample(1.0, 0, north, altitude_ft=altitude_ft), sample(2.0, 1, north)]
        (capture, *_) = measure(Truth.of(flight), ROUTE).captures
        return capture.is_honest

    assert end(2.81, 1090.0)
    assert not end(2.79, 1000.0), "205 m away"
    assert not end(2.81, 1101.0), "too high"


def test_near_counts_the_leg_before_in_a_turn_and_leg_leaves_out_its_first_10_s() -> None:
    turn = sample(20.0, 1, 3.0, east_deg=NORTH_1_KM * 0.1)
    flight = [sample(0.0, 0, 0.0), sample(19.0, 0, 2.9), turn, sample(31.0, 1, 5.0, east_deg=NORTH_1_KM * 0.02)]
    figures = measure(Truth.of(flight), ROUTE)
    assert figures.cross_track.largest_m == pytest.approx(100.0, abs=0.1)
    assert figures.leg.largest_m == pytest.approx(20.0, abs=0.1)
    legs = split(Truth.of(flight), ROUTE)
    assert legs[0].distance_m(legs[1].truth)[0] == pytest.approx(100.0, abs=0.1), "beyond its end"
