"""What the board's samples say is what MAVLink's messages say, within their resolution; what is unknown stays so."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pytest

from epf_gcs.client import (
    Ahrs,
    Analog,
    FlyByWire,
    FmsHilPlan,
    FmsPlan,
    Gps,
    Heartbeat,
    HilSurfaces,
    Inertial,
    Sample,
    ServosIn,
    Simulator,
    Statistics,
    Topic,
    XplaneInfo,
)
from epf_gcs.contract.status import HilState, Status
from epf_gcs.mavlink.aircraft import ASSISTED, AUTOPILOT, MANUAL, AircraftState
from epf_gcs.mavlink.choice import Aircraft, Home
from epf_gcs.mavlink.dialect import WIRE

BEGUN_S = 1000.0
GANDO: dict[str, Any] = {"latitude_deg": 27.9311, "longitude_deg": -15.3865}


def told(*values: Topic, aircraft: Aircraft = "flight", home: Home | None = None, at_s: float = 2.0) -> dict[str, Any]:
    """The messages of samples that come at one moment, by name."""
    state = AircraftState(aircraft, home, BEGUN_S)
    made = [message for one in values for message in state.take(Sample(BEGUN_S + at_s, one))]
    return {message.get_type(): message for message in made}


def test_the_attitude_has_the_rates_of_the_same_moment() -> None:
    rates = Inertial(gx_rad_s=0.1, gy_rad_s=-0.2, gz_rad_s=0.3)
    attitude = told(rates, Ahrs(yaw_deg=350.0, pitch_deg=5.0, roll_deg=-30.0))["ATTITUDE"]
    assert attitude.time_boot_ms == 2000
    assert [attitude.roll, attitude.pitch] == pytest.approx([math.radians(-30), math.radians(5)])
    assert attitude.yaw == pytest.approx(math.radians(-10))
    assert [attitude.rollspeed, attitude.pitchspeed, attitude.yawspeed] == pytest.approx([0.1, -0.2, 0.3])


def test_rates_that_nobody_sends_are_unknown_and_not_zero() -> None:
    attitude = told(Ahrs(yaw_deg=0.0, pitch_deg=0.0, roll_deg=0.0))["ATTITUDE"]
    assert math.isnan(attitude.rollspeed)


def test_rates_of_an_earlier_moment_are_not_sent_on() -> None:
    state = AircraftState("flight", None, BEGUN_S)
    assert list(state.take(Sample(BEGUN_S, Inertial(gx_rad_s=0.1, gy_rad_s=0.0, gz_rad_s=0.0)))) == []
    (attitude,) = state.take(Sample(BEGUN_S + 5.0, Ahrs(yaw_deg=0.0, pitch_deg=0.0, roll_deg=0.0)))
    assert math.isnan(attitude.rollspeed)


def test_a_position_has_both_heights_and_the_velocity_over_ground() -> None:
    gps = Gps(**GANDO, altitude_m=300.0, speed_kt=60.0, heading_deg=90.0, satellites=12, valid=True)
    messages = told(gps, home=Home(27.9, -15.4, 24.0))
    position = messages["GLOBAL_POSITION_INT"]
    assert (position.lat, position.lon) == (279311000, -153865000)
    assert (position.alt, position.relative_alt) == (300_000, 276_000)
    assert (position.vx, position.vy) == (0, round(60 * 1852 / 36))
    assert messages["GPS_RAW_INT"].satellites_visible == 12
    assert messages["GPS_RAW_INT"].fix_type == WIRE.GPS_FIX_TYPE_3D_FIX


def test_without_a_fix_there_is_no_position() -> None:
    messages = told(Gps(**GANDO, altitude_m=300.0, valid=False))
    assert "GLOBAL_POSITION_INT" not in messages
    assert (messages["GPS_RAW_INT"].fix_type, messages["GPS_RAW_INT"].lat) == (WIRE.GPS_FIX_TYPE_NO_FIX, 0)


def test_the_simulators_aircraft_is_told_from_the_simulator() -> None:
    simulator = Simulator(
        **GANDO, roll_deg=10.0, pitch_deg=-2.0, true_heading_deg=190.0, p_rad_s=0.0, q_rad_s=0.0, r_rad_s=0.5,
        altitude_msl_ft=1000.0, ground_speed_kt=50.0, horizontal_path_deg=180.0, vvi_ft_min=600.0,
        indicated_airspeed_kt=55.0, throttle_command=0.7,
    )  # fmt: skip
    messages = told(simulator, aircraft="hil")
    position, hud = messages["GLOBAL_POSITION_INT"], messages["VFR_HUD"]
    assert (position.alt, position.hdg, position.vz) == (304_800, 19_000, -305)
    assert (hud.heading, hud.throttle) == (190, 70)
    assert [hud.airspeed, hud.groundspeed, hud.climb] == pytest.approx([28.294, 25.722, 3.048], abs=1e-3)
    assert messages["ATTITUDE"].yaw == pytest.approx(math.radians(190 - 360))
    assert "ATTITUDE" not in told(simulator)


def test_controls_are_pulses() -> None:
    channels = told(ServosIn(channel_0=-1.0, channel_1=0.0, channel_2=0.25, channel_3=1.0))["RC_CHANNELS"]
    assert [channels.chan1_raw, channels.chan2_raw, channels.chan3_raw, channels.chan4_raw] == [1000, 1500, 1250, 2000]
    assert (channels.chancount, channels.chan5_raw, channels.chan13_raw) == (12, 0, 65535)
    surfaces = HilSurfaces(elevator=0.5, aileron=-0.5, rudder=0.0, throttle=1.0)
    servos = told(surfaces, aircraft="hil")["SERVO_OUTPUT_RAW"]
    assert [servos.servo1_raw, servos.servo2_raw, servos.servo3_raw, servos.servo4_raw] == [1250, 1750, 2000, 1500]


REAL_AIR = Analog(altitude_m=290.0, calibrated_airspeed_kt=58.0)
HIL_AIR = XplaneInfo(altitude_ft=951.443570, speed_kt=58.0)


@pytest.mark.parametrize(("aircraft", "air", "plan"), [("flight", REAL_AIR, FmsPlan), ("hil", HIL_AIR, FmsHilPlan)])
def test_guidance_has_the_errors_of_altitude_and_speed(
    aircraft: Aircraft, air: Topic, plan: Callable[..., Topic]
) -> None:
    asked = plan(bearing_deg=270.0, altitude_ft=1000.0, speed_kt=60.0, distance_m=70_000, waypoint=3)
    messages = told(air, asked, aircraft=aircraft)
    guidance = messages["NAV_CONTROLLER_OUTPUT"]
    assert (guidance.target_bearing, guidance.wp_dist) == (-90, 65535)
    assert [guidance.alt_error, guidance.aspd_error] == pytest.approx([14.8, 2 * 1852 / 3600], abs=1e-3)
    assert math.isnan(guidance.xtrack_error)
    assert messages["MISSION_CURRENT"].seq == 3


def test_a_battery_that_is_not_measured_is_unknown() -> None:
    assert told(Analog())["SYS_STATUS"].voltage_battery == 65535
    messages = told(Statistics(control_dsc_percent=31), Analog(battery_v=11.1))
    assert (messages["SYS_STATUS"].voltage_battery, messages["SYS_STATUS"].load) == (11_100, 310)


def test_messages_come_no_faster_than_they_may() -> None:
    state = AircraftState("flight", None, BEGUN_S)
    made = [
        message.get_type()
        for step in range(100)
        for message in state.take(Sample(BEGUN_S + step * 0.02, Gps(**GANDO, altitude_m=1.0, valid=True)))
    ]
    assert (made.count("GLOBAL_POSITION_INT"), made.count("GPS_RAW_INT")) == (20, 10)


@pytest.mark.parametrize(
    ("aircraft", "path", "heartbeat", "mode"),
    [
        ("hil", "manual", Heartbeat(autopilot_hil=True), MANUAL),
        ("hil", "assisted", Heartbeat(autopilot_hil=False), ASSISTED),
        ("hil", "assisted", Heartbeat(autopilot_hil=True), AUTOPILOT),
        ("flight", "assisted", Heartbeat(autopilot=True, autopilot_hil=False), AUTOPILOT),
        ("flight", "assisted", Heartbeat(autopilot=False, autopilot_hil=True), MANUAL),
    ],
)
def test_the_mode_is_the_boards_own(aircraft: Aircraft, path: Any, heartbeat: Heartbeat, mode: int) -> None:
    state = AircraftState(aircraft, None, BEGUN_S)
    status = Status(hil=HilState(path=path))
    assert state.mode(status) is None
    assert list(state.take(Sample(BEGUN_S, heartbeat))) == []
    assert state.mode(status) == mode
    told_mode = state.heartbeat(mode)
    assert told_mode.custom_mode == mode
    assert bool(told_mode.base_mode & WIRE.MAV_MODE_FLAG_HIL_ENABLED) == (aircraft == "hil")
    state.forget()
    assert state.mode(status) is None


def test_it_listens_to_every_topic_that_a_message_is_made_of() -> None:
    made = {Ahrs, Analog, FlyByWire, FmsPlan, Gps, Heartbeat, Inertial, ServosIn, Statistics}
    assert AircraftState("flight", None, BEGUN_S).topics == made
    hil = {Analog, FmsHilPlan, Heartbeat, HilSurfaces, ServosIn, Simulator, Statistics, XplaneInfo}
    assert AircraftState("hil", None, BEGUN_S).topics == hil
