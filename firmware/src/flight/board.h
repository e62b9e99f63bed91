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
#include "flight/board_state.h"

enum
{
    board_tick_period_ms = 10 ///< how often `board_tick` wants to be called in binary mode
};

typedef struct
{
    bool legacy;              ///< like a deployed board: no extension exists
    bool may_be_in_flight;    ///< it restarted by itself: the card's plan would lead back to its first waypoint
    float hil_period_s;       ///< time of one HIL step; 0: measured between the arrivals of command 50
    const storage_t* storage; ///< NULL: there is no card
    bool card_is_silent;      ///< the card did not answer just now: it is not asked again, and counts as unreadable
    board_send_fn_t send;
    board_line_is_idle_fn_t is_idle; ///< of the line that `send` gives frames to; NULL: always
    void* send_context;              ///< of both
} board_config_t;

/// What the application has to do after a command.
typedef enum
{
    board_goes_on,
    board_leaves_binary_mode,
    board_resets
} board_action_t;

/// Frames to the board; an unknown type counts as one without payload, so that it can be answered "unknown".
extern const frame_dialect_t board_frames_in;

/// Everything as after power-on, with the card's parameters and plans where it holds complete ones. A deployed board,
/// and one that may be in flight, takes no plans from its card.
void board_init(board_t* board, const board_config_t* config);

/// A station sent `#QT\n` (perhaps while binary mode was open already): it has to ask for extensions anew. Modes, plans
/// and streams stay as they are.
void board_open(board_t* board, uint32_t now_ms);

/// Do one command without acknowledging it: for the text shell. Answers that are frames of their own (type 11 and
/// others) are sent all the same.
command_result_t board_run_command(board_t* board, uint32_t type_id, const uint8_t* payload, size_t size,
                                   uint32_t now_ms);

/// Do one command from the line, and acknowledge it where the station has asked for that.
board_action_t board_handle_command(board_t* board, uint32_t type_id, const uint8_t* payload, size_t size,
                                    uint32_t now_ms);

/// Send what is due by the clock: the board status each second, own topics, a plan being read back item by item, and
/// the board's description block by block. Call it each `board_tick_period_ms` while binary mode is open. True while a
/// plan or the description is being read.
bool board_tick(board_t* board, uint32_t now_ms);

/// Send every stream of `task` that is on. Call it each `board->schedule.period_ms[task]` while binary mode is open.
void board_send_streams(board_t* board, telemetry_task_t task);

/// One step of the real aircraft's loop, from the newest readings in `board->measured.sensors`. `dt_s` > 0.
void board_flight_step(board_t* board, float dt_s);

/// See whether command 50 has stopped. Call it each time before `board_flight_step`.
void board_supervise_hil(board_t* board, uint32_t now_ms);

/// Put the position of every servo output, -1..+1 (throttle 0..1), into `positions`.
void board_servo_positions(const board_t* board, float positions[board_servo_count]);

/// Counters of the line's decoder, reported in the board status.
void board_note_frames(board_t* board, uint32_t received, uint32_t rejected);

#endif
