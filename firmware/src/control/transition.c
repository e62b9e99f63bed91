#include "control/transition.h"

#include <math.h>

// long enough that no surface jumps, short compared with the slowest law (about 10 s)
static const float fade_time_s = 0.7F;

void transition_init(transition_t* transition)
{
    transition->offset = (surfaces_t){0};
}

void transition_begin(transition_t* transition, const surfaces_t* before, const surfaces_t* wanted)
{
    transition->offset = (surfaces_t){
        .elevator = before->elevator - wanted->elevator,
        .aileron = before->aileron - wanted->aileron,
        .rudder = before->rudder - wanted->rudder,
        .throttle = before->throttle - wanted->throttle,
    };
}

surfaces_t transition_update(transition_t* transition, const surfaces_t* wanted, float dt_s)
{
    surfaces_t* const offset = &transition->offset;
    const surfaces_t sum = {
        .elevator = wanted->elevator + offset->elevator,
        .aileron = wanted->aileron + offset->aileron,
        .rudder = wanted->rudder + offset->rudder,
        .throttle = wanted->throttle + offset->throttle,
    };
    const float kept = expf(-dt_s / fade_time_s);
    offset->elevator *= kept;
    offset->aileron *= kept;
    offset->rudder *= kept;
    offset->throttle *= kept;
    return surfaces_in_limits(&sum);
}
