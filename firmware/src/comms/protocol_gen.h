// Made by protocol/generator (emit_c.py). Do not edit: change protocol/definition and run `make generate`.
#ifndef PROTOCOL_GEN_H
#define PROTOCOL_GEN_H

#include <stdint.h>

// Frame: header, type, payload, checksum, end; little-endian 32-bit words.
#define PROTOCOL_TO_PC_HEADER 0x2C54510Du    // as a little-endian word
#define PROTOCOL_TO_BOARD_HEADER 0x2C545123u // as a little-endian word
#define PROTOCOL_END 0x0A0D0A0Du             // as a little-endian word
#define PROTOCOL_TO_PC_TYPE_BIT 0x80000000u  // set in every type word to the PC
#define PROTOCOL_FORBIDDEN_TYPE_BITS 0x70000000u // clear in every type word
#define PROTOCOL_OVERHEAD 16u // bytes of a frame besides its payload
#define PROTOCOL_OPEN_BINARY_MODE "#QT\n"
#define PROTOCOL_TELEMETRY_SIZE_MAX 132u
#define PROTOCOL_COMMAND_SIZE_MAX 60u

/// Payload bytes of a type (without bit 31), or -1 for a type that does not exist.
int32_t protocol_telemetry_size(uint32_t id);
int32_t protocol_command_size(uint32_t id);

/// Little-endian access, for words outside the structures below.
uint16_t protocol_get_u16(const uint8_t* in);
uint32_t protocol_get_u32(const uint8_t* in);
int32_t protocol_get_i32(const uint8_t* in);
float protocol_get_f32(const uint8_t* in);
double protocol_get_f64(const uint8_t* in);
void protocol_put_u16(uint8_t* out, uint16_t value);
void protocol_put_u32(uint8_t* out, uint32_t value);
void protocol_put_i32(uint8_t* out, int32_t value);
void protocol_put_f32(uint8_t* out, float value);
void protocol_put_f64(uint8_t* out, double value);

// Board to PC.
#define MESSAGE_HEARTBEAT_ID 0u
#define MESSAGE_HEARTBEAT_SIZE 12u
#define MESSAGE_AHRS_ID 1u
#define MESSAGE_AHRS_SIZE 12u
#define MESSAGE_INERTIAL_ID 2u
#define MESSAGE_INERTIAL_SIZE 36u
#define MESSAGE_ANALOG_ID 3u
#define MESSAGE_ANALOG_SIZE 40u
#define MESSAGE_SERVOS_IN_ID 4u
#define MESSAGE_SERVOS_IN_SIZE 48u
#define MESSAGE_FLY_BY_WIRE_ID 5u
#define MESSAGE_FLY_BY_WIRE_SIZE 16u
#define MESSAGE_FMS_PLAN_ID 6u
#define MESSAGE_FMS_PLAN_SIZE 20u
#define MESSAGE_FMS_HIL_PLAN_ID 7u
#define MESSAGE_FMS_HIL_PLAN_SIZE 20u
#define MESSAGE_STATISTICS_ID 8u
#define MESSAGE_STATISTICS_SIZE 4u
#define MESSAGE_GPS_ID 9u
#define MESSAGE_GPS_SIZE 32u
#define MESSAGE_HIL_SURFACES_ID 10u
#define MESSAGE_HIL_SURFACES_SIZE 16u
#define MESSAGE_AUTOPILOT_PARAMETERS_ID 11u
#define MESSAGE_AUTOPILOT_PARAMETERS_SIZE 68u
#define MESSAGE_CAPABILITIES_ID 0x100u
#define MESSAGE_CAPABILITIES_SIZE 44u
#define MESSAGE_ACKNOWLEDGEMENT_ID 0x101u
#define MESSAGE_ACKNOWLEDGEMENT_SIZE 8u
#define MESSAGE_BOARD_STATUS_ID 0x102u
#define MESSAGE_BOARD_STATUS_SIZE 24u
#define MESSAGE_MISSION_ITEM_ID 0x103u
#define MESSAGE_MISSION_ITEM_SIZE 32u
#define MESSAGE_MISSION_COUNT_ID 0x104u
#define MESSAGE_MISSION_COUNT_SIZE 8u
#define MESSAGE_HIL_STEP_ID 0x105u
#define MESSAGE_HIL_STEP_SIZE 8u
#define MESSAGE_DESCRIPTION_ID 0x106u
#define MESSAGE_DESCRIPTION_SIZE 8u
#define MESSAGE_DESCRIPTION_BLOCK_ID 0x107u
#define MESSAGE_DESCRIPTION_BLOCK_SIZE 132u
#define MESSAGE_OWN_GAIN_ID 0x108u
#define MESSAGE_OWN_GAIN_SIZE 8u

