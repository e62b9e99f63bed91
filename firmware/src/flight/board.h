/// The board without its operating system: every mode, every command, both control loops. Bytes of frames come in as
/// decoded commands, frames go out through one function that the caller gives.
///
/// Not re-entrant: an application with several tasks guards one `board_t` with one mutex. Nothing blocks but the
/// caller's own `send` and the storage.
#ifndef FLIGHT_BOARD_H
#define FLIGHT_BOARD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "comms/command.h"
#include "comms/frame.h"
#include "comms/protocol_gen.h"
#include "comms/telemetry.h"
#include "flight/control_loop.h"
#include "flight/failsafe.h"
#include "navigation/mission.h"
#include "navigation/plan.h"
#include "params/parameters.h"
#include "records/plan_record.h"
#include "records/record.h"

#define BOARD_FIRMWARE_NAME "epf-board"
#define BOARD_FIRMWARE_VERSION "1.0.0"

enum
{
    board_servo_count = 20,
    board_tick_period_ms = 10 ///< how often `board_tick` wants to be called in binary mode
};

/// Receiver channels (index into `servos_in`). A switch is on above 0.
enum
{
    rc_channel_aileron = 0,
    rc_channel_elevator = 1,
    rc_channel_throttle = 2, ///< 0..1, as the deployed boards send it
    rc_channel_rudder = 3,
    rc_channel_autopilot = 4, ///< the "automatic" switch
    rc_channel_autotrim = 5
};

enum
{
    board_plan_flight = 0,
    board_plan_hil = 1,
    board_plan_count = 2
};

typedef enum
{
    board_source_rc = 0,
    board_source_joystick = 1
} board_source_t;

typedef enum
{
    board_servos_fly_by_wire = 0, ///< outputs 0..3 follow the real aircraft's fly-by-wire
    board_servos_hil = 1          ///< outputs 0..3 follow the surfaces sent to the simulator
} board_servos_mode_t;

/// What the card keeps, each in a file of its own.
typedef enum
{
    board_keeps_parameters,
    board_keeps_flight_plan,
    board_keeps_hil_plan,
    board_keeps_count
} board_keeps_t;

/// Hand one complete frame to the line.
typedef void (*board_send_fn_t)(void* context, const uint8_t* frame, size_t size);

typedef struct
{
    bool legacy;              ///< like a deployed board: no extension exists
    bool may_be_in_flight;    ///< it restarted by itself: a plan of the card would turn back to its first waypoint
    float hil_period_s;       ///< time of one HIL step; 0: measured between the arrivals of command 50
    const storage_t* storage; ///< NULL: there is no card
    bool card_is_silent;      ///< the card was just asked in vain: it is not waited for, and all of it is unreadable
    board_send_fn_t send;
    void* send_context;
} board_config_t;

/// Newest readings of the sensors; the application writes them, the board sends them and flies by them.
typedef struct
{
    message_ahrs_t ahrs;
    message_inertial_t inertial;
    message_analog_t analog;
    message_servos_in_t servos_in;
    message_gps_t gps;
    message_statistics_t statistics;
} board_sensors_t;

typedef struct
{
    board_config_t config;
    board_sensors_t sensors;
    failsafe_t failsafe;
    message_servos_in_t receiver_heard; ///< the newest whole reading of the receiver
    telemetry_schedule_t schedule;
    parameters_t parameters;
    control_loop_gains_t gains; ///< of `parameters`
    board_source_t source;      ///< RC at start, as on deployed boards
    bool hil_autopilot;
    bool hil_autotrim;
    int32_t airspeed_source; ///< 0 GPS, 1 Pitot
    int32_t altitude_source; ///< 0 GPS, 1 barometer
    board_servos_mode_t servos_mode;
    float servo_out[board_servo_count]; ///< -1..+1, as last commanded
    bool servo_is_commanded[board_servo_count];
    plan_t plans[board_plan_count];
    int32_t hil_plan_name; ///< 0..3: which route; -1: none or an uploaded one
    mission_t mission;
    record_state_t kept[board_keeps_count];  ///< what became of each at the last load or store
    bool plan_is_to_store[board_plan_count]; ///< uploaded, and not taken for the card yet
    uint8_t card_room[plan_record_bytes];    ///< belongs to whoever uses the card
    int32_t reading_plan;                    ///< plan being read back, -1: none
    size_t reading_index;
    control_loop_t loops[board_plan_count];
    command_xplane_info_t xplane_info; ///< newest command 50
    bool has_xplane_info;
    uint32_t xplane_info_ms;    ///< when it arrived
    uint32_t xplane_info_count; ///< since start
    uint32_t xplane_info_refused;
    bool has_stepped; ///< the HIL loop has run at least once
    bool extended;    ///< the station has asked for capabilities since it opened the line
    uint32_t frames_received;
    uint32_t frames_rejected;
    uint32_t status_ms; ///< when the last board status was sent
} board_t;

/// What the application has to do after a command.
typedef enum
{
    board_goes_on,
    board_leaves_binary_mode,
    board_resets
} board_action_t;

/// Frames to the board; an unknown type counts as one without payload, so that it can be answered "unknown".
extern const frame_dialect_t board_frames_in;

/// Everything as after power-on, with the card's parameters and plans where it holds whole ones; no plans for a
/// deployed board, nor where it may be in flight.
void board_init(board_t* board, const board_config_t* config);

/// A station sent `#QT\n` (also one that came while binary mode was open already): extensions are to be asked for
/// anew. Modes, plans and streams stay as they are.
void board_open(board_t* board, uint32_t now_ms);

/// Do one command without any answer to it: for the text shell. Answers that are frames of their own (type 11 and
/// others) are sent all the same.
command_result_t board_run_command(board_t* board, uint32_t type_id, const uint8_t* payload, size_t size,
                                   uint32_t now_ms);

/// Do one command from the line, and acknowledge it where the station has asked for that.
board_action_t board_handle_command(board_t* board, uint32_t type_id, const uint8_t* payload, size_t size,
                                    uint32_t now_ms);

/// What is sent by the clock: the board status each second, a plan being read back item by item. Call it each
/// `board_tick_period_ms` while binary mode is open. True while a read-back is under way.
bool board_tick(board_t* board, uint32_t now_ms);

/// Send every stream of `task` that is on. Call it each `board->schedule.period_ms[task]` while binary mode is open.
void board_send_streams(board_t* board, telemetry_task_t task);

/// One step of the real aircraft's loop, from `board->sensors` and the receiver. `dt_s` > 0.
void board_flight_step(board_t* board, float dt_s);

/// Look whether command 50 has stopped. Call it each time before `board_flight_step`.
void board_supervise_hil(board_t* board, uint32_t now_ms);

/// Put the position of every servo output, -1..+1 (throttle 0..1), into `positions`.
void board_servo_positions(const board_t* board, float positions[board_servo_count]);

/// Autopilot and autotrim of the real aircraft: the transmitter's switches.
bool board_flight_autopilot(const board_t* board);
bool board_flight_autotrim(const board_t* board);

/// Counters of the line's decoder, reported in the board status.
void board_note_frames(board_t* board, uint32_t received, uint32_t rejected);

#endif
