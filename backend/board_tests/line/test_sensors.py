"""What the sensors of a board without hardware measure: the simulator's aircraft, or one that stands on the runway."""

import math
from collections.abc import Callable

from board_tests.line.station import LEVEL_FLIGHT, Station
from epf_gcs.codec.values import meaning

STREAMS = ("ahrs", "inertial", "analog", "gps", "servos_in")
TILTED_S = 2.0
HEARTBEAT_S = 0.02
"""The board's own measure of time."""
Values = dict[str, float]


def readings(station: Station) -> Values:
    """The newest of all sensor streams, by name; every one of them plausible."""
    for stream in STREAMS:
        station.next(stream)
    found: Values = {}
    for stream in STREAMS:
        said = meaning(station.next(stream))
        assert said.implausible == ()
        found |= {
            f"{stream}.{name}": math.nan if value is None else float(value) for name, value in said.values.items()
        }
    return found


def start(station: Station) -> None:
    station.command("set_fms_task_rate", 50)
    for stream in STREAMS:
        station.command(f"{stream}_on")


def near(value: float, expected: float, tolerance: float) -> bool:
    return abs(value - expected) <= tolerance


def test_without_a_simulator_the_board_stands_on_the_runway(binary: Station) -> None:
    start(binary)
    seen = readings(binary)
    assert near(seen["gps.latitude_deg"], 27.9319, 0.001)
    assert near(seen["gps.longitude_deg"], -15.3866, 0.001)
    assert near(seen["gps.altitude_m"], 24, 15)
    assert near(seen["gps.speed_kt"], 0, 1.5)
    assert near(seen["ahrs.pitch_deg"], 0, 2)
    assert near(seen["ahrs.roll_deg"], 0, 2)
    assert near(seen["inertial.accz_m_s2"], -9.81, 0.5)
    assert near(seen["analog.baro_hpa"], 1010.4, 1)
    assert near(seen["analog.altitude_m"], 24, 10)
    assert near(seen["analog.calibrated_airspeed_kt"], 0, 8)
    assert 35 < seen["analog.battery_v"] < 43
    assert math.isnan(seen["analog.alpha_deg"])
    assert math.isnan(seen["analog.beta_deg"])
    assert all(near(seen[f"servos_in.channel_{channel}"], 0, 0.02) for channel in range(4))


def test_the_readings_move_a_little_as_real_ones_do(binary: Station) -> None:
    binary.command("start")
    binary.command("set_servos_task_rate", 20)
    binary.heartbeats(50)
    for stream in ("ahrs", "inertial", "analog"):
        seen = {frame.payload for frame in binary.frames if frame.message.name == stream}
        assert len(seen) > 20


def fly(station: Station, seconds: float) -> None:
    """Straight flight to the north-east for so long a time of the board. In the first two seconds it goes over to a
    steady slip with 20 deg of bank and the nose up by 5 deg, so that it may bank and not turn, at rates that its gyro
    feels: how a board follows a jump depends on how long it has been on.
    """
    roll_rate_rad_s, pitch_rate_rad_s = math.radians(20.0 / TILTED_S), math.radians(5.0 / TILTED_S)
    station.frames.clear()
    t_s = 0.0
    while t_s < seconds:
        share, moves = min(1.0, t_s / TILTED_S), t_s < TILTED_S
        roll_rad = math.radians(20.0 * share)
        values = list(LEVEL_FLIGHT)
        values[4] = roll_rate_rad_s * moves
        values[5] = pitch_rate_rad_s * math.cos(roll_rad) * moves
        values[6] = -pitch_rate_rad_s * math.sin(roll_rad) * moves
        values[8], values[9] = 5.0 * share, 20.0 * share
        way_m = t_s * 55 * 0.514444
        values[13] = 27.95 + way_m * math.cos(math.radians(28)) / 111195
        values[14] = -15.38 + way_m * math.sin(math.radians(28)) / 98300
        station.command("xplane_info", *values)
        station.wait(lambda: station.count("heartbeat") > 0)
        t_s += HEARTBEAT_S * station.count("heartbeat")
        station.frames.clear()


