// Made by protocol/generator (emit_typescript.py). Do not edit: change protocol/definition and run `make generate`.

export interface FieldInfo {
  readonly kind: "number" | "integer" | "boolean" | "text";
  /** Unit of the value; "1" where it has none. */
  readonly unit: string;
  readonly minimum: number | null;
  readonly maximum: number | null;
  /** What a positive value means. */
  readonly sign: string;
  readonly doc: string;
  /** Meanings of an integer's values. */
  readonly names: Readonly<Record<string, number>>;
}

export interface CommandArgument {
  readonly name: string;
  readonly kind: "number" | "integer" | "boolean" | "text";
  readonly unit: string;
  readonly minimum: number | null;
  readonly maximum: number | null;
  readonly default: number | null;
  readonly names: Readonly<Record<string, number>>;
}

export interface CommandInfo {
  readonly id: number;
  readonly doc: string;
  readonly extension: boolean;
  readonly confirm: "none" | "heartbeat" | "frame" | "plan" | "read_back";
  readonly arguments: readonly CommandArgument[];
}

export interface ParameterInfo {
  readonly name: string;
  readonly group: "altitude" | "heading" | "rudder" | "speed";
  readonly setId: number;
  readonly isInteger: boolean;
  readonly default: number;
  readonly minimum: number;
  readonly maximum: number;
  readonly step: number;
  readonly doc: string;
}

export interface RouteWaypoint {
  readonly latitude_deg: number;
  readonly longitude_deg: number;
  readonly altitude_ft: number;
  readonly speed_kt: number;
}

export interface RouteInfo {
  readonly name: string;
  readonly title: string;
  readonly planName: number;
  readonly loop: boolean;
  readonly waypoints: readonly RouteWaypoint[];
}

export interface RowValueInfo {
  readonly index: number;
  readonly name: string;
  readonly unit: string;
  readonly doc: string;
}

export interface RowInfo {
  readonly id: number;
  readonly name: string;
  readonly doc: string;
  readonly sent: boolean;
  readonly values: readonly RowValueInfo[];
}

/** State of the streams and of the autopilots. Always sent in binary mode, at the parameter task's rate. */
export interface Heartbeat {
  /** Autopilot of the real aircraft is on. */
  readonly autopilot: boolean | null;
  /** Elevator autotrim of the real aircraft is on. */
  readonly autotrim: boolean | null;
  /** The transmitter's "automatic" switch is on. */
  readonly auto_switch: boolean | null;
  /** Stream servos_in is on. */
  readonly servos: boolean | null;
  /** Stream gps is on. */
  readonly gps: boolean | null;
  /** Stream statistics is on. */
  readonly statistics: boolean | null;
  /** Stream ahrs is on. */
  readonly ahrs: boolean | null;
  /** Stream inertial is on. */
  readonly inertial: boolean | null;
  /** Stream analog is on. */
  readonly analog: boolean | null;
  /** Stream fly_by_wire is on. */
  readonly fly_by_wire: boolean | null;
  /** Autopilot of the HIL aircraft is on. */
  readonly autopilot_hil: boolean | null;
  /** Control source is the joystick; otherwise the RC transmitter. */
  readonly source_joystick: boolean | null;
  /** Elevator autotrim of the HIL aircraft is on. */
  readonly autotrim_hil: boolean | null;
}

/** Attitude estimate of the airframe relative to local north-east-down. */
export interface Ahrs {
  /** Heading; boards send 0..360 or -180..180. Shown as 0..360. [deg] + clockwise from north, seen from above. */
  readonly yaw_deg: number | null;
  /** Pitch angle. [deg] + nose up. */
  readonly pitch_deg: number | null;
  /** Roll angle. [deg] + right wing down. */
  readonly roll_deg: number | null;
}

/** Calibrated inertial sensors in body axes: x forward, y right, z down. */
export interface Inertial {
  /** Roll rate P. [rad/s] + right wing going down. */
  readonly gx_rad_s: number | null;
  /** Pitch rate Q. [rad/s] + nose going up. */
  readonly gy_rad_s: number | null;
  /** Yaw rate R. [rad/s] + nose going right. */
  readonly gz_rad_s: number | null;
  /** Specific force along x. [m/s2] + forward. */
  readonly accx_m_s2: number | null;
  /** Specific force along y. [m/s2] + right. */
  readonly accy_m_s2: number | null;
  /** Specific force along z. [m/s2] + down; level flight gives -9.81. */
  readonly accz_m_s2: number | null;
  /** Magnetic field along x, normalised to the calibration sphere. + forward. */
  readonly magx: number | null;
  /** Magnetic field along y, normalised to the calibration sphere. + right. */
  readonly magy: number | null;
  /** Magnetic field along z, normalised to the calibration sphere. + down. */
  readonly magz: number | null;
}

/** Analog sensors and air data. A value that the board does not measure is NaN: valid, shown as "no data". */
export interface Analog {
  /** Static pressure. [hPa] */
  readonly baro_hpa: number | null;
  /** Barometric altitude above mean sea level. [m] + up. */
  readonly altitude_m: number | null;
  /** Altitude of the external sensor. [m] + up. */
  readonly altitude_external_m: number | null;
  /** Differential pressure of the Pitot tube; noise makes it slightly negative at rest. [Pa] + total above static. */
  readonly pitot_pa: number | null;
  /** Calibrated airspeed; sensor noise makes it slightly negative at rest. [kt] + forward. */
  readonly calibrated_airspeed_kt: number | null;
  /** Angle of attack. [deg] + air from below. */
  readonly alpha_deg: number | null;
  /** Side-slip angle. [deg] + air from the right. */
  readonly beta_deg: number | null;
  /** Temperature at the board. [degC] + above freezing. */
  readonly temperature_degc: number | null;
  /** Battery voltage. [V] */
  readonly battery_v: number | null;
  /** Vertical speed. [ft/min] + climb. */
  readonly vvi_ft_min: number | null;
}

/** Channels of the RC receiver: 0 aileron, 1 elevator, 2 throttle, 3 rudder, the rest free. */
export interface ServosIn {
  /** Position of the channel; throttle is 0..1 of its useful half. + stick right, back, full power or right pedal. */
  readonly channel_0: number | null;
  /** Position of the channel; throttle is 0..1 of its useful half. + stick right, back, full power or right pedal. */
  readonly channel_1: number | null;
  /** Position of the channel; throttle is 0..1 of its useful half. + stick right, back, full power or right pedal. */
  readonly channel_2: number | null;
  /** Position of the channel; throttle is 0..1 of its useful half. + stick right, back, full power or right pedal. */
  readonly channel_3: number | null;
  /** Position of the channel; throttle is 0..1 of its useful half. + stick right, back, full power or right pedal. */
  readonly channel_4: number | null;
  /** Position of the channel; throttle is 0..1 of its useful half. + stick right, back, full power or right pedal. */
  readonly channel_5: number | null;
  /** Position of the channel; throttle is 0..1 of its useful half. + stick right, back, full power or right pedal. */
  readonly channel_6: number | null;
  /** Position of the channel; throttle is 0..1 of its useful half. + stick right, back, full power or right pedal. */
  readonly channel_7: number | null;
  /** Position of the channel; throttle is 0..1 of its useful half. + stick right, back, full power or right pedal. */
  readonly channel_8: number | null;
  /** Position of the channel; throttle is 0..1 of its useful half. + stick right, back, full power or right pedal. */
  readonly channel_9: number | null;
  /** Position of the channel; throttle is 0..1 of its useful half. + stick right, back, full power or right pedal. */
  readonly channel_10: number | null;
  /** Position of the channel; throttle is 0..1 of its useful half. + stick right, back, full power or right pedal. */
  readonly channel_11: number | null;
}

/** The four controls as the fly-by-wire law puts them out. Mind the order: throttle is second. */
export interface FlyByWire {
  /** Aileron deflection. + right wing down. */
  readonly aileron: number | null;
  /** Throttle; the deployed board's field is -1..+1, a throttle uses 0..1 of it. + more power. */
  readonly throttle: number | null;
  /** Elevator deflection. + nose up. */
  readonly elevator: number | null;
  /** Rudder deflection. + nose right. */
  readonly rudder: number | null;
}

/** What the flight management system of the real aircraft asks for. Without a plan all of it is absent, without a position bearing and distance are. */
export interface FmsPlan {
  /** Great-circle bearing to the waypoint. Shown as 0..360. [deg] + clockwise from north, seen from above. */
  readonly bearing_deg: number | null;
  /** Altitude asked for, above mean sea level. [ft] + up. */
  readonly altitude_ft: number | null;
  /** Indicated airspeed asked for. [kt] + forward. */
  readonly speed_kt: number | null;
  /** Great-circle distance to the waypoint; the limit is half way round the earth. [m] */
  readonly distance_m: number | null;
  /** Index of the waypoint, from 0. */
  readonly waypoint: number | null;
}

/** What the flight management system of the HIL aircraft asks for; fields as fms_plan. */
export interface FmsHilPlan {
  /** Great-circle bearing to the waypoint. Shown as 0..360. [deg] + clockwise from north, seen from above. */
  readonly bearing_deg: number | null;
  /** Altitude asked for, above mean sea level. [ft] + up. */
  readonly altitude_ft: number | null;
  /** Indicated airspeed asked for. [kt] + forward. */
  readonly speed_kt: number | null;
  /** Great-circle distance to the waypoint; the limit is half way round the earth. [m] */
  readonly distance_m: number | null;
  /** Index of the waypoint, from 0. */
  readonly waypoint: number | null;
}

/** Load of the board's two processors. */
export interface Statistics {
  /** CPU load of the sensor processor. [%] */
  readonly sensor_dsc_percent: number | null;
  /** CPU load of the control processor. [%] */
  readonly control_dsc_percent: number | null;
}

