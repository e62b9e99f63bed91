#include "flight/servo_outputs.h"

#include <stddef.h>
#include <string.h>

#include "flight/board_sensors.h"

/// Outputs that follow an aircraft's surfaces, in the order of the receiver's channels.
enum
{
    driven_servos = 4
};

void servo_outputs_init(servo_outputs_t* outputs)
{
    memset(outputs, 0, sizeof *outputs);
    outputs->mode = board_servos_fly_by_wire;
}

void servo_outputs_set_mode(servo_outputs_t* outputs, board_servos_mode_t mode)
{
    outputs->mode = mode;
    memset(outputs->is_commanded, 0, sizeof outputs->is_commanded);
}

bool servo_outputs_move(servo_outputs_t* outputs, int32_t servo, float position)
{
    // written so that a NaN fails
    const bool allowed = servo >= 0 && servo < board_servo_count && position >= -1.0F && position <= 1.0F;
    if (!allowed)
    {
        return false;
    }
    outputs->commanded[servo] = position;
    outputs->is_commanded[servo] = true;
    return true;
}

void servo_outputs_positions(const servo_outputs_t* outputs, const surfaces_t* flight, const surfaces_t* hil,
                             float positions[board_servo_count])
{
    const surfaces_t* const surfaces = outputs->mode == board_servos_hil ? hil : flight;
    const float driven[driven_servos] = {
        [rc_channel_aileron] = surfaces->aileron,
        [rc_channel_elevator] = surfaces->elevator,
        [rc_channel_throttle] = surfaces->throttle,
        [rc_channel_rudder] = surfaces->rudder,
    };
    for (size_t i = 0; i < board_servo_count; i++)
    {
        const bool follows = i < driven_servos && !outputs->is_commanded[i];
        positions[i] = follows ? driven[i] : outputs->commanded[i];
    }
}
