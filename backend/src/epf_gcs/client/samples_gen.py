# Made by protocol/generator (emit_python_samples.py). Do not edit: change protocol/definition and run `make generate`.
"""The values of each topic of the stream, by name, with unit and sign."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar


class Topic:
    """The base of the values of every topic; None is "no data". NAME is its name on the stream."""

    __slots__ = ()
    NAME: ClassVar[str]


@dataclass(frozen=True, slots=True)
class Heartbeat(Topic):
    """State of the streams and of the autopilots. Always sent in binary mode, at the parameter task's rate."""

    NAME = "heartbeat"
    autopilot: bool | None = None
    """Autopilot of the real aircraft is on."""
    autotrim: bool | None = None
    """Elevator autotrim of the real aircraft is on."""
    auto_switch: bool | None = None
    """The transmitter's 'automatic' switch is on."""
    servos: bool | None = None
    """Stream servos_in is on."""
    gps: bool | None = None
    """Stream gps is on."""
    statistics: bool | None = None
    """Stream statistics is on."""
    ahrs: bool | None = None
    """Stream ahrs is on."""
    inertial: bool | None = None
    """Stream inertial is on."""
    analog: bool | None = None
    """Stream analog is on."""
    fly_by_wire: bool | None = None
    """Stream fly_by_wire is on."""
    autopilot_hil: bool | None = None
    """Autopilot of the HIL aircraft is on."""
    source_joystick: bool | None = None
    """Control source is the joystick; otherwise the RC transmitter."""
    autotrim_hil: bool | None = None
    """Elevator autotrim of the HIL aircraft is on."""


@dataclass(frozen=True, slots=True)
class Ahrs(Topic):
    """Attitude estimate of the airframe relative to local north-east-down."""

    NAME = "ahrs"
    yaw_deg: float | None = None
    """Heading; boards send 0..360 or -180..180. Shown as 0..360. In deg. Positive: clockwise from north, seen from
    above."""
    pitch_deg: float | None = None
    """Pitch angle. In deg. Positive: nose up."""
    roll_deg: float | None = None
    """Roll angle. In deg. Positive: right wing down."""


@dataclass(frozen=True, slots=True)
class Inertial(Topic):
    """Calibrated inertial sensors in body axes: x forward, y right, z down."""

    NAME = "inertial"
    gx_rad_s: float | None = None
    """Roll rate P. In rad/s. Positive: right wing going down."""
    gy_rad_s: float | None = None
    """Pitch rate Q. In rad/s. Positive: nose going up."""
    gz_rad_s: float | None = None
    """Yaw rate R. In rad/s. Positive: nose going right."""
    accx_m_s2: float | None = None
    """Specific force along x. In m/s2. Positive: forward."""
    accy_m_s2: float | None = None
    """Specific force along y. In m/s2. Positive: right."""
    accz_m_s2: float | None = None
    """Specific force along z. In m/s2. Positive: down; level flight gives -9.81."""
    magx: float | None = None
    """Magnetic field along x, normalised to the calibration sphere. Positive: forward."""
    magy: float | None = None
    """Magnetic field along y, normalised to the calibration sphere. Positive: right."""
    magz: float | None = None
    """Magnetic field along z, normalised to the calibration sphere. Positive: down."""


@dataclass(frozen=True, slots=True)
class Analog(Topic):
    """Analog sensors and air data. A value that the board does not measure is NaN: valid, shown as "no data"."""

    NAME = "analog"
    baro_hpa: float | None = None
    """Static pressure. In hPa."""
    altitude_m: float | None = None
    """Barometric altitude above mean sea level. In m. Positive: up."""
    altitude_external_m: float | None = None
    """Altitude of the external sensor. In m. Positive: up."""
    pitot_pa: float | None = None
    """Differential pressure of the Pitot tube; noise makes it slightly negative at rest. In Pa. Positive: total above
    static."""
    calibrated_airspeed_kt: float | None = None
    """Calibrated airspeed; sensor noise makes it slightly negative at rest. In kt. Positive: forward."""
    alpha_deg: float | None = None
    """Angle of attack. In deg. Positive: air from below."""
    beta_deg: float | None = None
    """Side-slip angle. In deg. Positive: air from the right."""
    temperature_degc: float | None = None
    """Temperature at the board. In degC. Positive: above freezing."""
    battery_v: float | None = None
    """Battery voltage. In V."""
    vvi_ft_min: float | None = None
    """Vertical speed. In ft/min. Positive: climb."""