/** Position of the GPS receiver. Single precision resolves 1-2 m: the board's limit. */
export interface Gps {
  /** Geodetic latitude, WGS84. [deg] + north. */
  readonly latitude_deg: number | null;
  /** Longitude, WGS84. [deg] + east. */
  readonly longitude_deg: number | null;
  /** Altitude above mean sea level. [m] + up. */
  readonly altitude_m: number | null;
  /** Ground speed. [kt] */
  readonly speed_kt: number | null;
  /** Ground track. Shown as 0..360. [deg] + clockwise from north, seen from above. */
  readonly heading_deg: number | null;
  /** Satellites used: ASCII digits as received, units in the low byte, tens in the next ('8' is 0x38, "12" is 0x3132). */
  readonly satellites: number | null;
  /** Kind of position fix: an ASCII digit, '0' for none. */
  readonly fix: number | null;
  /** Receiver status: ASCII 'A' valid, 'V' void. */
  readonly valid: boolean | null;
}

/** What the board wants the simulator's surfaces to be. */
export interface HilSurfaces {
  /** Elevator deflection. + nose up. */
  readonly elevator: number | null;
  /** Aileron deflection. + right wing down. */
  readonly aileron: number | null;
  /** Rudder deflection. + nose right. */
  readonly rudder: number | null;
  /** Throttle. + more power. */
  readonly throttle: number | null;
}

/** The 17 gains, in answer to load_autopilot_parameters. One of them is an integer. */
export interface AutopilotParameters {
  /** Integral gain of the altitude loop, per second, times k_altura. */
  readonly k_int_altura: number | null;
  /** Pitch asked for, deg, for each foot of altitude error. */
  readonly k_altura: number | null;
  /** Altitude lead, ft, for each ft/min of vertical speed. */
  readonly k_VVI: number | null;
  /** Elevator command for each radian of pitch error. */
  readonly k_pitch: number | null;
  /** Roll asked for, deg, for each degree of track error. */
  readonly k_heading: number | null;
  /** Aileron command for each radian of roll error. */
  readonly k_roll: number | null;
  /** Airspeed error times seconds, kt s, for full throttle travel; an integer on the wire. */
  readonly k_div_velocidad: number | null;
  /** Divider of the roll rate at rest. */
  readonly k_div_P_init: number | null;
  /** Airspeed, kt, which adds 1 to the roll-rate divider. */
  readonly k_div_P_speed: number | null;
  /** Divider of the pitch rate at rest. */
  readonly k_div_Q_init: number | null;
  /** Airspeed, kt, which adds 1 to the pitch-rate divider. */
  readonly k_div_Q_speed: number | null;
  /** Divider of the yaw rate at rest. */
  readonly k_div_R_init: number | null;
  /** Airspeed, kt, which adds 1 to the yaw-rate divider. */
  readonly k_div_R_speed: number | null;
  /** Autotrim: integral gain of the pitch-rate loop, per second. */
  readonly k_int_pitch: number | null;
  /** Proportional gain of the pitch-rate loop. */
  readonly k_elev: number | null;
  /** Gain of the roll-rate loop. */
  readonly k_airln: number | null;
  /** Gain of the yaw-rate loop. */
  readonly k_rudder: number | null;
}

/** State that the heartbeat has no room for; once a second. */
export interface BoardStatus {
  /** Where the airspeed comes from. */
  readonly airspeed_source: number | null;
  /** Where the altitude comes from. */
  readonly altitude_source: number | null;
  /** What drives the servo outputs. */
  readonly servos_control_mode: number | null;
  /** Which of the four routes the HIL plan is; none for an uploaded or absent plan. */
  readonly hil_plan_name: number | null;
  /** Good frames since the start of the board. */
  readonly frames_received: number | null;
  /** Refused frames since the start of the board. */
  readonly frames_rejected: number | null;
}

/** The simulator's state for the HIL loop; answered by hil_surfaces, never acknowledged. */
export interface XplaneInfo {
  /** The pilot's stick. + nose up. */
  readonly elevator: number | null;
  /** The pilot's stick. + right wing down. */
  readonly aileron: number | null;
  /** The pilot's pedals. + nose right. */
  readonly rudder: number | null;
  /** The pilot's throttle. + more power. */
  readonly throttle: number | null;
  /** Roll rate P, body axes. [rad/s] + right wing going down. */
  readonly gx_rad_s: number | null;
  /** Pitch rate Q, body axes. [rad/s] + nose going up. */
  readonly gy_rad_s: number | null;
  /** Yaw rate R, body axes. [rad/s] + nose going right. */
  readonly gz_rad_s: number | null;
  /** Ground track where the simulator gives it, else true heading. [deg] + clockwise from north, seen from above. */
  readonly yaw_deg: number | null;
  /** Pitch angle. [deg] + nose up. */
  readonly pitch_deg: number | null;
  /** Roll angle. [deg] + right wing down. */
  readonly roll_deg: number | null;
  /** Indicated altitude. [ft] + up. */
  readonly altitude_ft: number | null;
  /** Vertical speed. [ft/min] + climb. */
  readonly vvi_ft_min: number | null;
  /** Indicated airspeed. [kt] + forward. */
  readonly speed_kt: number | null;
  /** Geodetic latitude. [deg] + north. */
  readonly latitude_deg: number | null;
  /** Longitude. [deg] + east. */
  readonly longitude_deg: number | null;
}

/** Newest values of every topic; null is "no data". */
export interface Telemetry {
  readonly heartbeat: Heartbeat;
  readonly ahrs: Ahrs;
  readonly inertial: Inertial;
  readonly analog: Analog;
  readonly servos_in: ServosIn;
  readonly fly_by_wire: FlyByWire;
  readonly fms_plan: FmsPlan;
  readonly fms_hil_plan: FmsHilPlan;
  readonly statistics: Statistics;
  readonly gps: Gps;
  readonly hil_surfaces: HilSurfaces;
  readonly autopilot_parameters: AutopilotParameters;
  readonly board_status: BoardStatus;
  readonly xplane_info: XplaneInfo;
}

export type TopicName = keyof Telemetry;

export const TOPICS: readonly TopicName[] = [
  "heartbeat",
  "ahrs",
  "inertial",
  "analog",
  "servos_in",
  "fly_by_wire",
  "fms_plan",
  "fms_hil_plan",
  "statistics",
  "gps",
  "hil_surfaces",
  "autopilot_parameters",
  "board_status",
  "xplane_info",
];