// PC to board.
#define COMMAND_DO_NOTHING_ID 0u
#define COMMAND_DO_NOTHING_SIZE 0u
#define COMMAND_STOP_ID 1u
#define COMMAND_STOP_SIZE 0u
#define COMMAND_START_ID 2u
#define COMMAND_START_SIZE 0u
#define COMMAND_READ_ALL_ID 3u
#define COMMAND_READ_ALL_SIZE 0u
#define COMMAND_RESET_ID 4u
#define COMMAND_RESET_SIZE 0u
#define COMMAND_AHRS_ON_ID 5u
#define COMMAND_AHRS_ON_SIZE 0u
#define COMMAND_AHRS_OFF_ID 6u
#define COMMAND_AHRS_OFF_SIZE 0u
#define COMMAND_INERTIAL_ON_ID 7u
#define COMMAND_INERTIAL_ON_SIZE 0u
#define COMMAND_INERTIAL_OFF_ID 21u
#define COMMAND_INERTIAL_OFF_SIZE 0u
#define COMMAND_ANALOG_ON_ID 22u
#define COMMAND_ANALOG_ON_SIZE 0u
#define COMMAND_ANALOG_OFF_ID 23u
#define COMMAND_ANALOG_OFF_SIZE 0u
#define COMMAND_STATISTICS_ON_ID 24u
#define COMMAND_STATISTICS_ON_SIZE 0u
#define COMMAND_STATISTICS_OFF_ID 25u
#define COMMAND_STATISTICS_OFF_SIZE 0u
#define COMMAND_GPS_ON_ID 26u
#define COMMAND_GPS_ON_SIZE 0u
#define COMMAND_GPS_OFF_ID 27u
#define COMMAND_GPS_OFF_SIZE 0u
#define COMMAND_SERVOS_IN_ON_ID 28u
#define COMMAND_SERVOS_IN_ON_SIZE 0u
#define COMMAND_SERVOS_IN_OFF_ID 29u
#define COMMAND_SERVOS_IN_OFF_SIZE 0u
#define COMMAND_FLY_BY_WIRE_ON_ID 30u
#define COMMAND_FLY_BY_WIRE_ON_SIZE 0u
#define COMMAND_FLY_BY_WIRE_OFF_ID 31u
#define COMMAND_FLY_BY_WIRE_OFF_SIZE 0u
#define COMMAND_FMS_PLAN_ON_ID 33u
#define COMMAND_FMS_PLAN_ON_SIZE 0u
#define COMMAND_FMS_PLAN_OFF_ID 34u
#define COMMAND_FMS_PLAN_OFF_SIZE 0u
#define COMMAND_FMS_HIL_PLAN_ON_ID 35u
#define COMMAND_FMS_HIL_PLAN_ON_SIZE 0u
#define COMMAND_FMS_HIL_PLAN_OFF_ID 36u
#define COMMAND_FMS_HIL_PLAN_OFF_SIZE 0u
#define COMMAND_AUTOPILOT_ON_ID 37u
#define COMMAND_AUTOPILOT_ON_SIZE 0u
#define COMMAND_AUTOPILOT_OFF_ID 38u
#define COMMAND_AUTOPILOT_OFF_SIZE 0u
#define COMMAND_AUTOTRIM_ON_ID 39u
#define COMMAND_AUTOTRIM_ON_SIZE 0u
#define COMMAND_AUTOTRIM_OFF_ID 40u
#define COMMAND_AUTOTRIM_OFF_SIZE 0u
#define COMMAND_FMS_NEXT_WAYPOINT_ID 41u
#define COMMAND_FMS_NEXT_WAYPOINT_SIZE 0u
#define COMMAND_FMS_PREVIOUS_WAYPOINT_ID 42u
#define COMMAND_FMS_PREVIOUS_WAYPOINT_SIZE 0u
#define COMMAND_HIL_FMS_NEXT_WAYPOINT_ID 43u
#define COMMAND_HIL_FMS_NEXT_WAYPOINT_SIZE 0u
#define COMMAND_HIL_FMS_PREVIOUS_WAYPOINT_ID 45u
#define COMMAND_HIL_FMS_PREVIOUS_WAYPOINT_SIZE 0u
#define COMMAND_SET_PARAMETER_TASK_RATE_ID 46u
#define COMMAND_SET_PARAMETER_TASK_RATE_SIZE 4u
#define COMMAND_SET_FMS_TASK_RATE_ID 47u
#define COMMAND_SET_FMS_TASK_RATE_SIZE 4u
#define COMMAND_SET_SERVOS_TASK_RATE_ID 48u
#define COMMAND_SET_SERVOS_TASK_RATE_SIZE 4u
#define COMMAND_EXIT_BINARY_MODE_ID 49u
#define COMMAND_EXIT_BINARY_MODE_SIZE 0u
#define COMMAND_XPLANE_INFO_ID 50u
#define COMMAND_XPLANE_INFO_SIZE 60u
#define COMMAND_HIL_LOAD_GANDO_ID 51u
#define COMMAND_HIL_LOAD_GANDO_SIZE 0u
#define COMMAND_HIL_LOAD_RUTA_ISLA_ID 52u
#define COMMAND_HIL_LOAD_RUTA_ISLA_SIZE 0u
#define COMMAND_HIL_LOAD_ALTERNATIVA_ID 53u
#define COMMAND_HIL_LOAD_ALTERNATIVA_SIZE 0u
#define COMMAND_HIL_LOAD_VUELO_ID 54u
#define COMMAND_HIL_LOAD_VUELO_SIZE 0u
#define COMMAND_CONTROL_SOURCE_ID 55u
#define COMMAND_CONTROL_SOURCE_SIZE 4u
#define COMMAND_SERVOS_CONTROL_MODE_FLY_BY_WIRE_ID 56u
#define COMMAND_SERVOS_CONTROL_MODE_FLY_BY_WIRE_SIZE 0u
#define COMMAND_SERVOS_CONTROL_MODE_HIL_ID 57u
#define COMMAND_SERVOS_CONTROL_MODE_HIL_SIZE 0u
#define COMMAND_SERVO_OUT_ID 58u
#define COMMAND_SERVO_OUT_SIZE 8u
#define COMMAND_LOAD_AUTOPILOT_PARAMETERS_ID 59u
#define COMMAND_LOAD_AUTOPILOT_PARAMETERS_SIZE 0u
#define COMMAND_SET_K_ELEV_ID 60u
#define COMMAND_SET_K_ELEV_SIZE 4u
#define COMMAND_SET_K_AIRLN_ID 61u
#define COMMAND_SET_K_AIRLN_SIZE 4u
#define COMMAND_SET_K_RUDDER_ID 62u
#define COMMAND_SET_K_RUDDER_SIZE 4u
#define COMMAND_SET_K_INT_PITCH_ID 63u
#define COMMAND_SET_K_INT_PITCH_SIZE 4u
#define COMMAND_SET_K_DIV_P_INIT_ID 64u
#define COMMAND_SET_K_DIV_P_INIT_SIZE 4u
#define COMMAND_SET_K_DIV_P_SPEED_ID 65u
#define COMMAND_SET_K_DIV_P_SPEED_SIZE 4u
#define COMMAND_SET_K_DIV_Q_INIT_ID 66u
#define COMMAND_SET_K_DIV_Q_INIT_SIZE 4u
#define COMMAND_SET_K_DIV_Q_SPEED_ID 67u
#define COMMAND_SET_K_DIV_Q_SPEED_SIZE 4u
#define COMMAND_SET_K_DIV_R_INIT_ID 68u
#define COMMAND_SET_K_DIV_R_INIT_SIZE 4u
#define COMMAND_SET_K_DIV_R_SPEED_ID 69u
#define COMMAND_SET_K_DIV_R_SPEED_SIZE 4u
#define COMMAND_SET_K_DIV_VELOCIDAD_ID 70u
#define COMMAND_SET_K_DIV_VELOCIDAD_SIZE 4u
#define COMMAND_SET_K_ROLL_ID 71u
#define COMMAND_SET_K_ROLL_SIZE 4u
#define COMMAND_SET_K_HEADING_ID 72u
#define COMMAND_SET_K_HEADING_SIZE 4u
#define COMMAND_SET_K_PITCH_ID 73u
#define COMMAND_SET_K_PITCH_SIZE 4u
#define COMMAND_SET_K_VVI_ID 74u
#define COMMAND_SET_K_VVI_SIZE 4u
#define COMMAND_SET_K_ALTURA_ID 75u
#define COMMAND_SET_K_ALTURA_SIZE 4u
#define COMMAND_SET_K_INT_ALTURA_ID 76u
#define COMMAND_SET_K_INT_ALTURA_SIZE 4u
#define COMMAND_CAPABILITIES_ID 0x100u
#define COMMAND_CAPABILITIES_SIZE 0u
#define COMMAND_STORE_PARAMETERS_ID 0x101u
#define COMMAND_STORE_PARAMETERS_SIZE 0u
#define COMMAND_SELECT_AIRSPEED_SOURCE_ID 0x102u
#define COMMAND_SELECT_AIRSPEED_SOURCE_SIZE 4u
#define COMMAND_SELECT_ALTITUDE_SOURCE_ID 0x103u
#define COMMAND_SELECT_ALTITUDE_SOURCE_SIZE 4u
#define COMMAND_MISSION_BEGIN_ID 0x104u
#define COMMAND_MISSION_BEGIN_SIZE 8u
#define COMMAND_MISSION_ITEM_ID 0x105u
#define COMMAND_MISSION_ITEM_SIZE 32u
#define COMMAND_MISSION_COMMIT_ID 0x106u
#define COMMAND_MISSION_COMMIT_SIZE 4u
#define COMMAND_MISSION_READ_ID 0x107u
#define COMMAND_MISSION_READ_SIZE 4u
#define COMMAND_GO_TO_WAYPOINT_ID 0x108u
#define COMMAND_GO_TO_WAYPOINT_SIZE 8u
#define COMMAND_HIL_STEPS_ON_ID 0x109u
#define COMMAND_HIL_STEPS_ON_SIZE 0u
#define COMMAND_DESCRIBE_ID 0x10Au
#define COMMAND_DESCRIBE_SIZE 0u
#define COMMAND_DESCRIBE_BLOCKS_ID 0x10Bu
#define COMMAND_DESCRIBE_BLOCKS_SIZE 8u
#define COMMAND_OWN_GAIN_GET_ID 0x10Cu
#define COMMAND_OWN_GAIN_GET_SIZE 4u
#define COMMAND_OWN_GAIN_SET_ID 0x10Du
#define COMMAND_OWN_GAIN_SET_SIZE 8u
#define COMMAND_OWN_TOPICS_ID 0x10Eu
#define COMMAND_OWN_TOPICS_SIZE 4u