def test_with_a_simulator_the_sensors_measure_its_aircraft(binary: Station) -> None:
    start(binary)
    fly(binary, 6.0)
    seen = readings(binary)
    assert near(seen["ahrs.yaw_deg"], 28, 2)
    assert near(seen["ahrs.pitch_deg"], 5, 2)
    assert near(seen["ahrs.roll_deg"], 20, 2)
    assert near(seen["inertial.gx_rad_s"], 0.0, 0.05)
    # Level flight with wings banked: gravity is felt to the left and down in body axes.
    assert near(seen["inertial.accy_m_s2"], -9.81 * math.cos(math.radians(5)) * math.sin(math.radians(20)), 0.5)
    assert near(seen["analog.altitude_m"], 304.8, 10)
    assert near(seen["analog.altitude_external_m"], 304.8, 10)
    assert near(seen["analog.baro_hpa"], 977.2, 1.5)
    assert near(seen["analog.calibrated_airspeed_kt"], 55, 3)
    assert near(seen["analog.pitot_pa"], 490, 40)
    assert near(seen["gps.latitude_deg"], 27.95, 0.002)
    assert near(seen["gps.altitude_m"], 304.8, 15)
    assert near(seen["gps.heading_deg"], 28, 20)
    assert seen["gps.valid"] == 1
    assert seen["gps.fix"] == 1
    assert 6 <= seen["gps.satellites"] <= 14
    field = [seen[f"inertial.mag{axis}"] for axis in "xyz"]
    assert near(math.hypot(*field), 1, 0.1)


def test_the_receiver_follows_the_pilot_s_stick(binary: Station) -> None:
    binary.command("servos_in_on")
    stick = (0.5, -0.25, 0.75, 0.4)  # elevator, aileron, rudder, throttle

    def follows() -> bool:
        binary.command("xplane_info", *stick, *LEVEL_FLIGHT[4:])
        channels = binary.next("servos_in").values
        wanted = (stick[1], stick[0], stick[3], stick[2])  # channels: aileron, elevator, throttle, rudder
        return all(near(channel, value, 0.02) for channel, value in zip(channels, wanted, strict=False))

    binary.wait(follows)
    assert all(position <= 0.02 for position in binary.next("servos_in").values[4:])


def test_gps_satellites_are_sent_as_the_receiver_s_digits(binary: Station) -> None:
    binary.command("gps_on")
    satellites, fix, status = binary.next("gps").values[5:]
    assert satellites in {ord("7"), ord("8"), ord("9"), *(0x3100 | ord(unit) for unit in "0123")}
    assert (fix, status) == (ord("1"), ord("A"))


def test_the_battery_goes_down_with_the_throttle(binary: Station) -> None:
    binary.command("control_source", 1)
    binary.command("analog_on")
    resting_v = binary.next("analog").values[8]

    def sags() -> bool:
        binary.command("xplane_info", 0.0, 0.0, 0.0, 1.0, *LEVEL_FLIGHT[4:])
        return bool(binary.next("analog").values[8] < resting_v - 1.0)

    binary.wait(sags)


def noise(station: Station) -> set[bytes]:
    """Readings of one run; which ones are sent depends on the moment, not what they are."""
    station.open_binary()
    station.command("set_parameter_task_rate", 20)
    station.command("inertial_on")
    station.heartbeats(60)
    return {frame.payload for frame in station.frames if frame.message.name == "inertial"}


def test_the_same_seed_gives_the_same_noise(plug: Callable[..., Station]) -> None:
    once = noise(plug("--seed", "7"))
    # On a busy computer two runs may not have sent a single reading of the same moment.
    assert any(once & noise(plug("--seed", "7")) for _ in range(10))
    assert once & noise(plug("--seed", "8")) == set()
