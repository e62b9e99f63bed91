"""A flown track becomes the few places from which it differs least; silences and jumps are no legs of a plan."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
import pytest

from epf_gcs.earth import distance_m
from epf_gcs.flights.flown_path import flown_path
from epf_gcs.formats.mission_file import MAX_WAYPOINTS
from tests.flights.test_events import MadeFlight, circle

PER_M = 1.0 / 111_195.0
Numbers = npt.NDArray[np.float64]


def simulated(t_s: Numbers, north_m: Numbers, altitude_ft: float = 1000.0) -> MadeFlight:
    """A flight of the simulator's aircraft along a meridian."""
    values = {
        "latitude_deg": 28.0 + north_m * PER_M,
        "longitude_deg": np.full(len(t_s), -15.0),
        "altitude_msl_ft": np.full(len(t_s), altitude_ft),
    }
    return MadeFlight({"simulator": (t_s, values)}, [])


def test_a_circle_is_a_polygon_that_differs_by_no_more_than_is_told() -> None:
    path = flown_path(circle(), "flight", MAX_WAYPOINTS)
    assert (path.points, path.pieces) == (2950, 1)
    assert 10 < len(path.places) <= MAX_WAYPOINTS
    off_m = [abs(distance_m(28.0, -15.0, latitude, longitude) - 1000.0) for latitude, longitude, _ in path.places]
    assert max(off_m) < 3.0
    assert 0.0 < path.deviation_m < 40.0
    assert path.places[-1][2] == pytest.approx(300.0)


def test_fewer_places_differ_more_and_the_ends_stay() -> None:
    many, few = (flown_path(circle(), "flight", most) for most in (50, 10))
    assert len(few.places) == 10
    assert few.deviation_m > many.deviation_m
    assert (few.places[0], few.places[-1]) == (many.places[0], many.places[-1])


def test_the_simulators_track_has_metres_above_the_sea() -> None:
    t_s = np.arange(0.0, 60.0, 0.5)
    path = flown_path(simulated(t_s, t_s * 30.0), "hil", MAX_WAYPOINTS)
    assert len(path.places) == 2
    assert [place[2] for place in path.places] == pytest.approx([304.8, 304.8])


def test_a_silence_and_a_jump_break_it_and_a_pause_does_not() -> None:
    t_s = np.arange(0.0, 300.0, 0.5)
    north_m = t_s * 30.0
    paused = np.where(t_s < 100.0, north_m, np.maximum(3000.0, north_m - 900.0))
    assert flown_path(simulated(t_s, paused), "hil", MAX_WAYPOINTS).pieces == 1
    jumped = np.where(t_s < 100.0, north_m, north_m + 50_000.0)
    path = flown_path(simulated(t_s, jumped), "hil", MAX_WAYPOINTS)
    assert (path.pieces, path.points) == (2, 400)
    assert path.places[0][0] == pytest.approx(28.0 + 53_000.0 * PER_M)
    silent = (t_s < 100.0) | (t_s > 120.0)
    path = flown_path(simulated(t_s[silent], north_m[silent]), "hil", MAX_WAYPOINTS)
    assert path.pieces == 2
    assert path.places[0][0] > 28.0 + 3500.0 * PER_M


def test_without_a_position_there_are_no_places() -> None:
    for flight in (MadeFlight({}, []), simulated(np.array([1.0]), np.array([0.0]))):
        assert flown_path(flight, "hil", MAX_WAYPOINTS).places == []