#define MESSAGE_HEARTBEAT_BIT_AUTOPILOT_HIL 1
#define MESSAGE_HEARTBEAT_BIT_SOURCE_JOYSTICK 2
/// State of the streams and of the autopilots. Always sent in binary mode, at the parameter task's rate.
typedef struct
{
    int8_t autopilot; ///< Autopilot of the real aircraft is on.
    int8_t autotrim; ///< Elevator autotrim of the real aircraft is on.
    int8_t auto_switch; ///< The transmitter's "automatic" switch is on.
    int8_t servos; ///< Stream servos_in is on.
    int8_t gps; ///< Stream gps is on.
    int8_t statistics; ///< Stream statistics is on.
    int8_t ahrs; ///< Stream ahrs is on.
    int8_t inertial; ///< Stream inertial is on.
    int8_t analog; ///< Stream analog is on.
    int8_t fly_by_wire; ///< Stream fly_by_wire is on.
    int8_t autopilot_hil; ///< Two flags in one byte. Bit 0: Autopilot of the HIL aircraft is on. Bit 1: Control source is the joystick; otherwise the RC transmitter.
    int8_t autotrim_hil; ///< Elevator autotrim of the HIL aircraft is on.
} message_heartbeat_t;

void message_heartbeat_pack(const message_heartbeat_t* values, uint8_t* payload);
void message_heartbeat_unpack(message_heartbeat_t* values, const uint8_t* payload);

/// Attitude estimate of the airframe relative to local north-east-down.
typedef struct
{
    float yaw_deg; ///< Heading; boards send 0..360 or -180..180. Shown as 0..360. [deg] + clockwise from north, seen from above.
    float pitch_deg; ///< Pitch angle. [deg] + nose up.
    float roll_deg; ///< Roll angle. [deg] + right wing down.
} message_ahrs_t;

