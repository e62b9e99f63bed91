"""Samples of the station -> MAVLink's messages. Each is made when a sample comes: nothing old is sent on."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, Final, TypeVar, cast

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
from epf_gcs.contract.status import Status
from epf_gcs.mavlink.choice import Aircraft, Home
from epf_gcs.mavlink.dialect import MAKE, WIRE, Message
from epf_gcs.units import m_from_ft, mps_from_kt

MANUAL, ASSISTED, AUTOPILOT = 0, 1, 2
MODE_NAMES: Final = {MANUAL: "Manual", ASSISTED: "Assisted", AUTOPILOT: "Autopilot"}
_MODE_FLAGS: Final = {
    MANUAL: WIRE.MAV_MODE_FLAG_MANUAL_INPUT_ENABLED,
    ASSISTED: WIRE.MAV_MODE_FLAG_MANUAL_INPUT_ENABLED | WIRE.MAV_MODE_FLAG_STABILIZE_ENABLED,
    AUTOPILOT: WIRE.MAV_MODE_FLAG_AUTO_ENABLED | WIRE.MAV_MODE_FLAG_GUIDED_ENABLED,
}
# Two topics are of one moment if they come this close together; the slowest comes once a second.
_TOGETHER_S: Final = 1.2
_MOST_CHANNELS: Final = 18
_UNUSED_CHANNEL: Final = 65535
_UNKNOWN_U8: Final = 255
_UNKNOWN_U16: Final = 65535
# A period is kept although samples come a little early.
_EARLY_S: Final = 0.01
TopicT = TypeVar("TopicT", bound=Topic)


class AircraftState:
    """What was heard of one of the board's two aircraft: the real one (`flight`) or the simulator's (`hil`).

    `begun_s` is Unix time, from which the messages count. Without a home heights above home are above the sea.
    """

    def __init__(self, aircraft: Aircraft, home: Home | None, begun_s: float) -> None:
        self.aircraft = aircraft
        self.home = home
        self.item_of: Callable[[int], int] = lambda waypoint: waypoint
        self._begun_s = begun_s
        self._newest: dict[type[Topic], Sample[Any]] = {}
        self._made_s: dict[str, float] = {}
        self._rows = _FLIGHT_ROWS if aircraft == "flight" else _HIL_ROWS

    @property
    def topics(self) -> frozenset[type[Topic]]:
        """The topics that it is told of."""
        beside = (topic for row in self._rows for topic in row.beside)
        return frozenset({Heartbeat, *(row.topic for row in self._rows), *beside})

    def take(self, sample: Sample[Any]) -> Iterator[Message]:
        """A sample came: the messages that are due with it."""
        topic = type(sample.values)
        self._newest[topic] = sample
        for row in self._rows:
            if row.topic is not topic or sample.t_s - self._made_s.get(row.name, -math.inf) < row.period_s - _EARLY_S:
                continue
            message = row.make(self, sample.values, round((sample.t_s - self._begun_s) * 1e3) % 2**32)
            if message is not None:
                self._made_s[row.name] = sample.t_s
                yield message

    def forget(self) -> None:
        """The line was closed: nothing that was heard is live."""
        self._newest.clear()

    def near(self, topic: type[TopicT], t_s: float) -> TopicT | None:
        """A topic's values if they are of about this moment."""
        sample = self._newest.get(topic)
        return None if sample is None or abs(sample.t_s - t_s) > _TOGETHER_S else cast(TopicT, sample.values)

    def mode(self, status: Status) -> int | None:
        """MANUAL, ASSISTED or AUTOPILOT; None while the board has not said."""
        sample = self._newest.get(Heartbeat)
        if sample is None:
            return None
        if self.aircraft == "flight":
            return AUTOPILOT if sample.values.autopilot else MANUAL
        if status.hil.path == "manual":
            return MANUAL
        return AUTOPILOT if sample.values.autopilot_hil else ASSISTED

    def heartbeat(self, mode: int) -> Message:
        """That it is there. The board has no arming: its motor can always run."""
        flags = WIRE.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED | WIRE.MAV_MODE_FLAG_SAFETY_ARMED | _MODE_FLAGS[mode]
        if self.aircraft == "hil":
            flags |= WIRE.MAV_MODE_FLAG_HIL_ENABLED
        return MAKE.heartbeat_encode(
            WIRE.MAV_TYPE_FIXED_WING, WIRE.MAV_AUTOPILOT_GENERIC, flags, mode, WIRE.MAV_STATE_ACTIVE
        )

    def home_position(self) -> Message | None:
        """Where heights above home begin, if a person said so."""
        if self.home is None:
            return None
        place = (round(self.home.latitude_deg * 1e7), round(self.home.longitude_deg * 1e7))
        return MAKE.home_position_encode(*place, round(self.home.altitude_m * 1e3), 0, 0, 0, [1, 0, 0, 0], 0, 0, 0)

    def seen_s(self, topic: type[Topic]) -> float:
        """When a topic was heard last."""
        return self._newest[topic].t_s