export const FIELDS: {
  readonly [T in TopicName]: { readonly [F in keyof Telemetry[T]]: FieldInfo };
} = {
  heartbeat: {
    autopilot: { kind: "boolean", unit: "1", minimum: 0, maximum: 1, sign: "none", doc: "Autopilot of the real aircraft is on.", names: {} },
    autotrim: { kind: "boolean", unit: "1", minimum: 0, maximum: 1, sign: "none", doc: "Elevator autotrim of the real aircraft is on.", names: {} },
    auto_switch: { kind: "boolean", unit: "1", minimum: 0, maximum: 1, sign: "none", doc: "The transmitter's \"automatic\" switch is on.", names: {} },
    servos: { kind: "boolean", unit: "1", minimum: 0, maximum: 1, sign: "none", doc: "Stream servos_in is on.", names: {} },
    gps: { kind: "boolean", unit: "1", minimum: 0, maximum: 1, sign: "none", doc: "Stream gps is on.", names: {} },
    statistics: { kind: "boolean", unit: "1", minimum: 0, maximum: 1, sign: "none", doc: "Stream statistics is on.", names: {} },
    ahrs: { kind: "boolean", unit: "1", minimum: 0, maximum: 1, sign: "none", doc: "Stream ahrs is on.", names: {} },
    inertial: { kind: "boolean", unit: "1", minimum: 0, maximum: 1, sign: "none", doc: "Stream inertial is on.", names: {} },
    analog: { kind: "boolean", unit: "1", minimum: 0, maximum: 1, sign: "none", doc: "Stream analog is on.", names: {} },
    fly_by_wire: { kind: "boolean", unit: "1", minimum: 0, maximum: 1, sign: "none", doc: "Stream fly_by_wire is on.", names: {} },
    autopilot_hil: { kind: "boolean", unit: "1", minimum: 0, maximum: 3, sign: "none", doc: "Autopilot of the HIL aircraft is on.", names: {} },
    source_joystick: { kind: "boolean", unit: "1", minimum: 0, maximum: 3, sign: "none", doc: "Control source is the joystick; otherwise the RC transmitter.", names: {} },
    autotrim_hil: { kind: "boolean", unit: "1", minimum: 0, maximum: 1, sign: "none", doc: "Elevator autotrim of the HIL aircraft is on.", names: {} },
  },
  ahrs: {
    yaw_deg: { kind: "number", unit: "deg", minimum: -360.0, maximum: 360.0, sign: "clockwise from north, seen from above", doc: "Heading; boards send 0..360 or -180..180. Shown as 0..360.", names: {} },
    pitch_deg: { kind: "number", unit: "deg", minimum: -90.0, maximum: 90.0, sign: "nose up", doc: "Pitch angle.", names: {} },
    roll_deg: { kind: "number", unit: "deg", minimum: -180.0, maximum: 180.0, sign: "right wing down", doc: "Roll angle.", names: {} },
  },
  inertial: {
    gx_rad_s: { kind: "number", unit: "rad/s", minimum: -40.0, maximum: 40.0, sign: "right wing going down", doc: "Roll rate P.", names: {} },
    gy_rad_s: { kind: "number", unit: "rad/s", minimum: -40.0, maximum: 40.0, sign: "nose going up", doc: "Pitch rate Q.", names: {} },
    gz_rad_s: { kind: "number", unit: "rad/s", minimum: -40.0, maximum: 40.0, sign: "nose going right", doc: "Yaw rate R.", names: {} },
    accx_m_s2: { kind: "number", unit: "m/s2", minimum: -200.0, maximum: 200.0, sign: "forward", doc: "Specific force along x.", names: {} },
    accy_m_s2: { kind: "number", unit: "m/s2", minimum: -200.0, maximum: 200.0, sign: "right", doc: "Specific force along y.", names: {} },
    accz_m_s2: { kind: "number", unit: "m/s2", minimum: -200.0, maximum: 200.0, sign: "down; level flight gives -9.81", doc: "Specific force along z.", names: {} },
    magx: { kind: "number", unit: "1", minimum: -2.0, maximum: 2.0, sign: "forward", doc: "Magnetic field along x, normalised to the calibration sphere.", names: {} },
    magy: { kind: "number", unit: "1", minimum: -2.0, maximum: 2.0, sign: "right", doc: "Magnetic field along y, normalised to the calibration sphere.", names: {} },
    magz: { kind: "number", unit: "1", minimum: -2.0, maximum: 2.0, sign: "down", doc: "Magnetic field along z, normalised to the calibration sphere.", names: {} },
  },
  analog: {
    baro_hpa: { kind: "number", unit: "hPa", minimum: 300.0, maximum: 1100.0, sign: "none", doc: "Static pressure.", names: {} },
    altitude_m: { kind: "number", unit: "m", minimum: -500.0, maximum: 20000.0, sign: "up", doc: "Barometric altitude above mean sea level.", names: {} },
    altitude_external_m: { kind: "number", unit: "m", minimum: -500.0, maximum: 20000.0, sign: "up", doc: "Altitude of the external sensor.", names: {} },
    pitot_pa: { kind: "number", unit: "Pa", minimum: -2000.0, maximum: 20000.0, sign: "total above static", doc: "Differential pressure of the Pitot tube; noise makes it slightly negative at rest.", names: {} },
    calibrated_airspeed_kt: { kind: "number", unit: "kt", minimum: -10.0, maximum: 500.0, sign: "forward", doc: "Calibrated airspeed; sensor noise makes it slightly negative at rest.", names: {} },
    alpha_deg: { kind: "number", unit: "deg", minimum: -180.0, maximum: 180.0, sign: "air from below", doc: "Angle of attack.", names: {} },
    beta_deg: { kind: "number", unit: "deg", minimum: -180.0, maximum: 180.0, sign: "air from the right", doc: "Side-slip angle.", names: {} },
    temperature_degc: { kind: "number", unit: "degC", minimum: -60.0, maximum: 125.0, sign: "above freezing", doc: "Temperature at the board.", names: {} },
    battery_v: { kind: "number", unit: "V", minimum: 0.0, maximum: 60.0, sign: "none", doc: "Battery voltage.", names: {} },
    vvi_ft_min: { kind: "number", unit: "ft/min", minimum: -20000.0, maximum: 20000.0, sign: "climb", doc: "Vertical speed.", names: {} },
  },
  servos_in: {
    channel_0: { kind: "number", unit: "1", minimum: -1.0, maximum: 1.0, sign: "stick right, back, full power or right pedal", doc: "Position of the channel; throttle is 0..1 of its useful half.", names: {} },
    channel_1: { kind: "number", unit: "1", minimum: -1.0, maximum: 1.0, sign: "stick right, back, full power or right pedal", doc: "Position of the channel; throttle is 0..1 of its useful half.", names: {} },
    channel_2: { kind: "number", unit: "1", minimum: -1.0, maximum: 1.0, sign: "stick right, back, full power or right pedal", doc: "Position of the channel; throttle is 0..1 of its useful half.", names: {} },
    channel_3: { kind: "number", unit: "1", minimum: -1.0, maximum: 1.0, sign: "stick right, back, full power or right pedal", doc: "Position of the channel; throttle is 0..1 of its useful half.", names: {} },
    channel_4: { kind: "number", unit: "1", minimum: -1.0, maximum: 1.0, sign: "stick right, back, full power or right pedal", doc: "Position of the channel; throttle is 0..1 of its useful half.", names: {} },
    channel_5: { kind: "number", unit: "1", minimum: -1.0, maximum: 1.0, sign: "stick right, back, full power or right pedal", doc: "Position of the channel; throttle is 0..1 of its useful half.", names: {} },
    channel_6: { kind: "number", unit: "1", minimum: -1.0, maximum: 1.0, sign: "stick right, back, full power or right pedal", doc: "Position of the channel; throttle is 0..1 of its useful half.", names: {} },
    channel_7: { kind: "number", unit: "1", minimum: -1.0, maximum: 1.0, sign: "stick right, back, full power or right pedal", doc: "Position of the channel; throttle is 0..1 of its useful half.", names: {} },
    channel_8: { kind: "number", unit: "1", minimum: -1.0, maximum: 1.0, sign: "stick right, back, full power or right pedal", doc: "Position of the channel; throttle is 0..1 of its useful half.", names: {} },
    channel_9: { kind: "number", unit: "1", minimum: -1.0, maximum: 1.0, sign: "stick right, back, full power or right pedal", doc: "Position of the channel; throttle is 0..1 of its useful half.", names: {} },
    channel_10: { kind: "number", unit: "1", minimum: -1.0, maximum: 1.0, sign: "stick right, back, full power or right pedal", doc: "Position of the channel; throttle is 0..1 of its useful half.", names: {} },
    channel_11: { kind: "number", unit: "1", minimum: -1.0, maximum: 1.0, sign: "stick right, back, full power or right pedal", doc: "Position of the channel; throttle is 0..1 of its useful half.", names: {} },
  },
  fly_by_wire: {
    aileron: { kind: "number", unit: "1", minimum: -1.0, maximum: 1.0, sign: "right wing down", doc: "Aileron deflection.", names: {} },
    throttle: { kind: "number", unit: "1", minimum: -1.0, maximum: 1.0, sign: "more power", doc: "Throttle; the deployed board's field is -1..+1, a throttle uses 0..1 of it.", names: {} },
    elevator: { kind: "number", unit: "1", minimum: -1.0, maximum: 1.0, sign: "nose up", doc: "Elevator deflection.", names: {} },
    rudder: { kind: "number", unit: "1", minimum: -1.0, maximum: 1.0, sign: "nose right", doc: "Rudder deflection.", names: {} },
  },
  fms_plan: {
    bearing_deg: { kind: "number", unit: "deg", minimum: -360.0, maximum: 360.0, sign: "clockwise from north, seen from above", doc: "Great-circle bearing to the waypoint. Shown as 0..360.", names: {} },
    altitude_ft: { kind: "number", unit: "ft", minimum: -2000.0, maximum: 60000.0, sign: "up", doc: "Altitude asked for, above mean sea level.", names: {} },
    speed_kt: { kind: "number", unit: "kt", minimum: 0.0, maximum: 500.0, sign: "forward", doc: "Indicated airspeed asked for.", names: {} },
    distance_m: { kind: "integer", unit: "m", minimum: 0, maximum: 20100000, sign: "none", doc: "Great-circle distance to the waypoint; the limit is half way round the earth.", names: {} },
    waypoint: { kind: "integer", unit: "1", minimum: 0, maximum: 99, sign: "none", doc: "Index of the waypoint, from 0.", names: {} },
  },
  fms_hil_plan: {
    bearing_deg: { kind: "number", unit: "deg", minimum: -360.0, maximum: 360.0, sign: "clockwise from north, seen from above", doc: "Great-circle bearing to the waypoint. Shown as 0..360.", names: {} },
    altitude_ft: { kind: "number", unit: "ft", minimum: -2000.0, maximum: 60000.0, sign: "up", doc: "Altitude asked for, above mean sea level.", names: {} },
    speed_kt: { kind: "number", unit: "kt", minimum: 0.0, maximum: 500.0, sign: "forward", doc: "Indicated airspeed asked for.", names: {} },
    distance_m: { kind: "integer", unit: "m", minimum: 0, maximum: 20100000, sign: "none", doc: "Great-circle distance to the waypoint; the limit is half way round the earth.", names: {} },
    waypoint: { kind: "integer", unit: "1", minimum: 0, maximum: 99, sign: "none", doc: "Index of the waypoint, from 0.", names: {} },
  },
  statistics: {
    sensor_dsc_percent: { kind: "integer", unit: "%", minimum: 0, maximum: 100, sign: "none", doc: "CPU load of the sensor processor.", names: {} },
    control_dsc_percent: { kind: "integer", unit: "%", minimum: 0, maximum: 100, sign: "none", doc: "CPU load of the control processor.", names: {} },
  },
  gps: {
    latitude_deg: { kind: "number", unit: "deg", minimum: -90.0, maximum: 90.0, sign: "north", doc: "Geodetic latitude, WGS84.", names: {} },
    longitude_deg: { kind: "number", unit: "deg", minimum: -180.0, maximum: 180.0, sign: "east", doc: "Longitude, WGS84.", names: {} },
    altitude_m: { kind: "number", unit: "m", minimum: -500.0, maximum: 20000.0, sign: "up", doc: "Altitude above mean sea level.", names: {} },
    speed_kt: { kind: "number", unit: "kt", minimum: 0.0, maximum: 500.0, sign: "none", doc: "Ground speed.", names: {} },
    heading_deg: { kind: "number", unit: "deg", minimum: -360.0, maximum: 360.0, sign: "clockwise from north, seen from above", doc: "Ground track. Shown as 0..360.", names: {} },
    satellites: { kind: "integer", unit: "1", minimum: 0, maximum: 99, sign: "none", doc: "Satellites used: ASCII digits as received, units in the low byte, tens in the next ('8' is 0x38, \"12\" is 0x3132).", names: {} },
    fix: { kind: "integer", unit: "1", minimum: 0, maximum: 9, sign: "none", doc: "Kind of position fix: an ASCII digit, '0' for none.", names: {} },
    valid: { kind: "boolean", unit: "1", minimum: null, maximum: null, sign: "none", doc: "Receiver status: ASCII 'A' valid, 'V' void.", names: {} },
  },
  hil_surfaces: {
    elevator: { kind: "number", unit: "1", minimum: -1.0, maximum: 1.0, sign: "nose up", doc: "Elevator deflection.", names: {} },
    aileron: { kind: "number", unit: "1", minimum: -1.0, maximum: 1.0, sign: "right wing down", doc: "Aileron deflection.", names: {} },
    rudder: { kind: "number", unit: "1", minimum: -1.0, maximum: 1.0, sign: "nose right", doc: "Rudder deflection.", names: {} },
    throttle: { kind: "number", unit: "1", minimum: 0.0, maximum: 1.0, sign: "more power", doc: "Throttle.", names: {} },
  },
  autopilot_parameters: {
    k_int_altura: { kind: "number", unit: "1", minimum: 0.0, maximum: 99.99, sign: "none", doc: "Integral gain of the altitude loop, per second, times k_altura.", names: {} },
    k_altura: { kind: "number", unit: "1", minimum: 0.0, maximum: 99.99, sign: "none", doc: "Pitch asked for, deg, for each foot of altitude error.", names: {} },
    k_VVI: { kind: "number", unit: "1", minimum: 0.0, maximum: 99.99, sign: "none", doc: "Altitude lead, ft, for each ft/min of vertical speed.", names: {} },
    k_pitch: { kind: "number", unit: "1", minimum: 0.0, maximum: 99.99, sign: "none", doc: "Elevator command for each radian of pitch error.", names: {} },
    k_heading: { kind: "number", unit: "1", minimum: 0.0, maximum: 99.99, sign: "none", doc: "Roll asked for, deg, for each degree of track error.", names: {} },
    k_roll: { kind: "number", unit: "1", minimum: 0.0, maximum: 99.99, sign: "none", doc: "Aileron command for each radian of roll error.", names: {} },
    k_div_velocidad: { kind: "integer", unit: "1", minimum: 10, maximum: 10000, sign: "none", doc: "Airspeed error times seconds, kt s, for full throttle travel; an integer on the wire.", names: {} },
    k_div_P_init: { kind: "number", unit: "1", minimum: 0.1, maximum: 99.99, sign: "none", doc: "Divider of the roll rate at rest.", names: {} },
    k_div_P_speed: { kind: "number", unit: "1", minimum: 10.0, maximum: 99.99, sign: "none", doc: "Airspeed, kt, which adds 1 to the roll-rate divider.", names: {} },
    k_div_Q_init: { kind: "number", unit: "1", minimum: 0.1, maximum: 99.99, sign: "none", doc: "Divider of the pitch rate at rest.", names: {} },
    k_div_Q_speed: { kind: "number", unit: "1", minimum: 10.0, maximum: 99.99, sign: "none", doc: "Airspeed, kt, which adds 1 to the pitch-rate divider.", names: {} },
    k_div_R_init: { kind: "number", unit: "1", minimum: 0.1, maximum: 99.99, sign: "none", doc: "Divider of the yaw rate at rest.", names: {} },
    k_div_R_speed: { kind: "number", unit: "1", minimum: 10.0, maximum: 99.99, sign: "none", doc: "Airspeed, kt, which adds 1 to the yaw-rate divider.", names: {} },
    k_int_pitch: { kind: "number", unit: "1", minimum: 0.0, maximum: 99.99, sign: "none", doc: "Autotrim: integral gain of the pitch-rate loop, per second.", names: {} },
    k_elev: { kind: "number", unit: "1", minimum: 0.0, maximum: 99.99, sign: "none", doc: "Proportional gain of the pitch-rate loop.", names: {} },
    k_airln: { kind: "number", unit: "1", minimum: 0.0, maximum: 99.99, sign: "none", doc: "Gain of the roll-rate loop.", names: {} },
    k_rudder: { kind: "number", unit: "1", minimum: 0.0, maximum: 99.99, sign: "none", doc: "Gain of the yaw-rate loop.", names: {} },
  },
  board_status: {
    airspeed_source: { kind: "integer", unit: "1", minimum: 0, maximum: 1, sign: "none", doc: "Where the airspeed comes from.", names: {"gps": 0, "pitot": 1} },
    altitude_source: { kind: "integer", unit: "1", minimum: 0, maximum: 1, sign: "none", doc: "Where the altitude comes from.", names: {"gps": 0, "barometer": 1} },
    servos_control_mode: { kind: "integer", unit: "1", minimum: 0, maximum: 1, sign: "none", doc: "What drives the servo outputs.", names: {"fly_by_wire": 0, "hil": 1} },
    hil_plan_name: { kind: "integer", unit: "1", minimum: -1, maximum: 3, sign: "none", doc: "Which of the four routes the HIL plan is; none for an uploaded or absent plan.", names: {"none": -1, "gando": 0, "ruta_isla": 1, "alternativa": 2, "vuelo": 3} },
    frames_received: { kind: "integer", unit: "1", minimum: 0, maximum: 4294967295, sign: "none", doc: "Good frames since the start of the board.", names: {} },
    frames_rejected: { kind: "integer", unit: "1", minimum: 0, maximum: 4294967295, sign: "none", doc: "Refused frames since the start of the board.", names: {} },
  },
  xplane_info: {
    elevator: { kind: "number", unit: "1", minimum: -1.0, maximum: 1.0, sign: "nose up", doc: "The pilot's stick.", names: {} },
    aileron: { kind: "number", unit: "1", minimum: -1.0, maximum: 1.0, sign: "right wing down", doc: "The pilot's stick.", names: {} },
    rudder: { kind: "number", unit: "1", minimum: -1.0, maximum: 1.0, sign: "nose right", doc: "The pilot's pedals.", names: {} },
    throttle: { kind: "number", unit: "1", minimum: 0.0, maximum: 1.0, sign: "more power", doc: "The pilot's throttle.", names: {} },
    gx_rad_s: { kind: "number", unit: "rad/s", minimum: -40.0, maximum: 40.0, sign: "right wing going down", doc: "Roll rate P, body axes.", names: {} },
    gy_rad_s: { kind: "number", unit: "rad/s", minimum: -40.0, maximum: 40.0, sign: "nose going up", doc: "Pitch rate Q, body axes.", names: {} },
    gz_rad_s: { kind: "number", unit: "rad/s", minimum: -40.0, maximum: 40.0, sign: "nose going right", doc: "Yaw rate R, body axes.", names: {} },
    yaw_deg: { kind: "number", unit: "deg", minimum: -360.0, maximum: 360.0, sign: "clockwise from north, seen from above", doc: "Ground track where the simulator gives it, else true heading.", names: {} },
    pitch_deg: { kind: "number", unit: "deg", minimum: -90.0, maximum: 90.0, sign: "nose up", doc: "Pitch angle.", names: {} },
    roll_deg: { kind: "number", unit: "deg", minimum: -180.0, maximum: 180.0, sign: "right wing down", doc: "Roll angle.", names: {} },
    altitude_ft: { kind: "number", unit: "ft", minimum: -2000.0, maximum: 100000.0, sign: "up", doc: "Indicated altitude.", names: {} },
    vvi_ft_min: { kind: "number", unit: "ft/min", minimum: -50000.0, maximum: 50000.0, sign: "climb", doc: "Vertical speed.", names: {} },
    speed_kt: { kind: "number", unit: "kt", minimum: -100.0, maximum: 1500.0, sign: "forward", doc: "Indicated airspeed.", names: {} },
    latitude_deg: { kind: "number", unit: "deg", minimum: -90.0, maximum: 90.0, sign: "north", doc: "Geodetic latitude.", names: {} },
    longitude_deg: { kind: "number", unit: "deg", minimum: -180.0, maximum: 180.0, sign: "east", doc: "Longitude.", names: {} },
  },
};