@dataclass(frozen=True, slots=True)
class ServosIn(Topic):
    """Channels of the RC receiver: 0 aileron, 1 elevator, 2 throttle, 3 rudder, the rest free."""

    NAME = "servos_in"
    channel_0: float | None = None
    """Position of the channel; throttle is 0..1 of its useful half. Positive: stick right, back, full power or right
    pedal."""
    channel_1: float | None = None
    """Position of the channel; throttle is 0..1 of its useful half. Positive: stick right, back, full power or right
    pedal."""
    channel_2: float | None = None
    """Position of the channel; throttle is 0..1 of its useful half. Positive: stick right, back, full power or right
    pedal."""
    channel_3: float | None = None
    """Position of the channel; throttle is 0..1 of its useful half. Positive: stick right, back, full power or right
    pedal."""
    channel_4: float | None = None
    """Position of the channel; throttle is 0..1 of its useful half. Positive: stick right, back, full power or right
    pedal."""
    channel_5: float | None = None
    """Position of the channel; throttle is 0..1 of its useful half. Positive: stick right, back, full power or right
    pedal."""
    channel_6: float | None = None
    """Position of the channel; throttle is 0..1 of its useful half. Positive: stick right, back, full power or right
    pedal."""
    channel_7: float | None = None
    """Position of the channel; throttle is 0..1 of its useful half. Positive: stick right, back, full power or right
    pedal."""
    channel_8: float | None = None
    """Position of the channel; throttle is 0..1 of its useful half. Positive: stick right, back, full power or right
    pedal."""
    channel_9: float | None = None
    """Position of the channel; throttle is 0..1 of its useful half. Positive: stick right, back, full power or right
    pedal."""
    channel_10: float | None = None
    """Position of the channel; throttle is 0..1 of its useful half. Positive: stick right, back, full power or right
    pedal."""
    channel_11: float | None = None
    """Position of the channel; throttle is 0..1 of its useful half. Positive: stick right, back, full power or right
    pedal."""


@dataclass(frozen=True, slots=True)
class FlyByWire(Topic):
    """The four controls as the fly-by-wire law puts them out. Mind the order: throttle is second."""

    NAME = "fly_by_wire"
    aileron: float | None = None
    """Aileron deflection. Positive: right wing down."""
    throttle: float | None = None
    """Throttle; the deployed board's field is -1..+1, a throttle uses 0..1 of it. Positive: more power."""
    elevator: float | None = None
    """Elevator deflection. Positive: nose up."""
    rudder: float | None = None
    """Rudder deflection. Positive: nose right."""


@dataclass(frozen=True, slots=True)
class FmsPlan(Topic):
    """What the flight management system of the real aircraft asks for. Without a plan all of it is absent, without a
    position bearing and distance are."""

    NAME = "fms_plan"
    bearing_deg: float | None = None
    """Great-circle bearing to the waypoint. Shown as 0..360. In deg. Positive: clockwise from north, seen from
    above."""
    altitude_ft: float | None = None
    """Altitude asked for, above mean sea level. In ft. Positive: up."""
    speed_kt: float | None = None
    """Indicated airspeed asked for. In kt. Positive: forward."""
    distance_m: int | None = None
    """Great-circle distance to the waypoint; the limit is half way round the earth. In m."""
    waypoint: int | None = None
    """Index of the waypoint, from 0."""


@dataclass(frozen=True, slots=True)
class FmsHilPlan(Topic):
    """What the flight management system of the HIL aircraft asks for; fields as fms_plan."""

    NAME = "fms_hil_plan"
    bearing_deg: float | None = None
    """Great-circle bearing to the waypoint. Shown as 0..360. In deg. Positive: clockwise from north, seen from
    above."""
    altitude_ft: float | None = None
    """Altitude asked for, above mean sea level. In ft. Positive: up."""
    speed_kt: float | None = None
    """Indicated airspeed asked for. In kt. Positive: forward."""
    distance_m: int | None = None
    """Great-circle distance to the waypoint; the limit is half way round the earth. In m."""
    waypoint: int | None = None
    """Index of the waypoint, from 0."""


@dataclass(frozen=True, slots=True)
class Statistics(Topic):
    """Load of the board's two processors."""

    NAME = "statistics"
    sensor_dsc_percent: int | None = None
    """CPU load of the sensor processor. In %."""
    control_dsc_percent: int | None = None
    """CPU load of the control processor. In %."""