void message_ahrs_pack(const message_ahrs_t* values, uint8_t* payload);
void message_ahrs_unpack(message_ahrs_t* values, const uint8_t* payload);

/// Calibrated inertial sensors in body axes: x forward, y right, z down.
typedef struct
{
    float gx_rad_s; ///< Roll rate P. [rad/s] + right wing going down.
    float gy_rad_s; ///< Pitch rate Q. [rad/s] + nose going up.
    float gz_rad_s; ///< Yaw rate R. [rad/s] + nose going right.
    float accx_m_s2; ///< Specific force along x. [m/s2] + forward.
    float accy_m_s2; ///< Specific force along y. [m/s2] + right.
    float accz_m_s2; ///< Specific force along z. [m/s2] + down; level flight gives -9.81.
    float magx; ///< Magnetic field along x, normalised to the calibration sphere. + forward.
    float magy; ///< Magnetic field along y, normalised to the calibration sphere. + right.
    float magz; ///< Magnetic field along z, normalised to the calibration sphere. + down.
} message_inertial_t;

void message_inertial_pack(const message_inertial_t* values, uint8_t* payload);
void message_inertial_unpack(message_inertial_t* values, const uint8_t* payload);

/// Analog sensors and air data. A value that the board does not measure is NaN: valid, shown as "no data".
typedef struct
{
    float baro_hpa; ///< Static pressure. [hPa]
    float altitude_m; ///< Barometric altitude above mean sea level. [m] + up.
    float altitude_external_m; ///< Altitude of the external sensor. [m] + up.
    float pitot_pa; ///< Differential pressure of the Pitot tube; noise makes it slightly negative at rest. [Pa] + total above static.
    float calibrated_airspeed_kt; ///< Calibrated airspeed; sensor noise makes it slightly negative at rest. [kt] + forward.
    float alpha_deg; ///< Angle of attack. [deg] + air from below.
    float beta_deg; ///< Side-slip angle. [deg] + air from the right.
    float temperature_degc; ///< Temperature at the board. [degC] + above freezing.
    float battery_v; ///< Battery voltage. [V]
    float vvi_ft_min; ///< Vertical speed. [ft/min] + climb.
} message_analog_t;

void message_analog_pack(const message_analog_t* values, uint8_t* payload);
void message_analog_unpack(message_analog_t* values, const uint8_t* payload);

/// Channels of the RC receiver: 0 aileron, 1 elevator, 2 throttle, 3 rudder, the rest free.
typedef struct
{
    float channel[12]; ///< Position of the channel; throttle is 0..1 of its useful half. + stick right, back, full power or right pedal.
} message_servos_in_t;

void message_servos_in_pack(const message_servos_in_t* values, uint8_t* payload);
void message_servos_in_unpack(message_servos_in_t* values, const uint8_t* payload);

/// The four controls as the fly-by-wire law puts them out. Mind the order: throttle is second.
typedef struct
{
    float aileron; ///< Aileron deflection. + right wing down.
    float throttle; ///< Throttle; the deployed board's field is -1..+1, a throttle uses 0..1 of it. + more power.
    float elevator; ///< Elevator deflection. + nose up.
    float rudder; ///< Rudder deflection. + nose right.
} message_fly_by_wire_t;

void message_fly_by_wire_pack(const message_fly_by_wire_t* values, uint8_t* payload);
void message_fly_by_wire_unpack(message_fly_by_wire_t* values, const uint8_t* payload);

#define MESSAGE_FMS_PLAN_DISTANCE_M_ABSENT (-1)
#define MESSAGE_FMS_PLAN_WAYPOINT_ABSENT (-1)
/// What the flight management system of the real aircraft asks for. Without a plan all of it is absent, without a position bearing and distance are.
typedef struct
{
    float bearing_deg; ///< Great-circle bearing to the waypoint. Shown as 0..360. [deg] + clockwise from north, seen from above.
    float altitude_ft; ///< Altitude asked for, above mean sea level. [ft] + up.
    float speed_kt; ///< Indicated airspeed asked for. [kt] + forward.
    int32_t distance_m; ///< Great-circle distance to the waypoint; the limit is half way round the earth. [m]
    int32_t waypoint; ///< Index of the waypoint, from 0.
} message_fms_plan_t;

void message_fms_plan_pack(const message_fms_plan_t* values, uint8_t* payload);
void message_fms_plan_unpack(message_fms_plan_t* values, const uint8_t* payload);

#define MESSAGE_FMS_HIL_PLAN_DISTANCE_M_ABSENT (-1)
#define MESSAGE_FMS_HIL_PLAN_WAYPOINT_ABSENT (-1)
/// What the flight management system of the HIL aircraft asks for; fields as fms_plan.
typedef struct
{
    float bearing_deg; ///< Great-circle bearing to the waypoint. Shown as 0..360. [deg] + clockwise from north, seen from above.
    float altitude_ft; ///< Altitude asked for, above mean sea level. [ft] + up.
    float speed_kt; ///< Indicated airspeed asked for. [kt] + forward.
    int32_t distance_m; ///< Great-circle distance to the waypoint; the limit is half way round the earth. [m]
    int32_t waypoint; ///< Index of the waypoint, from 0.
} message_fms_hil_plan_t;

void message_fms_hil_plan_pack(const message_fms_hil_plan_t* values, uint8_t* payload);
void message_fms_hil_plan_unpack(message_fms_hil_plan_t* values, const uint8_t* payload);

/// Load of the board's two processors.
typedef struct
{
    int16_t sensor_dsc_percent; ///< CPU load of the sensor processor. [%]
    int16_t control_dsc_percent; ///< CPU load of the control processor. [%]
} message_statistics_t;