export type CommandName = "do_nothing" | "stop" | "start" | "read_all" | "reset" | "ahrs_on" | "ahrs_off" | "inertial_on" | "inertial_off" | "analog_on" | "analog_off" | "statistics_on" | "statistics_off" | "gps_on" | "gps_off" | "servos_in_on" | "servos_in_off" | "fly_by_wire_on" | "fly_by_wire_off" | "fms_plan_on" | "fms_plan_off" | "fms_hil_plan_on" | "fms_hil_plan_off" | "autopilot_on" | "autopilot_off" | "autotrim_on" | "autotrim_off" | "fms_next_waypoint" | "fms_previous_waypoint" | "hil_fms_next_waypoint" | "hil_fms_previous_waypoint" | "set_parameter_task_rate" | "set_fms_task_rate" | "set_servos_task_rate" | "exit_binary_mode" | "xplane_info" | "hil_load_gando" | "hil_load_ruta_isla" | "hil_load_alternativa" | "hil_load_vuelo" | "control_source" | "servos_control_mode_fly_by_wire" | "servos_control_mode_hil" | "servo_out" | "load_autopilot_parameters" | "set_k_elev" | "set_k_airln" | "set_k_rudder" | "set_k_int_pitch" | "set_k_div_P_init" | "set_k_div_P_speed" | "set_k_div_Q_init" | "set_k_div_Q_speed" | "set_k_div_R_init" | "set_k_div_R_speed" | "set_k_div_velocidad" | "set_k_roll" | "set_k_heading" | "set_k_pitch" | "set_k_VVI" | "set_k_altura" | "set_k_int_altura" | "capabilities" | "store_parameters" | "select_airspeed_source" | "select_altitude_source" | "mission_begin" | "mission_item" | "mission_commit" | "mission_read" | "go_to_waypoint" | "hil_steps_on" | "describe" | "describe_blocks" | "own_gain_get" | "own_gain_set" | "own_topics";

