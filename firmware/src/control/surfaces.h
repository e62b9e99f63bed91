/// What an aircraft is steered by: deflections of the surfaces and the throttle. A stick has the same form.
#ifndef CONTROL_SURFACES_H
#define CONTROL_SURFACES_H

/// -1..+1, throttle 0..1. Elevator + nose up, aileron + right wing down, rudder + nose right.
typedef struct
{
    float elevator;
    float aileron;
    float rudder;
    float throttle;
} surfaces_t;

/// The same, each value limited to its range; NaN counts as 0.
surfaces_t surfaces_in_limits(const surfaces_t* surfaces);

#endif