@dataclass(frozen=True, slots=True)
class Gps(Topic):
    """Position of the GPS receiver. Single precision resolves 1-2 m: the board's limit."""

    NAME = "gps"
    latitude_deg: float | None = None
    """Geodetic latitude, WGS84. In deg. Positive: north."""
    longitude_deg: float | None = None
    """Longitude, WGS84. In deg. Positive: east."""
    altitude_m: float | None = None
    """Altitude above mean sea level. In m. Positive: up."""
    speed_kt: float | None = None
    """Ground speed. In kt."""
    heading_deg: float | None = None
    """Ground track. Shown as 0..360. In deg. Positive: clockwise from north, seen from above."""
    satellites: int | None = None
    """Satellites used: ASCII digits as received, units in the low byte, tens in the next ('8' is 0x38, '12' is
    0x3132)."""
    fix: int | None = None
    """Kind of position fix: an ASCII digit, '0' for none."""
    valid: bool | None = None
    """Receiver status: ASCII 'A' valid, 'V' void."""


@dataclass(frozen=True, slots=True)
class HilSurfaces(Topic):
    """What the board wants the simulator's surfaces to be."""

    NAME = "hil_surfaces"
    elevator: float | None = None
    """Elevator deflection. Positive: nose up."""
    aileron: float | None = None
    """Aileron deflection. Positive: right wing down."""
    rudder: float | None = None
    """Rudder deflection. Positive: nose right."""
    throttle: float | None = None
    """Throttle. Positive: more power."""


@dataclass(frozen=True, slots=True)
class AutopilotParameters(Topic):
    """The 17 gains, in answer to load_autopilot_parameters. One of them is an integer."""

    NAME = "autopilot_parameters"
    k_int_altura: float | None = None
    """Integral gain of the altitude loop, per second, times k_altura."""
    k_altura: float | None = None
    """Pitch asked for, deg, for each foot of altitude error."""
    k_VVI: float | None = None
    """Altitude lead, ft, for each ft/min of vertical speed."""
    k_pitch: float | None = None
    """Elevator command for each radian of pitch error."""
    k_heading: float | None = None
    """Roll asked for, deg, for each degree of track error."""
    k_roll: float | None = None
    """Aileron command for each radian of roll error."""
    k_div_velocidad: int | None = None
    """Airspeed error times seconds, kt s, for full throttle travel; an integer on the wire."""
    k_div_P_init: float | None = None
    """Divider of the roll rate at rest."""
    k_div_P_speed: float | None = None
    """Airspeed, kt, which adds 1 to the roll-rate divider."""
    k_div_Q_init: float | None = None
    """Divider of the pitch rate at rest."""
    k_div_Q_speed: float | None = None
    """Airspeed, kt, which adds 1 to the pitch-rate divider."""
    k_div_R_init: float | None = None
    """Divider of the yaw rate at rest."""
    k_div_R_speed: float | None = None
    """Airspeed, kt, which adds 1 to the yaw-rate divider."""
    k_int_pitch: float | None = None
    """Autotrim: integral gain of the pitch-rate loop, per second."""
    k_elev: float | None = None
    """Proportional gain of the pitch-rate loop."""
    k_airln: float | None = None
    """Gain of the roll-rate loop."""
    k_rudder: float | None = None
    """Gain of the yaw-rate loop."""


@dataclass(frozen=True, slots=True)
class BoardStatus(Topic):
    """State that the heartbeat has no room for; once a second."""

    NAME = "board_status"
    airspeed_source: int | None = None
    """Where the airspeed comes from."""
    altitude_source: int | None = None
    """Where the altitude comes from."""
    servos_control_mode: int | None = None
    """What drives the servo outputs."""
    hil_plan_name: int | None = None
    """Which of the four routes the HIL plan is; none for an uploaded or absent plan."""
    frames_received: int | None = None
    """Good frames since the start of the board."""
    frames_rejected: int | None = None
    """Refused frames since the start of the board."""