export const COMMANDS: Readonly<Record<CommandName, CommandInfo>> = {
  do_nothing: { id: 0, doc: "Nothing; never acknowledged.", extension: false, confirm: "none", arguments: [] },
  stop: { id: 1, doc: "All streams off.", extension: false, confirm: "heartbeat", arguments: [] },
  start: { id: 2, doc: "All streams on.", extension: false, confirm: "heartbeat", arguments: [] },
  read_all: { id: 3, doc: "Send every stream once.", extension: false, confirm: "none", arguments: [] },
  reset: { id: 4, doc: "Reset the autopilot.", extension: false, confirm: "none", arguments: [] },
  ahrs_on: { id: 5, doc: "Stream ahrs on.", extension: false, confirm: "heartbeat", arguments: [] },
  ahrs_off: { id: 6, doc: "Stream ahrs off.", extension: false, confirm: "heartbeat", arguments: [] },
  inertial_on: { id: 7, doc: "Stream inertial on.", extension: false, confirm: "heartbeat", arguments: [] },
  inertial_off: { id: 21, doc: "Stream inertial off.", extension: false, confirm: "heartbeat", arguments: [] },
  analog_on: { id: 22, doc: "Stream analog on.", extension: false, confirm: "heartbeat", arguments: [] },
  analog_off: { id: 23, doc: "Stream analog off.", extension: false, confirm: "heartbeat", arguments: [] },
  statistics_on: { id: 24, doc: "Stream statistics on.", extension: false, confirm: "heartbeat", arguments: [] },
  statistics_off: { id: 25, doc: "Stream statistics off.", extension: false, confirm: "heartbeat", arguments: [] },
  gps_on: { id: 26, doc: "Stream gps on.", extension: false, confirm: "heartbeat", arguments: [] },
  gps_off: { id: 27, doc: "Stream gps off.", extension: false, confirm: "heartbeat", arguments: [] },
  servos_in_on: { id: 28, doc: "Stream servos_in on.", extension: false, confirm: "heartbeat", arguments: [] },
  servos_in_off: { id: 29, doc: "Stream servos_in off.", extension: false, confirm: "heartbeat", arguments: [] },
  fly_by_wire_on: { id: 30, doc: "Stream fly_by_wire on.", extension: false, confirm: "heartbeat", arguments: [] },
  fly_by_wire_off: { id: 31, doc: "Stream fly_by_wire off.", extension: false, confirm: "heartbeat", arguments: [] },
  fms_plan_on: { id: 33, doc: "Stream fms_plan on. The heartbeat has no flag for it.", extension: false, confirm: "frame", arguments: [] },
  fms_plan_off: { id: 34, doc: "Stream fms_plan off. The heartbeat has no flag for it.", extension: false, confirm: "none", arguments: [] },
  fms_hil_plan_on: { id: 35, doc: "Stream fms_hil_plan on. The heartbeat has no flag for it.", extension: false, confirm: "frame", arguments: [] },
  fms_hil_plan_off: { id: 36, doc: "Stream fms_hil_plan off. The heartbeat has no flag for it.", extension: false, confirm: "none", arguments: [] },
  autopilot_on: { id: 37, doc: "HIL autopilot on; with RC as the control source the transmitter's switch rules instead.", extension: false, confirm: "heartbeat", arguments: [] },
  autopilot_off: { id: 38, doc: "HIL autopilot off; with RC as the control source the transmitter's switch rules instead.", extension: false, confirm: "heartbeat", arguments: [] },
  autotrim_on: { id: 39, doc: "HIL elevator autotrim on; with RC as the control source the transmitter's switch rules instead.", extension: false, confirm: "heartbeat", arguments: [] },
  autotrim_off: { id: 40, doc: "HIL elevator autotrim off; with RC as the control source the transmitter's switch rules instead.", extension: false, confirm: "heartbeat", arguments: [] },
  fms_next_waypoint: { id: 41, doc: "The real plan goes to its next waypoint.", extension: false, confirm: "plan", arguments: [] },
  fms_previous_waypoint: { id: 42, doc: "The real plan goes to its previous waypoint.", extension: false, confirm: "plan", arguments: [] },
  hil_fms_next_waypoint: { id: 43, doc: "The HIL plan goes to its next waypoint.", extension: false, confirm: "plan", arguments: [] },
  hil_fms_previous_waypoint: { id: 45, doc: "The HIL plan goes to its previous waypoint.", extension: false, confirm: "plan", arguments: [] },
  set_parameter_task_rate: { id: 46, doc: "Period of the task that sends heartbeat, ahrs, inertial and analog.", extension: false, confirm: "none", arguments: [{"name": "period_ms", "kind": "integer", "unit": "ms", "minimum": 20, "maximum": 10000, "default": 100, "names": {}}] },
  set_fms_task_rate: { id: 47, doc: "Period of the task that sends fms_plan, fms_hil_plan, statistics and gps.", extension: false, confirm: "none", arguments: [{"name": "period_ms", "kind": "integer", "unit": "ms", "minimum": 50, "maximum": 10000, "default": 100, "names": {}}] },
  set_servos_task_rate: { id: 48, doc: "Period of the task that sends servos_in and fly_by_wire.", extension: false, confirm: "none", arguments: [{"name": "period_ms", "kind": "integer", "unit": "ms", "minimum": 20, "maximum": 10000, "default": 20, "names": {}}] },
  exit_binary_mode: { id: 49, doc: "Back to text mode; nothing more is sent.", extension: false, confirm: "none", arguments: [] },
  xplane_info: { id: 50, doc: "The simulator's state for the HIL loop; answered by hil_surfaces, never acknowledged.", extension: false, confirm: "none", arguments: [{"name": "elevator", "kind": "number", "unit": "1", "minimum": -1.0, "maximum": 1.0, "default": null, "names": {}}, {"name": "aileron", "kind": "number", "unit": "1", "minimum": -1.0, "maximum": 1.0, "default": null, "names": {}}, {"name": "rudder", "kind": "number", "unit": "1", "minimum": -1.0, "maximum": 1.0, "default": null, "names": {}}, {"name": "throttle", "kind": "number", "unit": "1", "minimum": 0.0, "maximum": 1.0, "default": null, "names": {}}, {"name": "gx_rad_s", "kind": "number", "unit": "rad/s", "minimum": -40.0, "maximum": 40.0, "default": null, "names": {}}, {"name": "gy_rad_s", "kind": "number", "unit": "rad/s", "minimum": -40.0, "maximum": 40.0, "default": null, "names": {}}, {"name": "gz_rad_s", "kind": "number", "unit": "rad/s", "minimum": -40.0, "maximum": 40.0, "default": null, "names": {}}, {"name": "yaw_deg", "kind": "number", "unit": "deg", "minimum": -360.0, "maximum": 360.0, "default": null, "names": {}}, {"name": "pitch_deg", "kind": "number", "unit": "deg", "minimum": -90.0, "maximum": 90.0, "default": null, "names": {}}, {"name": "roll_deg", "kind": "number", "unit": "deg", "minimum": -180.0, "maximum": 180.0, "default": null, "names": {}}, {"name": "altitude_ft", "kind": "number", "unit": "ft", "minimum": -2000.0, "maximum": 100000.0, "default": null, "names": {}}, {"name": "vvi_ft_min", "kind": "number", "unit": "ft/min", "minimum": -50000.0, "maximum": 50000.0, "default": null, "names": {}}, {"name": "speed_kt", "kind": "number", "unit": "kt", "minimum": -100.0, "maximum": 1500.0, "default": null, "names": {}}, {"name": "latitude_deg", "kind": "number", "unit": "deg", "minimum": -90.0, "maximum": 90.0, "default": null, "names": {}}, {"name": "longitude_deg", "kind": "number", "unit": "deg", "minimum": -180.0, "maximum": 180.0, "default": null, "names": {}}] },
  hil_load_gando: { id: 51, doc: "The HIL plan becomes the route Gando.", extension: false, confirm: "plan", arguments: [] },
  hil_load_ruta_isla: { id: 52, doc: "The HIL plan becomes the route Ruta Isla.", extension: false, confirm: "plan", arguments: [] },
  hil_load_alternativa: { id: 53, doc: "The HIL plan becomes the route Alternativa.", extension: false, confirm: "plan", arguments: [] },
  hil_load_vuelo: { id: 54, doc: "The HIL plan becomes the route Vuelo.", extension: false, confirm: "plan", arguments: [] },
  control_source: { id: 55, doc: "Where stick, autopilot and autotrim come from.", extension: false, confirm: "heartbeat", arguments: [{"name": "source", "kind": "integer", "unit": "1", "minimum": 0, "maximum": 1, "default": null, "names": {"rc": 0, "joystick": 1}}] },
  servos_control_mode_fly_by_wire: { id: 56, doc: "The servo outputs follow the fly-by-wire law of the real aircraft.", extension: false, confirm: "none", arguments: [] },
  servos_control_mode_hil: { id: 57, doc: "The servo outputs follow the HIL loop.", extension: false, confirm: "none", arguments: [] },
  servo_out: { id: 58, doc: "Move one servo output.", extension: false, confirm: "none", arguments: [{"name": "servo", "kind": "integer", "unit": "1", "minimum": 0, "maximum": 19, "default": null, "names": {}}, {"name": "position", "kind": "number", "unit": "1", "minimum": -1.0, "maximum": 1.0, "default": null, "names": {}}] },
  load_autopilot_parameters: { id: 59, doc: "Ask for the 17 parameters; answered by autopilot_parameters.", extension: false, confirm: "frame", arguments: [] },
  set_k_elev: { id: 60, doc: "Set the parameter k_elev.", extension: false, confirm: "read_back", arguments: [{"name": "value", "kind": "number", "unit": "1", "minimum": 0.0, "maximum": 99.99, "default": 1.0, "names": {}}] },
  set_k_airln: { id: 61, doc: "Set the parameter k_airln.", extension: false, confirm: "read_back", arguments: [{"name": "value", "kind": "number", "unit": "1", "minimum": 0.0, "maximum": 99.99, "default": 0.6, "names": {}}] },
  set_k_rudder: { id: 62, doc: "Set the parameter k_rudder.", extension: false, confirm: "read_back", arguments: [{"name": "value", "kind": "number", "unit": "1", "minimum": 0.0, "maximum": 99.99, "default": 1.0, "names": {}}] },
  set_k_int_pitch: { id: 63, doc: "Set the parameter k_int_pitch.", extension: false, confirm: "read_back", arguments: [{"name": "value", "kind": "number", "unit": "1", "minimum": 0.0, "maximum": 99.99, "default": 0.6, "names": {}}] },
  set_k_div_P_init: { id: 64, doc: "Set the parameter k_div_P_init.", extension: false, confirm: "read_back", arguments: [{"name": "value", "kind": "number", "unit": "1", "minimum": 0.1, "maximum": 99.99, "default": 0.5, "names": {}}] },
  set_k_div_P_speed: { id: 65, doc: "Set the parameter k_div_P_speed.", extension: false, confirm: "read_back", arguments: [{"name": "value", "kind": "number", "unit": "1", "minimum": 10.0, "maximum": 99.99, "default": 30.0, "names": {}}] },
  set_k_div_Q_init: { id: 66, doc: "Set the parameter k_div_Q_init.", extension: false, confirm: "read_back", arguments: [{"name": "value", "kind": "number", "unit": "1", "minimum": 0.1, "maximum": 99.99, "default": 0.2, "names": {}}] },
  set_k_div_Q_speed: { id: 67, doc: "Set the parameter k_div_Q_speed.", extension: false, confirm: "read_back", arguments: [{"name": "value", "kind": "number", "unit": "1", "minimum": 10.0, "maximum": 99.99, "default": 40.0, "names": {}}] },
  set_k_div_R_init: { id: 68, doc: "Set the parameter k_div_R_init.", extension: false, confirm: "read_back", arguments: [{"name": "value", "kind": "number", "unit": "1", "minimum": 0.1, "maximum": 99.99, "default": 0.1, "names": {}}] },
  set_k_div_R_speed: { id: 69, doc: "Set the parameter k_div_R_speed.", extension: false, confirm: "read_back", arguments: [{"name": "value", "kind": "number", "unit": "1", "minimum": 10.0, "maximum": 99.99, "default": 35.0, "names": {}}] },
  set_k_div_velocidad: { id: 70, doc: "Set the parameter k_div_velocidad.", extension: false, confirm: "read_back", arguments: [{"name": "value", "kind": "integer", "unit": "1", "minimum": 10, "maximum": 10000, "default": 700, "names": {}}] },
  set_k_roll: { id: 71, doc: "Set the parameter k_roll.", extension: false, confirm: "read_back", arguments: [{"name": "value", "kind": "number", "unit": "1", "minimum": 0.0, "maximum": 99.99, "default": 2.0, "names": {}}] },
  set_k_heading: { id: 72, doc: "Set the parameter k_heading.", extension: false, confirm: "read_back", arguments: [{"name": "value", "kind": "number", "unit": "1", "minimum": 0.0, "maximum": 99.99, "default": 0.8, "names": {}}] },
  set_k_pitch: { id: 73, doc: "Set the parameter k_pitch.", extension: false, confirm: "read_back", arguments: [{"name": "value", "kind": "number", "unit": "1", "minimum": 0.0, "maximum": 99.99, "default": 2.0, "names": {}}] },
  set_k_VVI: { id: 74, doc: "Set the parameter k_VVI.", extension: false, confirm: "read_back", arguments: [{"name": "value", "kind": "number", "unit": "1", "minimum": 0.0, "maximum": 99.99, "default": 0.1, "names": {}}] },
  set_k_altura: { id: 75, doc: "Set the parameter k_altura.", extension: false, confirm: "read_back", arguments: [{"name": "value", "kind": "number", "unit": "1", "minimum": 0.0, "maximum": 99.99, "default": 0.06, "names": {}}] },
  set_k_int_altura: { id: 76, doc: "Set the parameter k_int_altura.", extension: false, confirm: "read_back", arguments: [{"name": "value", "kind": "number", "unit": "1", "minimum": 0.0, "maximum": 99.99, "default": 0.06, "names": {}}] },
  capabilities: { id: 256, doc: "Ask what the board can do. No answer in 500 ms means a deployed board: legacy mode.", extension: true, confirm: "frame", arguments: [] },
  store_parameters: { id: 257, doc: "Store the parameters on the board's card, whole or not at all.", extension: true, confirm: "none", arguments: [] },
  select_airspeed_source: { id: 258, doc: "Where the airspeed comes from.", extension: true, confirm: "none", arguments: [{"name": "source", "kind": "integer", "unit": "1", "minimum": 0, "maximum": 1, "default": null, "names": {"gps": 0, "pitot": 1}}] },
  select_altitude_source: { id: 259, doc: "Where the altitude comes from.", extension: true, confirm: "none", arguments: [{"name": "source", "kind": "integer", "unit": "1", "minimum": 0, "maximum": 1, "default": null, "names": {"gps": 0, "barometer": 1}}] },
  mission_begin: { id: 260, doc: "Start to write a plan; the plan in use stays until mission_commit.", extension: true, confirm: "none", arguments: [{"name": "plan", "kind": "integer", "unit": "1", "minimum": 0, "maximum": 1, "default": null, "names": {"flight": 0, "hil": 1}}, {"name": "count", "kind": "integer", "unit": "1", "minimum": 1, "maximum": 100, "default": null, "names": {}}] },
  mission_item: { id: 261, doc: "One waypoint of the plan being written.", extension: true, confirm: "none", arguments: [{"name": "plan", "kind": "integer", "unit": "1", "minimum": 0, "maximum": 1, "default": null, "names": {"flight": 0, "hil": 1}}, {"name": "index", "kind": "integer", "unit": "1", "minimum": 0, "maximum": 99, "default": null, "names": {}}, {"name": "latitude_deg", "kind": "number", "unit": "deg", "minimum": -90.0, "maximum": 90.0, "default": null, "names": {}}, {"name": "longitude_deg", "kind": "number", "unit": "deg", "minimum": -180.0, "maximum": 180.0, "default": null, "names": {}}, {"name": "altitude_ft", "kind": "number", "unit": "ft", "minimum": -2000.0, "maximum": 60000.0, "default": null, "names": {}}, {"name": "speed_kt", "kind": "number", "unit": "kt", "minimum": 0.0, "maximum": 500.0, "default": null, "names": {}}] },
  mission_commit: { id: 262, doc: "The written plan replaces the one in use, whole or not at all; a board with a card keeps it there afterwards.", extension: true, confirm: "none", arguments: [{"name": "plan", "kind": "integer", "unit": "1", "minimum": 0, "maximum": 1, "default": null, "names": {"flight": 0, "hil": 1}}] },
  mission_read: { id: 263, doc: "Ask for a plan; answered by mission_count and its mission_items.", extension: true, confirm: "frame", arguments: [{"name": "plan", "kind": "integer", "unit": "1", "minimum": 0, "maximum": 1, "default": null, "names": {"flight": 0, "hil": 1}}] },
  go_to_waypoint: { id: 264, doc: "The plan goes to this waypoint.", extension: true, confirm: "none", arguments: [{"name": "plan", "kind": "integer", "unit": "1", "minimum": 0, "maximum": 1, "default": null, "names": {"flight": 0, "hil": 1}}, {"name": "index", "kind": "integer", "unit": "1", "minimum": 0, "maximum": 99, "default": null, "names": {}}] },
  hil_steps_on: { id: 265, doc: "Send hil_step after each hil_surfaces, until the line is opened again.", extension: true, confirm: "none", arguments: [] },
  describe: { id: 266, doc: "Ask what the board says about itself; answered by description.", extension: true, confirm: "frame", arguments: [] },
  describe_blocks: { id: 267, doc: "Ask for blocks of the description's table; each is answered by description_block. Blocks that lie behind its end are a bad value.", extension: true, confirm: "frame", arguments: [{"name": "first", "kind": "integer", "unit": "1", "minimum": 0, "maximum": 1023, "default": null, "names": {}}, {"name": "count", "kind": "integer", "unit": "1", "minimum": 1, "maximum": 8, "default": null, "names": {}}] },
  own_gain_get: { id: 268, doc: "Ask for the value of one of the board's own gains; answered by own_gain. A row that is no gain is a bad value.", extension: true, confirm: "frame", arguments: [{"name": "row", "kind": "integer", "unit": "1", "minimum": 0, "maximum": 65535, "default": null, "names": {}}] },
  own_gain_set: { id: 269, doc: "Set one of the board's own gains; answered by own_gain with the value that the board has now, then by the acknowledgement. A value that is out of range, not finite or, in an enum, not whole is a bad value and changes nothing.", extension: true, confirm: "none", arguments: [{"name": "row", "kind": "integer", "unit": "1", "minimum": 0, "maximum": 65535, "default": null, "names": {}}, {"name": "value", "kind": "number", "unit": "1", "minimum": -1e+30, "maximum": 1e+30, "default": null, "names": {}}] },
  own_topics: { id: 270, doc: "Send the board's own topics, each at the period that its row says, until they are switched off or the line is opened again.", extension: true, confirm: "none", arguments: [{"name": "on", "kind": "integer", "unit": "1", "minimum": 0, "maximum": 1, "default": null, "names": {"off": 0, "on": 1}}] },
};

