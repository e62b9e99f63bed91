/// A board on the bench: commands in, decoded frames out.
#ifndef SUPPORT_RIG_H
#define SUPPORT_RIG_H

#include "flight/board.h"
#include "support/card.h"
#include "support/line.h"

typedef struct
{
    board_t board;
    board_config_t config; ///< what the board was started with
    line_t out;            ///< what the board sent
    card_t card;
    uint32_t now_ms;
} rig_t;

/// A board as after power-on, line opened; the returned rig is one and the same each time.
rig_t* rig_start(void);

/// The same, as a deployed board.
rig_t* rig_start_legacy(void);

/// The same, without a card.
rig_t* rig_start_without_card(void);

/// The same on a card that is there already; what `rig->card` holds does not matter then.
rig_t* rig_start_on(const storage_t* storage);

/// Send a command; what it answers is in `out`, which is emptied before.
board_action_t rig_send(rig_t* rig, uint32_t type_id, const uint8_t* payload, size_t size);

/// Send a command without payload, with one integer, with two.
board_action_t rig_do(rig_t* rig, uint32_t type_id);
board_action_t rig_do_with(rig_t* rig, uint32_t type_id, int32_t value);
board_action_t rig_do_with_two(rig_t* rig, uint32_t type_id, int32_t first, int32_t second);

/// Send a command and return the result in its acknowledgement, or -1 without one.
int rig_ask(rig_t* rig, uint32_t type_id, const uint8_t* payload, size_t size);
int rig_ask_with(rig_t* rig, uint32_t type_id, int32_t value);
int rig_ask_with_two(rig_t* rig, uint32_t type_id, int32_t first, int32_t second);
int rig_ask_parameter(rig_t* rig, uint32_t type_id, float value);

/// Upload a plan of `count` waypoints that differ from those of another `seed`; the result of its commit.
int rig_upload(rig_t* rig, int32_t plan, int32_t count, uint32_t seed);

/// Waypoint `index` of that plan.
waypoint_t rig_waypoint(uint32_t seed, int32_t index);

/// Put every uploaded plan on the card, as cardTask does; true when all are there.
bool rig_keep_plans(rig_t* rig);

/// Ask for capabilities, so that the board acknowledges from now on; `out` is empty afterwards.
void rig_extend(rig_t* rig);

/// A plausible command 50: level at 1000 ft and 55 kt near the airport, stick in the middle, half throttle.
command_xplane_info_t rig_level_flight(void);

/// Send a command 50 and return the surfaces that answer it.
message_hil_surfaces_t rig_fly(rig_t* rig, const command_xplane_info_t* info);

/// The heartbeat that the board sends now.
message_heartbeat_t rig_heartbeat(rig_t* rig);

#endif