# ---- what the messages are made of: each from the sample that makes it due, and others of the same moment ----------


def _attitude(state: AircraftState, values: Ahrs, boot_ms: int) -> Message | None:
    rates = state.near(Inertial, state.seen_s(Ahrs)) or Inertial()
    return _attitude_of(boot_ms, (values.roll_deg, values.pitch_deg, values.yaw_deg), _rates(rates))


def _hil_attitude(state: AircraftState, values: Simulator, boot_ms: int) -> Message | None:
    rates = (values.p_rad_s, values.q_rad_s, values.r_rad_s)
    return _attitude_of(boot_ms, (values.roll_deg, values.pitch_deg, values.true_heading_deg), rates)


def _rates(values: Inertial) -> tuple[float | None, float | None, float | None]:
    return values.gx_rad_s, values.gy_rad_s, values.gz_rad_s


def _attitude_of(
    boot_ms: int, angles_deg: tuple[float | None, ...], rates_rad_s: tuple[float | None, ...]
) -> Message | None:
    if any(angle is None for angle in angles_deg):
        return None
    roll, pitch, yaw = (math.radians(cast(float, angle)) for angle in angles_deg)
    return MAKE.attitude_encode(boot_ms, roll, pitch, math.remainder(yaw, math.tau), *map(_or_nan, rates_rad_s))


def _position(state: AircraftState, values: Gps, boot_ms: int) -> Message | None:
    if not values.valid or values.altitude_m is None:
        return None
    place = (values.latitude_deg, values.longitude_deg)
    return _position_of(state, boot_ms, place, values.altitude_m, (values.speed_kt, values.heading_deg), None)


def _hil_position(state: AircraftState, values: Simulator, boot_ms: int) -> Message | None:
    if values.altitude_msl_ft is None:
        return None
    place = (values.latitude_deg, values.longitude_deg)
    motion = (values.ground_speed_kt, values.horizontal_path_deg)
    return _position_of(state, boot_ms, place, m_from_ft(values.altitude_msl_ft), motion, values)


def _position_of(
    state: AircraftState,
    boot_ms: int,
    place_deg: tuple[float | None, float | None],
    altitude_m: float,
    motion: tuple[float | None, float | None],
    simulator: Simulator | None,
) -> Message | None:
    latitude_deg, longitude_deg = place_deg
    if latitude_deg is None or longitude_deg is None:
        return None
    speed_kt, track_deg = motion
    north_m_s = east_m_s = down_m_s = 0.0
    if speed_kt is not None and track_deg is not None:
        speed_m_s = mps_from_kt(speed_kt)
        north_m_s = speed_m_s * math.cos(math.radians(track_deg))
        east_m_s = speed_m_s * math.sin(math.radians(track_deg))
    heading = _UNKNOWN_U16
    if simulator is not None:
        down_m_s = -m_from_ft(simulator.vvi_ft_min or 0.0) / 60.0
        heading = _centidegrees(simulator.true_heading_deg)
    elif (attitude := state.near(Ahrs, state.seen_s(Gps))) is not None:
        heading = _centidegrees(attitude.yaw_deg)
    home_m = 0.0 if state.home is None else state.home.altitude_m
    height = (round(altitude_m * 1e3), round((altitude_m - home_m) * 1e3))
    velocity = (round(north_m_s * 100), round(east_m_s * 100), round(down_m_s * 100))
    return MAKE.global_position_int_encode(
        boot_ms, round(latitude_deg * 1e7), round(longitude_deg * 1e7), *height, *velocity, heading
    )