export type ParameterName = "k_int_altura" | "k_altura" | "k_VVI" | "k_pitch" | "k_heading" | "k_roll" | "k_div_velocidad" | "k_div_P_init" | "k_div_P_speed" | "k_div_Q_init" | "k_div_Q_speed" | "k_div_R_init" | "k_div_R_speed" | "k_int_pitch" | "k_elev" | "k_airln" | "k_rudder";

export const PARAMETERS: readonly (ParameterInfo & { readonly name: ParameterName })[] = [
  { name: "k_int_altura", group: "altitude", setId: 76, isInteger: false, default: 0.06, minimum: 0.0, maximum: 99.99, step: 0.001, doc: "Integral gain of the altitude loop, per second, times k_altura." },
  { name: "k_altura", group: "altitude", setId: 75, isInteger: false, default: 0.06, minimum: 0.0, maximum: 99.99, step: 0.001, doc: "Pitch asked for, deg, for each foot of altitude error." },
  { name: "k_VVI", group: "altitude", setId: 74, isInteger: false, default: 0.1, minimum: 0.0, maximum: 99.99, step: 0.01, doc: "Altitude lead, ft, for each ft/min of vertical speed." },
  { name: "k_pitch", group: "altitude", setId: 73, isInteger: false, default: 2.0, minimum: 0.0, maximum: 99.99, step: 0.1, doc: "Elevator command for each radian of pitch error." },
  { name: "k_heading", group: "heading", setId: 72, isInteger: false, default: 0.8, minimum: 0.0, maximum: 99.99, step: 0.01, doc: "Roll asked for, deg, for each degree of track error." },
  { name: "k_roll", group: "heading", setId: 71, isInteger: false, default: 2.0, minimum: 0.0, maximum: 99.99, step: 0.1, doc: "Aileron command for each radian of roll error." },
  { name: "k_div_velocidad", group: "speed", setId: 70, isInteger: true, default: 700, minimum: 10, maximum: 10000, step: 10, doc: "Airspeed error times seconds, kt s, for full throttle travel; an integer on the wire." },
  { name: "k_div_P_init", group: "heading", setId: 64, isInteger: false, default: 0.5, minimum: 0.1, maximum: 99.99, step: 0.01, doc: "Divider of the roll rate at rest." },
  { name: "k_div_P_speed", group: "heading", setId: 65, isInteger: false, default: 30.0, minimum: 10.0, maximum: 99.99, step: 1.0, doc: "Airspeed, kt, which adds 1 to the roll-rate divider." },
  { name: "k_div_Q_init", group: "altitude", setId: 66, isInteger: false, default: 0.2, minimum: 0.1, maximum: 99.99, step: 0.1, doc: "Divider of the pitch rate at rest." },
  { name: "k_div_Q_speed", group: "altitude", setId: 67, isInteger: false, default: 40.0, minimum: 10.0, maximum: 99.99, step: 1.0, doc: "Airspeed, kt, which adds 1 to the pitch-rate divider." },
  { name: "k_div_R_init", group: "rudder", setId: 68, isInteger: false, default: 0.1, minimum: 0.1, maximum: 99.99, step: 0.01, doc: "Divider of the yaw rate at rest." },
  { name: "k_div_R_speed", group: "rudder", setId: 69, isInteger: false, default: 35.0, minimum: 10.0, maximum: 99.99, step: 1.0, doc: "Airspeed, kt, which adds 1 to the yaw-rate divider." },
  { name: "k_int_pitch", group: "altitude", setId: 63, isInteger: false, default: 0.6, minimum: 0.0, maximum: 99.99, step: 0.01, doc: "Autotrim: integral gain of the pitch-rate loop, per second." },
  { name: "k_elev", group: "altitude", setId: 60, isInteger: false, default: 1.0, minimum: 0.0, maximum: 99.99, step: 0.1, doc: "Proportional gain of the pitch-rate loop." },
  { name: "k_airln", group: "heading", setId: 61, isInteger: false, default: 0.6, minimum: 0.0, maximum: 99.99, step: 0.01, doc: "Gain of the roll-rate loop." },
  { name: "k_rudder", group: "rudder", setId: 62, isInteger: false, default: 1.0, minimum: 0.0, maximum: 99.99, step: 0.1, doc: "Gain of the yaw-rate loop." },
];