@dataclass(frozen=True, slots=True)
class XplaneInfo(Topic):
    """The simulator's state for the HIL loop; answered by hil_surfaces, never acknowledged."""

    NAME = "xplane_info"
    elevator: float | None = None
    """The pilot's stick. Positive: nose up."""
    aileron: float | None = None
    """The pilot's stick. Positive: right wing down."""
    rudder: float | None = None
    """The pilot's pedals. Positive: nose right."""
    throttle: float | None = None
    """The pilot's throttle. Positive: more power."""
    gx_rad_s: float | None = None
    """Roll rate P, body axes. In rad/s. Positive: right wing going down."""
    gy_rad_s: float | None = None
    """Pitch rate Q, body axes. In rad/s. Positive: nose going up."""
    gz_rad_s: float | None = None
    """Yaw rate R, body axes. In rad/s. Positive: nose going right."""
    yaw_deg: float | None = None
    """Ground track where the simulator gives it, else true heading. In deg. Positive: clockwise from north, seen from
    above."""
    pitch_deg: float | None = None
    """Pitch angle. In deg. Positive: nose up."""
    roll_deg: float | None = None
    """Roll angle. In deg. Positive: right wing down."""
    altitude_ft: float | None = None
    """Indicated altitude. In ft. Positive: up."""
    vvi_ft_min: float | None = None
    """Vertical speed. In ft/min. Positive: climb."""
    speed_kt: float | None = None
    """Indicated airspeed. In kt. Positive: forward."""
    latitude_deg: float | None = None
    """Geodetic latitude. In deg. Positive: north."""
    longitude_deg: float | None = None
    """Longitude. In deg. Positive: east."""


@dataclass(frozen=True, slots=True)
class Simulator(Topic):
    """What the simulator says, by name; None until its row has arrived."""

    NAME = "simulator"
    indicated_airspeed_kt: float | None = None
    """Indicated airspeed. In kt. Positive: forward."""
    ground_speed_kt: float | None = None
    """Speed over ground. Only the simulator's pace is judged by it: it may be absent. In kt. Positive: forward."""
    mach: float | None = None
    """Mach number. Positive: forward."""
    vvi_ft_min: float | None = None
    """Vertical speed. In ft/min. Positive: climb."""
    g_normal: float | None = None
    """Normal load factor. Positive: up; level flight gives 1."""
    g_axial: float | None = None
    """Axial load factor. Positive: forward."""
    g_side: float | None = None
    """Side load factor. Positive: right."""
    ambient_pressure_inhg: float | None = None
    """Ambient pressure. In inHg."""
    ambient_temperature_degc: float | None = None
    """Ambient temperature. In degC. Positive: above freezing."""
    stick_elevator: float | None = None
    """Stick, fore and aft. Positive: nose up."""
    stick_aileron: float | None = None
    """Stick, sideways. Positive: right wing down."""
    stick_rudder: float | None = None
    """Pedals. Positive: nose right."""
    surface_elevator: float | None = None
    """Elevator. Positive: nose up."""
    surface_aileron: float | None = None
    """Aileron. Positive: right wing down."""
    surface_rudder: float | None = None
    """Rudder. Positive: nose right."""
    q_rad_s: float | None = None
    """Pitch rate Q. In rad/s. Positive: nose going up."""
    p_rad_s: float | None = None
    """Roll rate P. In rad/s. Positive: right wing going down."""
    r_rad_s: float | None = None
    """Yaw rate R. In rad/s. Positive: nose going right."""
    pitch_deg: float | None = None
    """Pitch angle. In deg. Positive: nose up."""
    roll_deg: float | None = None
    """Roll angle. In deg. Positive: right wing down."""
    true_heading_deg: float | None = None
    """True heading. In deg. Positive: clockwise from north, seen from above."""
    alpha_deg: float | None = None
    """Angle of attack. In deg. Positive: air from below."""
    beta_deg: float | None = None
    """Side-slip angle. In deg. Positive: air from the right."""
    horizontal_path_deg: float | None = None
    """Ground track. In deg. Positive: clockwise from north, seen from above."""
    vertical_path_deg: float | None = None
    """Vertical path angle. In deg. Positive: climb."""
    latitude_deg: float | None = None
    """Geodetic latitude. In deg. Positive: north."""
    longitude_deg: float | None = None
    """Longitude. In deg. Positive: east."""
    altitude_msl_ft: float | None = None
    """True altitude above mean sea level. In ft. Positive: up."""
    altitude_indicated_ft: float | None = None
    """Indicated altitude. In ft. Positive: up."""
    throttle_command: float | None = None
    """Throttle command. Positive: more power."""