void message_statistics_pack(const message_statistics_t* values, uint8_t* payload);
void message_statistics_unpack(message_statistics_t* values, const uint8_t* payload);

/// Position of the GPS receiver. Single precision resolves 1-2 m: the board's limit.
typedef struct
{
    float latitude_deg; ///< Geodetic latitude, WGS84. [deg] + north.
    float longitude_deg; ///< Longitude, WGS84. [deg] + east.
    float altitude_m; ///< Altitude above mean sea level. [m] + up.
    float speed_kt; ///< Ground speed. [kt]
    float heading_deg; ///< Ground track. Shown as 0..360. [deg] + clockwise from north, seen from above.
    int32_t satellites; ///< Satellites used: ASCII digits as received, units in the low byte, tens in the next ('8' is 0x38, "12" is 0x3132).
    int32_t fix; ///< Kind of position fix: an ASCII digit, '0' for none.
    int32_t valid; ///< Receiver status: ASCII 'A' valid, 'V' void.
} message_gps_t;

void message_gps_pack(const message_gps_t* values, uint8_t* payload);
void message_gps_unpack(message_gps_t* values, const uint8_t* payload);

/// What the board wants the simulator's surfaces to be.
typedef struct
{
    float elevator; ///< Elevator deflection. + nose up.
    float aileron; ///< Aileron deflection. + right wing down.
    float rudder; ///< Rudder deflection. + nose right.
    float throttle; ///< Throttle. + more power.
} message_hil_surfaces_t;

void message_hil_surfaces_pack(const message_hil_surfaces_t* values, uint8_t* payload);
void message_hil_surfaces_unpack(message_hil_surfaces_t* values, const uint8_t* payload);

/// The 17 gains, in answer to load_autopilot_parameters. One of them is an integer.
typedef struct
{
    float k_int_altura; ///< Integral gain of the altitude loop, per second, times k_altura.
    float k_altura; ///< Pitch asked for, deg, for each foot of altitude error.
    float k_VVI; ///< Altitude lead, ft, for each ft/min of vertical speed.
    float k_pitch; ///< Elevator command for each radian of pitch error.
    float k_heading; ///< Roll asked for, deg, for each degree of track error.
    float k_roll; ///< Aileron command for each radian of roll error.
    int32_t k_div_velocidad; ///< Airspeed error times seconds, kt s, for full throttle travel; an integer on the wire.
    float k_div_P_init; ///< Divider of the roll rate at rest.
    float k_div_P_speed; ///< Airspeed, kt, which adds 1 to the roll-rate divider.
    float k_div_Q_init; ///< Divider of the pitch rate at rest.
    float k_div_Q_speed; ///< Airspeed, kt, which adds 1 to the pitch-rate divider.
    float k_div_R_init; ///< Divider of the yaw rate at rest.
    float k_div_R_speed; ///< Airspeed, kt, which adds 1 to the yaw-rate divider.
    float k_int_pitch; ///< Autotrim: integral gain of the pitch-rate loop, per second.
    float k_elev; ///< Proportional gain of the pitch-rate loop.
    float k_airln; ///< Gain of the roll-rate loop.
    float k_rudder; ///< Gain of the yaw-rate loop.
} message_autopilot_parameters_t;

void message_autopilot_parameters_pack(const message_autopilot_parameters_t* values, uint8_t* payload);
void message_autopilot_parameters_unpack(message_autopilot_parameters_t* values, const uint8_t* payload);

#define MESSAGE_CAPABILITIES_BIT_HAS_ACKNOWLEDGEMENTS 1
#define MESSAGE_CAPABILITIES_BIT_HAS_STORE 2
#define MESSAGE_CAPABILITIES_BIT_HAS_SOURCES 4
#define MESSAGE_CAPABILITIES_BIT_HAS_MISSIONS 8
#define MESSAGE_CAPABILITIES_BIT_HAS_CARD_ALARM 16
#define MESSAGE_CAPABILITIES_BIT_HAS_HIL_STEPS 32
#define MESSAGE_CAPABILITIES_BIT_DESCRIBES_ITSELF 64
/// Answer to the command capabilities.
typedef struct
{
    int32_t protocol_version; ///< Version of the extensions; 1.
    int32_t features; ///< What the board can do; unknown bits are ignored. Bit 0: Commands are acknowledged. Bit 1: Parameters can be stored on the board's card. Bit 2: Airspeed and altitude sources can be selected. Bit 3: Missions can be written and read. Bit 4: What the card holds cannot be used, or could not be stored. When this changes the board sends capabilities again. Bit 5: The times of the steps of the HIL loop can be told (hil_steps_on). Bit 6: The board tells its own gains and topics: their names, units and ranges (describe), and their values (own_gain_get, own_gain_set).
    char firmware_name[16]; ///< Name of the firmware, zero padded.
    char firmware_version[16]; ///< Version of the firmware, zero padded.
    int32_t uptime_ms; ///< Time since the board started. [ms]
} message_capabilities_t;

void message_capabilities_pack(const message_capabilities_t* values, uint8_t* payload);
void message_capabilities_unpack(message_capabilities_t* values, const uint8_t* payload);

#define MESSAGE_ACKNOWLEDGEMENT_RESULT_DONE 0
#define MESSAGE_ACKNOWLEDGEMENT_RESULT_BAD_VALUE 1
#define MESSAGE_ACKNOWLEDGEMENT_RESULT_BAD_STATE 2
#define MESSAGE_ACKNOWLEDGEMENT_RESULT_UNKNOWN 3
#define MESSAGE_ACKNOWLEDGEMENT_RESULT_STORAGE_FAILED 4
/// Result of a command; sent for every command but do_nothing and xplane_info once the station has asked for capabilities.
typedef struct
{
    int32_t command_type; ///< Type of the command which this answers.
    int32_t result; ///< What became of it.
} message_acknowledgement_t;

