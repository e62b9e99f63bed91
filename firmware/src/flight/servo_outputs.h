/// The board's servo outputs: which aircraft's surfaces they follow, and which of them the station moved by hand.
#ifndef FLIGHT_SERVO_OUTPUTS_H
#define FLIGHT_SERVO_OUTPUTS_H

#include <stdbool.h>
#include <stdint.h>

#include "control/surfaces.h"

enum
{
    board_servo_count = 20
};

typedef enum
{
    board_servos_fly_by_wire = 0, ///< outputs 0..3 follow the real aircraft's fly-by-wire
    board_servos_hil = 1          ///< outputs 0..3 follow the surfaces sent to the simulator
} board_servos_mode_t;

typedef struct
{
    board_servos_mode_t mode;
    float commanded[board_servo_count]; ///< -1..+1, as last moved by hand
    bool is_commanded[board_servo_count];
} servo_outputs_t;

/// Follow the real aircraft's fly-by-wire, nothing moved by hand.
void servo_outputs_init(servo_outputs_t* outputs);

/// Choose what outputs 0..3 follow. Outputs that were moved by hand follow again, too.
void servo_outputs_set_mode(servo_outputs_t* outputs, board_servos_mode_t mode);

/// Move one output by hand. False, and nothing changed, for an output that does not exist or a position beyond -1..+1.
bool servo_outputs_move(servo_outputs_t* outputs, int32_t servo, float position);

/// Put the position of every output, -1..+1 (throttle 0..1), into `positions`.
void servo_outputs_positions(const servo_outputs_t* outputs, const surfaces_t* flight, const surfaces_t* hil,
                             float positions[board_servo_count]);

#endif