export const ROUTES: readonly RouteInfo[] = [
  { name: "gando", title: "Gando", planName: 0, loop: true, waypoints: [{"latitude_deg": 27.9515, "longitude_deg": -15.3741, "altitude_ft": 700.0, "speed_kt": 55.0}, {"latitude_deg": 27.9503, "longitude_deg": -15.3573, "altitude_ft": 1000.0, "speed_kt": 55.0}, {"latitude_deg": 27.9239, "longitude_deg": -15.3707, "altitude_ft": 1000.0, "speed_kt": 60.0}, {"latitude_deg": 27.9004, "longitude_deg": -15.3857, "altitude_ft": 1000.0, "speed_kt": 60.0}, {"latitude_deg": 27.895, "longitude_deg": -15.3997, "altitude_ft": 800.0, "speed_kt": 50.0}, {"latitude_deg": 27.9045, "longitude_deg": -15.4041, "altitude_ft": 600.0, "speed_kt": 48.0}, {"latitude_deg": 27.9202, "longitude_deg": -15.3941, "altitude_ft": 350.0, "speed_kt": 45.0}, {"latitude_deg": 27.9319, "longitude_deg": -15.3866, "altitude_ft": 250.0, "speed_kt": 50.0}] },
  { name: "ruta_isla", title: "Ruta Isla", planName: 1, loop: false, waypoints: [{"latitude_deg": 27.99, "longitude_deg": -15.34, "altitude_ft": 1000.0, "speed_kt": 60.0}, {"latitude_deg": 28.06, "longitude_deg": -15.39, "altitude_ft": 1200.0, "speed_kt": 60.0}, {"latitude_deg": 28.13, "longitude_deg": -15.38, "altitude_ft": 1500.0, "speed_kt": 60.0}, {"latitude_deg": 28.2, "longitude_deg": -15.41, "altitude_ft": 1500.0, "speed_kt": 60.0}, {"latitude_deg": 28.17, "longitude_deg": -15.47, "altitude_ft": 1500.0, "speed_kt": 60.0}, {"latitude_deg": 28.175, "longitude_deg": -15.55, "altitude_ft": 1500.0, "speed_kt": 60.0}, {"latitude_deg": 28.185, "longitude_deg": -15.64, "altitude_ft": 1800.0, "speed_kt": 60.0}, {"latitude_deg": 28.175, "longitude_deg": -15.735, "altitude_ft": 1800.0, "speed_kt": 60.0}, {"latitude_deg": 28.1, "longitude_deg": -15.745, "altitude_ft": 2000.0, "speed_kt": 60.0}, {"latitude_deg": 28.045, "longitude_deg": -15.82, "altitude_ft": 2500.0, "speed_kt": 60.0}, {"latitude_deg": 28.0, "longitude_deg": -15.865, "altitude_ft": 2500.0, "speed_kt": 60.0}, {"latitude_deg": 27.88, "longitude_deg": -15.84, "altitude_ft": 2500.0, "speed_kt": 60.0}, {"latitude_deg": 27.8, "longitude_deg": -15.79, "altitude_ft": 2000.0, "speed_kt": 60.0}, {"latitude_deg": 27.765, "longitude_deg": -15.735, "altitude_ft": 1500.0, "speed_kt": 60.0}, {"latitude_deg": 27.735, "longitude_deg": -15.69, "altitude_ft": 1500.0, "speed_kt": 60.0}, {"latitude_deg": 27.715, "longitude_deg": -15.6, "altitude_ft": 1200.0, "speed_kt": 60.0}, {"latitude_deg": 27.745, "longitude_deg": -15.53, "altitude_ft": 1200.0, "speed_kt": 60.0}, {"latitude_deg": 27.775, "longitude_deg": -15.45, "altitude_ft": 1000.0, "speed_kt": 60.0}, {"latitude_deg": 27.85, "longitude_deg": -15.36, "altitude_ft": 1000.0, "speed_kt": 60.0}, {"latitude_deg": 27.9319, "longitude_deg": -15.3866, "altitude_ft": 800.0, "speed_kt": 55.0}] },
  { name: "alternativa", title: "Alternativa", planName: 2, loop: false, waypoints: [{"latitude_deg": 27.88, "longitude_deg": -15.365, "altitude_ft": 800.0, "speed_kt": 55.0}, {"latitude_deg": 27.845, "longitude_deg": -15.365, "altitude_ft": 1000.0, "speed_kt": 60.0}, {"latitude_deg": 27.8, "longitude_deg": -15.41, "altitude_ft": 1200.0, "speed_kt": 60.0}, {"latitude_deg": 27.775, "longitude_deg": -15.47, "altitude_ft": 1500.0, "speed_kt": 60.0}, {"latitude_deg": 27.74, "longitude_deg": -15.545, "altitude_ft": 1500.0, "speed_kt": 65.0}, {"latitude_deg": 27.715, "longitude_deg": -15.6, "altitude_ft": 1500.0, "speed_kt": 65.0}, {"latitude_deg": 27.7, "longitude_deg": -15.52, "altitude_ft": 1200.0, "speed_kt": 65.0}, {"latitude_deg": 27.76, "longitude_deg": -15.4, "altitude_ft": 1200.0, "speed_kt": 60.0}, {"latitude_deg": 27.84, "longitude_deg": -15.33, "altitude_ft": 1000.0, "speed_kt": 60.0}, {"latitude_deg": 27.91, "longitude_deg": -15.34, "altitude_ft": 800.0, "speed_kt": 55.0}, {"latitude_deg": 27.9319, "longitude_deg": -15.3866, "altitude_ft": 600.0, "speed_kt": 50.0}] },
  { name: "vuelo", title: "Vuelo", planName: 3, loop: false, waypoints: [{"latitude_deg": 27.96, "longitude_deg": -15.36, "altitude_ft": 800.0, "speed_kt": 50.0}, {"latitude_deg": 27.985, "longitude_deg": -15.325, "altitude_ft": 1200.0, "speed_kt": 55.0}, {"latitude_deg": 27.965, "longitude_deg": -15.285, "altitude_ft": 1600.0, "speed_kt": 60.0}, {"latitude_deg": 27.93, "longitude_deg": -15.3, "altitude_ft": 2000.0, "speed_kt": 65.0}, {"latitude_deg": 27.905, "longitude_deg": -15.34, "altitude_ft": 2000.0, "speed_kt": 70.0}, {"latitude_deg": 27.87, "longitude_deg": -15.33, "altitude_ft": 1600.0, "speed_kt": 60.0}, {"latitude_deg": 27.865, "longitude_deg": -15.285, "altitude_ft": 1200.0, "speed_kt": 55.0}, {"latitude_deg": 27.895, "longitude_deg": -15.27, "altitude_ft": 1000.0, "speed_kt": 50.0}, {"latitude_deg": 27.92, "longitude_deg": -15.31, "altitude_ft": 800.0, "speed_kt": 45.0}, {"latitude_deg": 27.9319, "longitude_deg": -15.3866, "altitude_ft": 600.0, "speed_kt": 50.0}] },
];

