"""The present track and the wind, from positions."""

from __future__ import annotations

import math

import pytest

from epf_gcs.earth import M_PER_DEG
from epf_gcs.surroundings.motion import Fix, Motion, MotionEstimate
from epf_gcs.surroundings.path import path_ahead

PLACE = (28.0, -15.5)
ACROSS = math.cos(math.radians(PLACE[0]))


def fix_at(t_s: float, east_m: float, north_m: float, altitude_m: float = 500.0) -> Fix:
    return Fix(t_s, PLACE[0] + north_m / M_PER_DEG, PLACE[1] + east_m / M_PER_DEG / ACROSS, altitude_m)


def turning(seconds: float, wind_mps: tuple[float, float], airspeed_mps: float = 25.0, rate: float = 0.1) -> list[Fix]:
    """Right turns through air that moves."""
    found = []
    for index in range(round(seconds * 5)):
        t_s = index / 5
        east_m = airspeed_mps / rate * (1 - math.cos(rate * t_s)) + wind_mps[0] * t_s
        north_m = airspeed_mps / rate * math.sin(rate * t_s) + wind_mps[1] * t_s
        found.append(fix_at(t_s, east_m, north_m))
    return found


def measured(fixes: list[Fix]) -> Motion:
    track = MotionEstimate()
    for fix in fixes:
        track.add(fix)
    motion = track.now()
    assert motion is not None
    return motion


def test_straight_flight_has_speed_climb_and_no_turn() -> None:
    motion = measured([fix_at(index / 5, 3.0 * index, 4.0 * index, 500.0 + 0.4 * index) for index in range(50)])
    assert (motion.east_mps, motion.north_mps) == pytest.approx((15.0, 20.0), abs=0.2)
    assert motion.climb_mps == pytest.approx(2.0, abs=0.05)
    assert motion.turn_rad_s == 0.0


def test_a_turn_shows_its_rate_and_the_wind_and_its_path_drifts_with_it() -> None:
    wind = (6.0, -4.0)
    fixes = turning(110.0, wind)
    motion = measured(fixes[:400])
    assert motion.turn_rad_s == pytest.approx(0.1, abs=0.01)
    assert (motion.wind_east_mps, motion.wind_north_mps) == pytest.approx(wind, abs=0.8)
    path = path_ahead(motion, fixes[399].t_s, 30.0)
    true = fixes[399 + 150]
    east_m = (path.longitude_deg[-1] - true.longitude_deg) * M_PER_DEG * ACROSS
    north_m = (path.latitude_deg[-1] - true.latitude_deg) * M_PER_DEG
    assert math.hypot(east_m, north_m) < 60.0


def test_nothing_is_known_before_some_seconds_and_after_a_gap_or_a_jump() -> None:
    track = MotionEstimate()
    for index in range(10):
        track.add(fix_at(index / 5, 5.0 * index, 0.0))
    assert track.now() is None
    for index in range(10, 40):
        track.add(fix_at(index / 5, 5.0 * index, 0.0))
    assert track.now() is not None
    track.add(fix_at(20.0, 500.0, 0.0))
    assert track.now() is None
    for index in range(40):
        track.add(fix_at(20.2 + index / 5, 5.0 * index, 0.0))
    assert track.now() is not None
    track.add(fix_at(28.5, 90_000.0, 0.0))
    assert track.now() is None


def test_the_turn_is_limited_to_what_an_aircraft_can_turn() -> None:
    motion = measured(turning(20.0, (0.0, 0.0), airspeed_mps=40.0, rate=0.6))
    assert motion.turn_rad_s <= 9.81 * math.tan(math.radians(50.0)) / 35.0


def test_the_date_line_is_no_jump() -> None:
    track = MotionEstimate()
    for index in range(40):
        longitude_deg = (179.999 + index * 0.0001 + 180.0) % 360.0 - 180.0
        track.add(Fix(index / 5, 0.0, longitude_deg, 100.0))
    motion = track.now()
    assert motion is not None
    assert motion.east_mps == pytest.approx(0.0005 * M_PER_DEG, rel=0.05)
    assert path_ahead(motion, motion.t_s, 30.0).longitude_deg[-1] < -179.0


def test_gusts_disturb_a_steady_turn_little_once_it_lasted() -> None:
    def disturbed(seconds: float) -> float:
        # A gust of 1 m/s across the track now and then, as a rate that swings by 1.1 degrees/s within 10 s.
        found, east_m, north_m = [], 0.0, 0.0
        for index in range(round(seconds * 5)):
            t_s = index / 5
            track_rad = 0.1 * t_s + 0.04 * math.sin(2 * math.pi * t_s / 12.0)
            east_m += 5.0 * math.sin(track_rad)
            north_m += 5.0 * math.cos(track_rad)
            found.append(fix_at(t_s, east_m, north_m))
        return abs(measured(found).turn_rad_s - 0.1)

    assert max(disturbed(41.0 + after_s) for after_s in range(12)) < 0.004
    assert max(disturbed(10.0 + after_s) for after_s in range(12)) > 0.008


def test_a_lift_of_some_seconds_is_no_climb_and_a_dive_is_one_at_once() -> None:
    def climbing(climb_mps: float, for_s: float) -> float:
        return measured(
            [
                fix_at(index / 5, 5.0 * index, 0.0, 500.0 + climb_mps * max(0.0, index / 5 - 30.0))
                for index in range(round((30.0 + for_s) * 5))
            ]
        ).climb_mps

    assert climbing(1.5, 3.0) < 0.6
    assert climbing(1.5, 20.0) == pytest.approx(1.5, abs=0.3)
    assert climbing(-8.0, 3.0) < -4.0