def _gps(state: AircraftState, values: Gps, boot_ms: int) -> Message | None:
    has_fix = bool(values.valid) and values.latitude_deg is not None and values.longitude_deg is not None
    kind = WIRE.GPS_FIX_TYPE_3D_FIX if has_fix else WIRE.GPS_FIX_TYPE_NO_FIX
    place = (0, 0, 0)
    if has_fix:
        latitude_deg, longitude_deg = cast(float, values.latitude_deg), cast(float, values.longitude_deg)
        place = (round(latitude_deg * 1e7), round(longitude_deg * 1e7), round((values.altitude_m or 0.0) * 1e3))
    speed = _UNKNOWN_U16 if values.speed_kt is None else round(mps_from_kt(values.speed_kt) * 100)
    satellites = _UNKNOWN_U8 if values.satellites is None else values.satellites
    t_us = round(state.seen_s(Gps) * 1e6)
    unknown = (_UNKNOWN_U16, _UNKNOWN_U16)
    return MAKE.gps_raw_int_encode(t_us, kind, *place, *unknown, speed, _centidegrees(values.heading_deg), satellites)


def _hud(state: AircraftState, values: Analog, boot_ms: int) -> Message | None:
    t_s = state.seen_s(Analog)
    position, attitude, law = state.near(Gps, t_s) or Gps(), state.near(Ahrs, t_s) or Ahrs(), state.near(FlyByWire, t_s)
    return _hud_of(
        (values.calibrated_airspeed_kt, position.speed_kt),
        attitude.yaw_deg,
        None if law is None else law.throttle,
        values.altitude_m,
        values.vvi_ft_min,
    )


def _hil_hud(state: AircraftState, values: Simulator, boot_ms: int) -> Message | None:
    altitude_m = None if values.altitude_msl_ft is None else m_from_ft(values.altitude_msl_ft)
    speeds = (values.indicated_airspeed_kt, values.ground_speed_kt)
    return _hud_of(speeds, values.true_heading_deg, values.throttle_command, altitude_m, values.vvi_ft_min)


def _hud_of(
    speeds_kt: tuple[float | None, float | None],
    heading_deg: float | None,
    throttle: float | None,
    altitude_m: float | None,
    climb_ft_min: float | None,
) -> Message:
    air, ground = (math.nan if speed is None else mps_from_kt(speed) for speed in speeds_kt)
    climb = math.nan if climb_ft_min is None else m_from_ft(climb_ft_min) / 60.0
    heading = -1 if heading_deg is None else round(heading_deg) % 360
    power = 0 if throttle is None else round(max(0.0, min(1.0, throttle)) * 100)
    return MAKE.vfr_hud_encode(air, ground, heading, power, _or_nan(altitude_m), climb)


def _channels(state: AircraftState, values: ServosIn, boot_ms: int) -> Message:
    # Its four sticks and eight free channels; the third is the throttle, of which the useful half is 0..1.
    ours = [getattr(values, f"channel_{number}") for number in range(12)]
    widths = [_pulse_us(value, is_throttle=number == 2) for number, value in enumerate(ours)]
    unused = [_UNUSED_CHANNEL] * (_MOST_CHANNELS - len(widths))
    return MAKE.rc_channels_encode(boot_ms, len(widths), *widths, *unused, _UNKNOWN_U8)


def _servos(state: AircraftState, values: FlyByWire, boot_ms: int) -> Message:
    return _servos_of(state.seen_s(FlyByWire), (values.aileron, values.elevator, values.throttle, values.rudder))


def _hil_servos(state: AircraftState, values: HilSurfaces, boot_ms: int) -> Message:
    return _servos_of(state.seen_s(HilSurfaces), (values.aileron, values.elevator, values.throttle, values.rudder))


def _servos_of(t_s: float, controls: tuple[float | None, ...]) -> Message:
    widths = [_pulse_us(value, is_throttle=number == 2) for number, value in enumerate(controls)]
    return MAKE.servo_output_raw_encode(round(t_s * 1e6) % 2**32, 0, *widths, 0, 0, 0, 0)