void message_acknowledgement_pack(const message_acknowledgement_t* values, uint8_t* payload);
void message_acknowledgement_unpack(message_acknowledgement_t* values, const uint8_t* payload);

#define MESSAGE_BOARD_STATUS_AIRSPEED_SOURCE_GPS 0
#define MESSAGE_BOARD_STATUS_AIRSPEED_SOURCE_PITOT 1
#define MESSAGE_BOARD_STATUS_ALTITUDE_SOURCE_GPS 0
#define MESSAGE_BOARD_STATUS_ALTITUDE_SOURCE_BAROMETER 1
#define MESSAGE_BOARD_STATUS_SERVOS_CONTROL_MODE_FLY_BY_WIRE 0
#define MESSAGE_BOARD_STATUS_SERVOS_CONTROL_MODE_HIL 1
#define MESSAGE_BOARD_STATUS_HIL_PLAN_NAME_NONE (-1)
#define MESSAGE_BOARD_STATUS_HIL_PLAN_NAME_GANDO 0
#define MESSAGE_BOARD_STATUS_HIL_PLAN_NAME_RUTA_ISLA 1
#define MESSAGE_BOARD_STATUS_HIL_PLAN_NAME_ALTERNATIVA 2
#define MESSAGE_BOARD_STATUS_HIL_PLAN_NAME_VUELO 3
/// State that the heartbeat has no room for; once a second.
typedef struct
{
    int32_t airspeed_source; ///< Where the airspeed comes from.
    int32_t altitude_source; ///< Where the altitude comes from.
    int32_t servos_control_mode; ///< What drives the servo outputs.
    int32_t hil_plan_name; ///< Which of the four routes the HIL plan is; none for an uploaded or absent plan.
    uint32_t frames_received; ///< Good frames since the start of the board.
    uint32_t frames_rejected; ///< Refused frames since the start of the board.
} message_board_status_t;

void message_board_status_pack(const message_board_status_t* values, uint8_t* payload);
void message_board_status_unpack(message_board_status_t* values, const uint8_t* payload);

#define MESSAGE_MISSION_ITEM_PLAN_FLIGHT 0
#define MESSAGE_MISSION_ITEM_PLAN_HIL 1
/// One waypoint, in answer to mission_read, after mission_count.
typedef struct
{
    int32_t plan; ///< Which plan.
    int32_t index; ///< Place in the plan, from 0.
    double latitude_deg; ///< Geodetic latitude, WGS84. [deg] + north.
    double longitude_deg; ///< Longitude, WGS84. [deg] + east.
    float altitude_ft; ///< Altitude above mean sea level. [ft] + up.
    float speed_kt; ///< Indicated airspeed. [kt] + forward.
} message_mission_item_t;

void message_mission_item_pack(const message_mission_item_t* values, uint8_t* payload);
void message_mission_item_unpack(message_mission_item_t* values, const uint8_t* payload);

#define MESSAGE_MISSION_COUNT_PLAN_FLIGHT 0
#define MESSAGE_MISSION_COUNT_PLAN_HIL 1
/// Number of waypoints that follow, in answer to mission_read.
typedef struct
{
    int32_t plan; ///< Which plan.
    int32_t count; ///< Waypoints of the plan; 0 for an empty one.
} message_mission_count_t;

void message_mission_count_pack(const message_mission_count_t* values, uint8_t* payload);
void message_mission_count_unpack(message_mission_count_t* values, const uint8_t* payload);

/// When and by how much the HIL loop was stepped; after each hil_surfaces, from hil_steps_on until the line is opened again. With it a recording can be flown again to the last bit.
typedef struct
{
    uint32_t clock_ms; ///< The board's clock when it took the command 50 which hil_surfaces answered. [ms]
    float step_s; ///< Time that the laws integrated; 0 for a repeat, a refused command, and a step after a pause. [s]
} message_hil_step_t;

void message_hil_step_pack(const message_hil_step_t* values, uint8_t* payload);
void message_hil_step_unpack(message_hil_step_t* values, const uint8_t* payload);

/// What the board says about itself, in answer to describe. A station that has the table with this checksum asks for no block of it.
typedef struct
{
    int32_t table_size; ///< Bytes of the table of rows.
    uint32_t table_crc32; ///< CRC-32 (IEEE 802.3) of the table.
} message_description_t;

void message_description_pack(const message_description_t* values, uint8_t* payload);
void message_description_unpack(message_description_t* values, const uint8_t* payload);

/// 128 bytes of the table of rows, in answer to describe_blocks. The table changes with the firmware alone.
typedef struct
{
    int32_t block; ///< Its number, from 0.
    uint32_t words[32]; ///< The table's bytes in their order; zeros behind its end.
} message_description_block_t;

void message_description_block_pack(const message_description_block_t* values, uint8_t* payload);
void message_description_block_unpack(message_description_block_t* values, const uint8_t* payload);

/// The value that one of the board's own gains has, in answer to own_gain_get and own_gain_set, after a refused one too.
typedef struct
{
    int32_t row; ///< The gain's row in the description.
    float value; ///< In the row's unit; of an enum, the place of its text, from 0. + as the row says.
} message_own_gain_t;

void message_own_gain_pack(const message_own_gain_t* values, uint8_t* payload);
void message_own_gain_unpack(message_own_gain_t* values, const uint8_t* payload);

