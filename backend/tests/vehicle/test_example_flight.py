"""The example aircraft: all its numbers are of one flight."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs import earth
from epf_gcs.vehicle.example_flight import (
    CENTRE_LATITUDE_DEG,
    CENTRE_LONGITUDE_DEG,
    RADIUS_M,
    SPEED_KT,
    TURN_RATE_RAD_S,
    moment,
)

TIMES = st.floats(0, 86400, allow_nan=False)
M_PER_DEG = math.pi * earth.RADIUS_M / 180.0


def moved_m(first_s: float, second_s: float) -> tuple[float, float]:
    """North and east."""
    first, second = moment(first_s), moment(second_s)
    scale = math.cos(math.radians(first.latitude_deg))
    return (
        (second.latitude_deg - first.latitude_deg) * M_PER_DEG,
        (second.longitude_deg - first.longitude_deg) * M_PER_DEG * scale,
    )


@given(TIMES)
def test_it_moves_where_its_nose_points_at_its_speed(t_s: float) -> None:
    north_m, east_m = moved_m(t_s, t_s + 0.1)
    track_deg = math.degrees(math.atan2(east_m, north_m))
    turn_deg = (track_deg - moment(t_s + 0.05).heading_deg + 180.0) % 360.0 - 180.0
    assert abs(turn_deg) < 0.2
    assert math.hypot(north_m, east_m) / 0.1 == pytest.approx(SPEED_KT * 1852 / 3600, rel=1e-3)


@given(TIMES)
def test_height_climb_and_pressure_agree(t_s: float) -> None:
    climbed_ft_s = (moment(t_s + 0.05).altitude_ft - moment(t_s - 0.05).altitude_ft) / 0.1
    now = moment(t_s)
    assert now.vvi_ft_min / 60 == pytest.approx(climbed_ft_s, abs=0.01)
    assert 44330 * (1 - (now.pressure_hpa / 1013.25) ** (1 / 5.25588)) == pytest.approx(now.altitude_m, abs=0.5)


@given(TIMES)
def test_bank_turn_rate_and_forces_are_of_one_coordinated_turn(t_s: float) -> None:
    now = moment(t_s)
    bank = math.radians(now.roll_deg)
    speed_m_s = SPEED_KT * 1852 / 3600
    assert math.tan(bank) == pytest.approx(speed_m_s**2 / (RADIUS_M * 9.80665))
    p, q, r = now.rates_rad_s
    assert math.sqrt(p * p + q * q + r * r) == pytest.approx(TURN_RATE_RAD_S)
    assert now.forces_m_s2[2] == pytest.approx(-9.80665 / math.cos(bank))
    assert math.hypot(*now.field) == pytest.approx(1.0)


def test_the_magnetic_field_points_north_and_down() -> None:
    east = moment(0.0)
    ahead, right, down = east.field
    assert east.heading_deg == pytest.approx(90.0)
    assert right < -0.5, "north is to the left of an aircraft that heads east"
    assert down > 0.5
    assert abs(ahead) < 0.1


@given(TIMES)
def test_the_next_waypoint_is_ahead_and_less_than_a_quarter_away(t_s: float) -> None:
    bearing_deg, distance_m, index = moment(t_s).to_waypoint()
    off_deg = (bearing_deg - moment(t_s).heading_deg + 180.0) % 360.0 - 180.0
    assert -0.01 <= off_deg <= 45.01
    assert distance_m <= RADIUS_M * math.sqrt(2) + 0.01
    assert 0 <= index < 4
    assert moment(t_s).to_waypoint(1)[2] == (index + 1) % 4


@given(TIMES)
def test_it_stays_on_its_circle_at_its_height_in_a_right_turn_with_its_nose_up(t_s: float) -> None:
    now = moment(t_s)
    north_m = (now.latitude_deg - CENTRE_LATITUDE_DEG) * M_PER_DEG
    east_m = (now.longitude_deg - CENTRE_LONGITUDE_DEG) * M_PER_DEG * math.cos(math.radians(CENTRE_LATITUDE_DEG))
    assert math.hypot(north_m, east_m) == pytest.approx(RADIUS_M, rel=1e-6)
    assert 920.0 <= now.altitude_ft <= 1080.0
    assert now.altitude_m == pytest.approx(now.altitude_ft * 0.3048)
    assert now.roll_deg == 10.0
    p, q, r = now.rates_rad_s
    assert q > 0.0
    assert r > 0.0
    assert math.copysign(1.0, p) == -math.copysign(1.0, now.pitch_deg)
    ahead, side, _ = now.forces_m_s2
    assert side == 0.0
    assert ahead == pytest.approx(9.80665 * math.sin(math.radians(now.pitch_deg)))
    assert now.pitot_pa == pytest.approx(0.5 * 1.225 * (SPEED_KT * 1852 / 3600) ** 2)


def test_the_field_is_seen_from_the_aircraft_as_it_is_banked_and_pitched() -> None:
    for t_s in (0.0, 10.0, 25.0, 40.0):
        now = moment(t_s)
        yaw, pitch, roll = (math.radians(angle) for angle in (now.heading_deg, now.pitch_deg, now.roll_deg))
        x, y, z = now.field
        y, z = y * math.cos(roll) - z * math.sin(roll), y * math.sin(roll) + z * math.cos(roll)
        x, z = x * math.cos(pitch) + z * math.sin(pitch), z * math.cos(pitch) - x * math.sin(pitch)
        north, east = x * math.cos(yaw) - y * math.sin(yaw), x * math.sin(yaw) + y * math.cos(yaw)
        dip = math.radians(38.0)
        assert (north, east, z) == pytest.approx((math.cos(dip), 0.0, math.sin(dip)), abs=1e-9)