export type XplaneProfile = "xp10" | "xp12";

export const XPLANE_ROWS: Readonly<Record<XplaneProfile, readonly RowInfo[]>> = {
  xp10: [
    { id: 3, name: "speeds", doc: "Speeds.", sent: false, values: [{"index": 0, "name": "indicated_airspeed_kt", "unit": "kt", "doc": "Indicated airspeed."}, {"index": 3, "name": "ground_speed_kt", "unit": "kt", "doc": "Speed over ground. Only the simulator's pace is judged by it: it may be absent."}] },
    { id: 4, name: "mach_vvi_g", doc: "Mach number, vertical speed and load factors.", sent: false, values: [{"index": 0, "name": "mach", "unit": "1", "doc": "Mach number."}, {"index": 2, "name": "vvi_ft_min", "unit": "ft/min", "doc": "Vertical speed."}, {"index": 4, "name": "g_normal", "unit": "1", "doc": "Normal load factor."}, {"index": 5, "name": "g_axial", "unit": "1", "doc": "Axial load factor."}, {"index": 6, "name": "g_side", "unit": "1", "doc": "Side load factor."}] },
    { id: 6, name: "atmosphere", doc: "Ambient air; shown only.", sent: false, values: [{"index": 0, "name": "ambient_pressure_inhg", "unit": "inHg", "doc": "Ambient pressure."}, {"index": 1, "name": "ambient_temperature_degc", "unit": "degC", "doc": "Ambient temperature."}] },
    { id: 8, name: "joystick", doc: "The pilot's stick.", sent: false, values: [{"index": 0, "name": "stick_elevator", "unit": "1", "doc": "Stick, fore and aft."}, {"index": 1, "name": "stick_aileron", "unit": "1", "doc": "Stick, sideways."}, {"index": 2, "name": "stick_rudder", "unit": "1", "doc": "Pedals."}] },
    { id: 11, name: "flight_controls", doc: "Surfaces: shown when received; sent to move them, the other five values -999.", sent: true, values: [{"index": 0, "name": "surface_elevator", "unit": "1", "doc": "Elevator."}, {"index": 1, "name": "surface_aileron", "unit": "1", "doc": "Aileron."}, {"index": 2, "name": "surface_rudder", "unit": "1", "doc": "Rudder."}] },
    { id: 16, name: "angular_velocities", doc: "Rotation in body axes. The order and the unit differ between the profiles.", sent: false, values: [{"index": 0, "name": "q_rad_s", "unit": "rad/s", "doc": "Pitch rate Q."}, {"index": 1, "name": "p_rad_s", "unit": "rad/s", "doc": "Roll rate P."}, {"index": 2, "name": "r_rad_s", "unit": "rad/s", "doc": "Yaw rate R."}] },
    { id: 17, name: "attitude", doc: "Attitude of the airframe.", sent: false, values: [{"index": 0, "name": "pitch_deg", "unit": "deg", "doc": "Pitch angle."}, {"index": 1, "name": "roll_deg", "unit": "deg", "doc": "Roll angle."}, {"index": 2, "name": "true_heading_deg", "unit": "deg", "doc": "True heading."}] },
    { id: 18, name: "alpha_beta_paths", doc: "Angles of the air and of the path. Its ground track wins over row 17's heading for yaw.", sent: false, values: [{"index": 0, "name": "alpha_deg", "unit": "deg", "doc": "Angle of attack."}, {"index": 1, "name": "beta_deg", "unit": "deg", "doc": "Side-slip angle."}, {"index": 2, "name": "horizontal_path_deg", "unit": "deg", "doc": "Ground track."}, {"index": 3, "name": "vertical_path_deg", "unit": "deg", "doc": "Vertical path angle."}] },
    { id: 20, name: "position", doc: "Position and altitudes.", sent: false, values: [{"index": 0, "name": "latitude_deg", "unit": "deg", "doc": "Geodetic latitude."}, {"index": 1, "name": "longitude_deg", "unit": "deg", "doc": "Longitude."}, {"index": 2, "name": "altitude_msl_ft", "unit": "ft", "doc": "True altitude above mean sea level."}, {"index": 5, "name": "altitude_indicated_ft", "unit": "ft", "doc": "Indicated altitude."}] },
    { id: 25, name: "throttle", doc: "Throttle command: the first engine is used when received; sent as eight times the one throttle.", sent: true, values: [{"index": 0, "name": "throttle_command", "unit": "1", "doc": "Throttle command."}] },
  ],
  xp12: [
    { id: 3, name: "speeds", doc: "Speeds.", sent: false, values: [{"index": 0, "name": "indicated_airspeed_kt", "unit": "kt", "doc": "Indicated airspeed."}, {"index": 3, "name": "ground_speed_kt", "unit": "kt", "doc": "Speed over ground. Only the simulator's pace is judged by it: it may be absent."}] },
    { id: 4, name: "mach_vvi_g", doc: "Mach number, vertical speed and load factors.", sent: false, values: [{"index": 0, "name": "mach", "unit": "1", "doc": "Mach number."}, {"index": 2, "name": "vvi_ft_min", "unit": "ft/min", "doc": "Vertical speed."}, {"index": 4, "name": "g_normal", "unit": "1", "doc": "Normal load factor."}, {"index": 5, "name": "g_axial", "unit": "1", "doc": "Axial load factor."}, {"index": 6, "name": "g_side", "unit": "1", "doc": "Side load factor."}] },
    { id: 6, name: "atmosphere", doc: "Ambient air; shown only.", sent: false, values: [{"index": 0, "name": "ambient_pressure_inhg", "unit": "inHg", "doc": "Ambient pressure."}, {"index": 1, "name": "ambient_temperature_degc", "unit": "degC", "doc": "Ambient temperature."}] },
    { id: 8, name: "joystick", doc: "The pilot's stick.", sent: false, values: [{"index": 0, "name": "stick_elevator", "unit": "1", "doc": "Stick, fore and aft."}, {"index": 1, "name": "stick_aileron", "unit": "1", "doc": "Stick, sideways."}, {"index": 2, "name": "stick_rudder", "unit": "1", "doc": "Pedals."}] },
    { id: 11, name: "flight_controls", doc: "Surfaces: shown when received; sent to move them, the other five values -999.", sent: true, values: [{"index": 0, "name": "surface_elevator", "unit": "1", "doc": "Elevator."}, {"index": 1, "name": "surface_aileron", "unit": "1", "doc": "Aileron."}, {"index": 2, "name": "surface_rudder", "unit": "1", "doc": "Rudder."}] },
    { id: 16, name: "angular_velocities", doc: "Rotation in body axes. The order and the unit differ between the profiles.", sent: false, values: [{"index": 0, "name": "p_deg_s", "unit": "deg/s", "doc": "Roll rate P."}, {"index": 1, "name": "q_deg_s", "unit": "deg/s", "doc": "Pitch rate Q."}, {"index": 2, "name": "r_deg_s", "unit": "deg/s", "doc": "Yaw rate R."}] },
    { id: 17, name: "attitude", doc: "Attitude of the airframe.", sent: false, values: [{"index": 0, "name": "pitch_deg", "unit": "deg", "doc": "Pitch angle."}, {"index": 1, "name": "roll_deg", "unit": "deg", "doc": "Roll angle."}, {"index": 2, "name": "true_heading_deg", "unit": "deg", "doc": "True heading."}] },
    { id: 18, name: "alpha_beta_paths", doc: "Angles of the air and of the path. Its ground track wins over row 17's heading for yaw.", sent: false, values: [{"index": 0, "name": "alpha_deg", "unit": "deg", "doc": "Angle of attack."}, {"index": 1, "name": "beta_deg", "unit": "deg", "doc": "Side-slip angle."}, {"index": 2, "name": "horizontal_path_deg", "unit": "deg", "doc": "Ground track."}, {"index": 3, "name": "vertical_path_deg", "unit": "deg", "doc": "Vertical path angle."}] },
    { id: 20, name: "position", doc: "Position and altitudes.", sent: false, values: [{"index": 0, "name": "latitude_deg", "unit": "deg", "doc": "Geodetic latitude."}, {"index": 1, "name": "longitude_deg", "unit": "deg", "doc": "Longitude."}, {"index": 2, "name": "altitude_msl_ft", "unit": "ft", "doc": "True altitude above mean sea level."}, {"index": 5, "name": "altitude_indicated_ft", "unit": "ft", "doc": "Indicated altitude."}] },
    { id: 25, name: "throttle", doc: "Throttle command: the first engine is used when received; sent as eight times the one throttle.", sent: true, values: [{"index": 0, "name": "throttle_command", "unit": "1", "doc": "Throttle command."}] },
  ],
};