#define COMMAND_SET_PARAMETER_TASK_RATE_PERIOD_MS_MINIMUM 20
#define COMMAND_SET_PARAMETER_TASK_RATE_PERIOD_MS_MAXIMUM 10000
#define COMMAND_SET_PARAMETER_TASK_RATE_PERIOD_MS_DEFAULT 100
/// Period of the task that sends heartbeat, ahrs, inertial and analog.
typedef struct
{
    int32_t period_ms; ///< Time between two runs of the task. [ms]
} command_set_parameter_task_rate_t;

void command_set_parameter_task_rate_pack(const command_set_parameter_task_rate_t* values, uint8_t* payload);
void command_set_parameter_task_rate_unpack(command_set_parameter_task_rate_t* values, const uint8_t* payload);

#define COMMAND_SET_FMS_TASK_RATE_PERIOD_MS_MINIMUM 50
#define COMMAND_SET_FMS_TASK_RATE_PERIOD_MS_MAXIMUM 10000
#define COMMAND_SET_FMS_TASK_RATE_PERIOD_MS_DEFAULT 100
/// Period of the task that sends fms_plan, fms_hil_plan, statistics and gps.
typedef struct
{
    int32_t period_ms; ///< Time between two runs of the task. [ms]
} command_set_fms_task_rate_t;

void command_set_fms_task_rate_pack(const command_set_fms_task_rate_t* values, uint8_t* payload);
void command_set_fms_task_rate_unpack(command_set_fms_task_rate_t* values, const uint8_t* payload);

#define COMMAND_SET_SERVOS_TASK_RATE_PERIOD_MS_MINIMUM 20
#define COMMAND_SET_SERVOS_TASK_RATE_PERIOD_MS_MAXIMUM 10000
#define COMMAND_SET_SERVOS_TASK_RATE_PERIOD_MS_DEFAULT 20
/// Period of the task that sends servos_in and fly_by_wire.
typedef struct
{
    int32_t period_ms; ///< Time between two runs of the task. [ms]
} command_set_servos_task_rate_t;

void command_set_servos_task_rate_pack(const command_set_servos_task_rate_t* values, uint8_t* payload);
void command_set_servos_task_rate_unpack(command_set_servos_task_rate_t* values, const uint8_t* payload);

/// The simulator's state for the HIL loop; answered by hil_surfaces, never acknowledged.
typedef struct
{
    float elevator; ///< The pilot's stick. + nose up.
    float aileron; ///< The pilot's stick. + right wing down.
    float rudder; ///< The pilot's pedals. + nose right.
    float throttle; ///< The pilot's throttle. + more power.
    float gx_rad_s; ///< Roll rate P, body axes. [rad/s] + right wing going down.
    float gy_rad_s; ///< Pitch rate Q, body axes. [rad/s] + nose going up.
    float gz_rad_s; ///< Yaw rate R, body axes. [rad/s] + nose going right.
    float yaw_deg; ///< Ground track where the simulator gives it, else true heading. [deg] + clockwise from north, seen from above.
    float pitch_deg; ///< Pitch angle. [deg] + nose up.
    float roll_deg; ///< Roll angle. [deg] + right wing down.
    float altitude_ft; ///< Indicated altitude. [ft] + up.
    float vvi_ft_min; ///< Vertical speed. [ft/min] + climb.
    float speed_kt; ///< Indicated airspeed. [kt] + forward.
    float latitude_deg; ///< Geodetic latitude. [deg] + north.
    float longitude_deg; ///< Longitude. [deg] + east.
} command_xplane_info_t;

void command_xplane_info_pack(const command_xplane_info_t* values, uint8_t* payload);
void command_xplane_info_unpack(command_xplane_info_t* values, const uint8_t* payload);

#define COMMAND_CONTROL_SOURCE_SOURCE_RC 0
#define COMMAND_CONTROL_SOURCE_SOURCE_JOYSTICK 1
/// Where stick, autopilot and autotrim come from.
typedef struct
{
    int32_t source; ///< Control source.
} command_control_source_t;

void command_control_source_pack(const command_control_source_t* values, uint8_t* payload);
void command_control_source_unpack(command_control_source_t* values, const uint8_t* payload);

#define COMMAND_SERVO_OUT_SERVO_MINIMUM 0
#define COMMAND_SERVO_OUT_SERVO_MAXIMUM 19
/// Move one servo output.
typedef struct
{
    int32_t servo; ///< Which output.
    float position; ///< Where to. + up; the old station's slider number had the opposite sign.
} command_servo_out_t;

void command_servo_out_pack(const command_servo_out_t* values, uint8_t* payload);
void command_servo_out_unpack(command_servo_out_t* values, const uint8_t* payload);

#define COMMAND_SELECT_AIRSPEED_SOURCE_SOURCE_GPS 0
#define COMMAND_SELECT_AIRSPEED_SOURCE_SOURCE_PITOT 1
/// Where the airspeed comes from.
typedef struct
{
    int32_t source; ///< Airspeed source.
} command_select_airspeed_source_t;

void command_select_airspeed_source_pack(const command_select_airspeed_source_t* values, uint8_t* payload);
void command_select_airspeed_source_unpack(command_select_airspeed_source_t* values, const uint8_t* payload);

#define COMMAND_SELECT_ALTITUDE_SOURCE_SOURCE_GPS 0
#define COMMAND_SELECT_ALTITUDE_SOURCE_SOURCE_BAROMETER 1
/// Where the altitude comes from.
typedef struct
{
    int32_t source; ///< Altitude source.
} command_select_altitude_source_t;

void command_select_altitude_source_pack(const command_select_altitude_source_t* values, uint8_t* payload);
void command_select_altitude_source_unpack(command_select_altitude_source_t* values, const uint8_t* payload);