def _guidance(state: AircraftState, values: FmsPlan | FmsHilPlan, boot_ms: int) -> Message | None:
    if values.bearing_deg is None or values.distance_m is None:
        return None
    t_s = state.seen_s(type(values))
    air = state.near(Analog, t_s) or Analog()
    altitude_m, speed_kt = air.altitude_m, air.calibrated_airspeed_kt
    if state.aircraft == "hil":
        told = state.near(XplaneInfo, t_s) or XplaneInfo()
        altitude_m = None if told.altitude_ft is None else m_from_ft(told.altitude_ft)
        speed_kt = told.speed_kt
    altitude_error, speed_error = math.nan, math.nan
    if values.altitude_ft is not None and altitude_m is not None:
        altitude_error = m_from_ft(values.altitude_ft) - altitude_m
    if values.speed_kt is not None and speed_kt is not None:
        speed_error = mps_from_kt(values.speed_kt - speed_kt)
    bearing, distance = round(math.remainder(values.bearing_deg, 360.0)), min(values.distance_m, _UNKNOWN_U16)
    # What the law asks for in bank and pitch, and the distance from the leg, are not among the board's streams.
    nan = math.nan
    return MAKE.nav_controller_output_encode(nan, nan, bearing, bearing, distance, altitude_error, speed_error, nan)


def _waypoint(state: AircraftState, values: FmsPlan | FmsHilPlan, boot_ms: int) -> Message | None:
    return None if values.waypoint is None else MAKE.mission_current_encode(state.item_of(values.waypoint))


def _system(state: AircraftState, values: Analog, boot_ms: int) -> Message:
    voltage = _UNKNOWN_U16 if values.battery_v is None else round(values.battery_v * 1e3)
    load = state.near(Statistics, state.seen_s(Analog)) or Statistics()
    per_mille = (load.control_dsc_percent or 0) * 10
    return MAKE.sys_status_encode(0, 0, 0, per_mille, voltage, -1, -1, 0, 0, 0, 0, 0, 0)


def _pulse_us(value: float | None, *, is_throttle: bool) -> int:
    """A control as the width of a servo's pulse: 1000 to 2000 us, 0 for no data."""
    if value is None:
        return 0
    return round(1000 + 1000 * value) if is_throttle else round(1500 + 500 * value)


def _centidegrees(angle_deg: float | None) -> int:
    return _UNKNOWN_U16 if angle_deg is None else round(angle_deg * 100) % 36000


def _or_nan(value: float | None) -> float:
    return math.nan if value is None else value


@dataclass(frozen=True, slots=True)
class _Row:
    """A message, the topic whose samples make it, how often at most, and the topics of the same moment that it has."""

    name: str
    topic: type[Topic]
    period_s: float
    make: Callable[[AircraftState, Any, int], Message | None]
    beside: tuple[type[Topic], ...] = ()


def _guided_by(plan: type[Topic], *beside: type[Topic]) -> tuple[_Row, ...]:
    """What both aircraft are told alike, with the plan of one of them."""
    return (
        _Row("SYS_STATUS", Analog, 1.0, _system, (Statistics,)),
        _Row("RC_CHANNELS", ServosIn, 0.2, _channels),
        _Row("NAV_CONTROLLER_OUTPUT", plan, 0.2, _guidance, beside),
        _Row("MISSION_CURRENT", plan, 0.5, _waypoint),
    )


_FLIGHT_ROWS: Final = (
    _Row("ATTITUDE", Ahrs, 0.05, _attitude, (Inertial,)),
    _Row("GLOBAL_POSITION_INT", Gps, 0.1, _position, (Ahrs,)),
    _Row("GPS_RAW_INT", Gps, 0.2, _gps),
    _Row("VFR_HUD", Analog, 0.1, _hud, (Gps, Ahrs, FlyByWire)),
    _Row("SERVO_OUTPUT_RAW", FlyByWire, 0.2, _servos),
    *_guided_by(FmsPlan, Analog),
)
_HIL_ROWS: Final = (
    _Row("ATTITUDE", Simulator, 0.05, _hil_attitude),
    _Row("GLOBAL_POSITION_INT", Simulator, 0.1, _hil_position),
    _Row("VFR_HUD", Simulator, 0.1, _hil_hud),
    _Row("SERVO_OUTPUT_RAW", HilSurfaces, 0.2, _hil_servos),
    *_guided_by(FmsHilPlan, XplaneInfo),
)
