"""One aircraft over made ground: height, warnings, and when there are none."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable

import numpy as np
import pytest

from epf_gcs.earth import M_PER_DEG
from epf_gcs.surroundings.aircraft import AircraftSurroundings, SurroundingsView, WatchChoice
from epf_gcs.surroundings.motion import Fix, Vector
from epf_gcs.surroundings.threats import WARN_S

PLACE = (28.0, -15.5)
ACROSS = math.cos(math.radians(PLACE[0]))
WALL_M = 3000.0
"""The ground rises there like a wall: 3 km to the east."""
GROUND = WatchChoice(terrain=True, margin_m=50.0)


def wall(latitude_deg: Vector, longitude_deg: Vector) -> Vector:
    del latitude_deg
    east_m = (longitude_deg - PLACE[1]) * M_PER_DEG * ACROSS
    return np.where(east_m > WALL_M, 1000.0, 100.0)


def unknown(latitude_deg: Vector, longitude_deg: Vector) -> Vector:
    del longitude_deg
    return np.full(latitude_deg.shape, np.nan)


def eastward(from_s: float, until_s: float, *, speed_mps: float = 30.0, altitude_m: float = 400.0) -> Iterable[Fix]:
    for index in range(round((until_s - from_s) * 5)):
        t_s = from_s + index / 5
        yield Fix(t_s, PLACE[0], PLACE[1] + speed_mps * t_s / M_PER_DEG / ACROSS, altitude_m)


def flown(fixes: Iterable[Fix], wanted: WatchChoice, heights: object = wall) -> list[tuple[float, SurroundingsView]]:
    aircraft, found = AircraftSurroundings(), []
    for fix in fixes:
        aircraft.add(fix)
        seen = aircraft.look(fix.t_s, wanted, heights, has_heights=True)  # type: ignore[arg-type]
        found.append((fix.t_s, seen))
    return found


def test_height_is_above_the_ground_and_not_known_where_the_ground_is_not() -> None:
    _, seen = flown(eastward(0, 4), WatchChoice())[-1]
    assert (seen.blind, seen.ground_m, seen.height_m) == (None, 100.0, 300.0)
    _, seen = flown(eastward(0, 4), WatchChoice(), unknown)[-1]
    assert (seen.blind, seen.ground_m, seen.height_m) == ("no_heights_here", None, None)
    aircraft = AircraftSurroundings()
    assert aircraft.look(0.0, GROUND, wall, has_heights=True).blind == "no_position"
    aircraft.add(Fix(0.0, *PLACE, 400.0))
    assert aircraft.look(0.0, GROUND, unknown, has_heights=False).blind == "no_heights"


def test_ground_ahead_is_warned_of_thirty_seconds_before_and_not_a_minute() -> None:
    warned = [t_s for t_s, seen in flown(eastward(0, 99), GROUND) if seen.terrain is not None]
    before_s = WALL_M / 30.0 - warned[0]
    assert WARN_S <= before_s <= WARN_S + 8.0


def test_nothing_is_warned_of_until_it_is_chosen_and_where_nothing_is_known() -> None:
    assert all(seen.terrain is None for _, seen in flown(eastward(0, 99), WatchChoice()))
    assert all(seen.terrain is None for _, seen in flown(eastward(0, 99), GROUND, unknown))


def test_a_path_over_the_ridge_by_more_than_the_margin_is_not_warned_of() -> None:
    assert all(seen.terrain is None for _, seen in flown(eastward(0, 99, altitude_m=1060.0), GROUND))
    assert any(seen.terrain is not None for _, seen in flown(eastward(0, 99, altitude_m=1040.0), GROUND))


def test_a_position_that_stops_is_nothing_at_once_and_no_warning_after_a_moment() -> None:
    aircraft = AircraftSurroundings()
    for fix in eastward(0, 80):
        aircraft.add(fix)
        aircraft.look(fix.t_s, GROUND, wall, has_heights=True)
    held = aircraft.unseen(80.3)
    assert held.terrain is not None
    assert (held.height_m, held.blind) == (None, "no_position")
    assert aircraft.unseen(81.5).terrain is None


def test_it_does_not_chatter_at_the_edge_of_the_margin() -> None:
    rocking = (
        fix._replace(altitude_m=1050.0 + 4.0 * math.sin(fix.t_s * 2.0)) for fix in eastward(0, 95, altitude_m=1050.0)
    )
    shown = [seen.terrain is not None for _, seen in flown(rocking, GROUND)]
    assert sum(one != other for one, other in itertools.pairwise(shown)) <= 2
    assert any(shown)


def test_an_aircraft_slowed_by_the_wind_is_still_watched_and_one_that_has_landed_is_not() -> None:
    wanted = WatchChoice(fence=True, corners_deg=square(300.0), fence_margin_m=30.0)

    def slowed(to_mps: float) -> Iterable[Fix]:
        # Fast for 5 s, then slowly towards the border.
        for index in range(5 * 120):
            t_s = index / 5
            east_m = min(t_s, 5.0) * 20.0 + max(0.0, t_s - 5.0) * to_mps
            yield Fix(t_s, PLACE[0], PLACE[1] + east_m / M_PER_DEG / ACROSS, 400.0)

    def warned_s(to_mps: float) -> list[float]:
        seen = flown(slowed(to_mps), wanted, unknown)
        return [t_s for t_s, one in seen if one.fence is not None and t_s > 30.0]

    reached_s = 5.0 + 200.0 / 3.0
    first_s, last_s = warned_s(3.0)[0], warned_s(3.0)[-1]
    assert WARN_S <= reached_s - first_s <= WARN_S + 19.0
    assert last_s > 119.0
    # Outside, still and level: it has landed there.
    wanted = WatchChoice(fence=True, corners_deg=square(90.0), fence_margin_m=30.0)
    assert warned_s(0.0) == []


def standing_then(fixes: Iterable[Fix], speed_mps: float = 0.0) -> Iterable[Fix]:
    yield from eastward(-20, 0, speed_mps=speed_mps, altitude_m=101.0)
    yield from fixes


def test_the_take_off_and_the_landing_where_it_took_off_are_not_warned_of() -> None:
    def climbing() -> Iterable[Fix]:
        for fix in eastward(0.1, 30, speed_mps=25.0):
            yield fix._replace(altitude_m=101.0 + 3.0 * fix.t_s)

    assert all(seen.terrain is None for _, seen in flown(standing_then(climbing()), GROUND))

    def back() -> Iterable[Fix]:
        yield from climbing()
        for index in range(145):
            after_s = index / 5
            east_m = 750.0 - 25.0 * after_s
            yield Fix(40.0 + after_s, PLACE[0], PLACE[1] + east_m / M_PER_DEG / ACROSS, 191.0 - 3.0 * after_s)

    assert all(seen.terrain is None for _, seen in flown(standing_then(back()), GROUND))


def test_an_aircraft_first_seen_in_flight_is_warned_at_once() -> None:
    low = flown(eastward(80, 90, altitude_m=120.0), GROUND)
    assert low[-1][1].terrain is not None
    assert low[-1][1].terrain.in_s == 0.0


def square(half_m: float) -> tuple[tuple[float, float], ...]:
    high, wide = half_m / M_PER_DEG, half_m / M_PER_DEG / ACROSS
    north, east = PLACE
    return (
        (north - high, east - wide),
        (north - high, east + wide),
        (north + high, east + wide),
        (north + high, east - wide),
    )


def test_the_fence_is_warned_of_before_it_is_reached_and_called_left_after() -> None:
    wanted = WatchChoice(fence=True, corners_deg=square(WALL_M), fence_margin_m=30.0)
    found = flown(eastward(0, 120), wanted, unknown)
    warned = [t_s for t_s, seen in found if seen.fence is not None]
    assert WARN_S <= WALL_M / 30.0 - warned[0] <= WARN_S + 9.0
    assert [seen.outside for t_s, seen in found if abs(t_s - 99.0) < 0.05] == [False]
    assert found[-1][1].outside
    assert found[-1][1].fence is not None


def test_the_ceiling_is_a_part_of_the_fence() -> None:
    def climbing() -> Iterable[Fix]:
        for fix in eastward(0, 100):
            yield fix._replace(altitude_m=300.0 + 2.0 * fix.t_s)

    found = flown(climbing(), WatchChoice(fence=True, ceiling_m=480.0, fence_margin_m=0.0), unknown)
    first = next((t_s, seen.fence) for t_s, seen in found if seen.fence is not None)
    assert WARN_S <= 90.0 - first[0] <= WARN_S + 8.0
    assert first[1].what == "ceiling"
    assert found[-1][1].outside


@pytest.mark.parametrize("wanted", [GROUND, WatchChoice(fence=True, ceiling_m=50.0)])
def test_an_aircraft_that_stands_is_not_warned(wanted: WatchChoice) -> None:
    for _, seen in flown(eastward(0, 20, speed_mps=0.0, altitude_m=101.0), wanted):
        assert (seen.terrain, seen.fence, seen.outside) == (None, None, False)


def test_a_lift_under_the_ceiling_is_not_warned_of_and_a_climb_to_it_is_half_a_minute_before() -> None:
    wanted = WatchChoice(fence=True, ceiling_m=500.0, fence_margin_m=30.0)

    def climbing(climb_mps: float, until_s: float) -> list[float]:
        fixes = (
            fix._replace(altitude_m=400.0 + climb_mps * min(max(0.0, fix.t_s - 20.0), until_s - 20.0))
            for fix in eastward(0, 100)
        )
        return [t_s for t_s, seen in flown(fixes, wanted, unknown) if seen.fence is not None]

    # 2 m/s for 5 s.
    assert climbing(2.0, 25.0) == []
    reached_s = 20.0 + 100.0 / 2.0
    assert WARN_S <= reached_s - climbing(2.0, 100.0)[0] <= WARN_S + 15.0