#define COMMAND_MISSION_BEGIN_PLAN_FLIGHT 0
#define COMMAND_MISSION_BEGIN_PLAN_HIL 1
#define COMMAND_MISSION_BEGIN_COUNT_MINIMUM 1
#define COMMAND_MISSION_BEGIN_COUNT_MAXIMUM 100
/// Start to write a plan; the plan in use stays until mission_commit.
typedef struct
{
    int32_t plan; ///< Which plan.
    int32_t count; ///< Waypoints that will follow.
} command_mission_begin_t;

void command_mission_begin_pack(const command_mission_begin_t* values, uint8_t* payload);
void command_mission_begin_unpack(command_mission_begin_t* values, const uint8_t* payload);

#define COMMAND_MISSION_ITEM_PLAN_FLIGHT 0
#define COMMAND_MISSION_ITEM_PLAN_HIL 1
#define COMMAND_MISSION_ITEM_INDEX_MINIMUM 0
#define COMMAND_MISSION_ITEM_INDEX_MAXIMUM 99
/// One waypoint of the plan being written.
typedef struct
{
    int32_t plan; ///< Which plan.
    int32_t index; ///< Place in the plan, from 0.
    double latitude_deg; ///< Geodetic latitude, WGS84. [deg] + north.
    double longitude_deg; ///< Longitude, WGS84. [deg] + east.
    float altitude_ft; ///< Altitude above mean sea level. [ft] + up.
    float speed_kt; ///< Indicated airspeed. [kt] + forward.
} command_mission_item_t;

void command_mission_item_pack(const command_mission_item_t* values, uint8_t* payload);
void command_mission_item_unpack(command_mission_item_t* values, const uint8_t* payload);

#define COMMAND_MISSION_COMMIT_PLAN_FLIGHT 0
#define COMMAND_MISSION_COMMIT_PLAN_HIL 1
/// The written plan replaces the one in use, whole or not at all; a board with a card keeps it there afterwards.
typedef struct
{
    int32_t plan; ///< Which plan.
} command_mission_commit_t;

void command_mission_commit_pack(const command_mission_commit_t* values, uint8_t* payload);
void command_mission_commit_unpack(command_mission_commit_t* values, const uint8_t* payload);

#define COMMAND_MISSION_READ_PLAN_FLIGHT 0
#define COMMAND_MISSION_READ_PLAN_HIL 1
/// Ask for a plan; answered by mission_count and its mission_items.
typedef struct
{
    int32_t plan; ///< Which plan.
} command_mission_read_t;

void command_mission_read_pack(const command_mission_read_t* values, uint8_t* payload);
void command_mission_read_unpack(command_mission_read_t* values, const uint8_t* payload);

#define COMMAND_GO_TO_WAYPOINT_PLAN_FLIGHT 0
#define COMMAND_GO_TO_WAYPOINT_PLAN_HIL 1
#define COMMAND_GO_TO_WAYPOINT_INDEX_MINIMUM 0
#define COMMAND_GO_TO_WAYPOINT_INDEX_MAXIMUM 99
/// The plan goes to this waypoint.
typedef struct
{
    int32_t plan; ///< Which plan.
    int32_t index; ///< Which waypoint, from 0.
} command_go_to_waypoint_t;

void command_go_to_waypoint_pack(const command_go_to_waypoint_t* values, uint8_t* payload);
void command_go_to_waypoint_unpack(command_go_to_waypoint_t* values, const uint8_t* payload);

#define COMMAND_DESCRIBE_BLOCKS_FIRST_MINIMUM 0
#define COMMAND_DESCRIBE_BLOCKS_FIRST_MAXIMUM 1023
#define COMMAND_DESCRIBE_BLOCKS_COUNT_MINIMUM 1
#define COMMAND_DESCRIBE_BLOCKS_COUNT_MAXIMUM 8
/// Ask for blocks of the description's table; each is answered by description_block. Blocks that lie behind its end are a bad value.
typedef struct
{
    int32_t first; ///< Which block first, from 0.
    int32_t count; ///< How many.
} command_describe_blocks_t;

void command_describe_blocks_pack(const command_describe_blocks_t* values, uint8_t* payload);
void command_describe_blocks_unpack(command_describe_blocks_t* values, const uint8_t* payload);

#define COMMAND_OWN_GAIN_GET_ROW_MINIMUM 0
#define COMMAND_OWN_GAIN_GET_ROW_MAXIMUM 65535
/// Ask for the value of one of the board's own gains; answered by own_gain. A row that is no gain is a bad value.
typedef struct
{
    int32_t row; ///< The gain's row in the description.
} command_own_gain_get_t;

void command_own_gain_get_pack(const command_own_gain_get_t* values, uint8_t* payload);
void command_own_gain_get_unpack(command_own_gain_get_t* values, const uint8_t* payload);

#define COMMAND_OWN_GAIN_SET_ROW_MINIMUM 0
#define COMMAND_OWN_GAIN_SET_ROW_MAXIMUM 65535
/// Set one of the board's own gains; answered by own_gain with the value that the board has now, then by the acknowledgement. A value that is out of range, not finite or, in an enum, not whole is a bad value and changes nothing.
typedef struct
{
    int32_t row; ///< The gain's row in the description.
    float value; ///< In the row's unit; of an enum, the place of its text, from 0. + as the row says.
} command_own_gain_set_t;

void command_own_gain_set_pack(const command_own_gain_set_t* values, uint8_t* payload);
void command_own_gain_set_unpack(command_own_gain_set_t* values, const uint8_t* payload);

#define COMMAND_OWN_TOPICS_ON_OFF 0
#define COMMAND_OWN_TOPICS_ON_ON 1
/// Send the board's own topics, each at the period that its row says, until they are switched off or the line is opened again.
typedef struct
{
    int32_t on; ///< Whether they are sent.
} command_own_topics_t;

void command_own_topics_pack(const command_own_topics_t* values, uint8_t* payload);
void command_own_topics_unpack(command_own_topics_t* values, const uint8_t* payload);

#endif
