/// Where down is, by the accelerometer: what it feels less what the flight itself adds.
///
/// In a coordinated turn the felt force stays in the aircraft's own z axis, so an accelerometer alone would call every
/// turn level flight. The air is taken to come from ahead: turning then bends the path as fast as the body turns.
#ifndef ESTIMATION_GRAVITY_H
#define ESTIMATION_GRAVITY_H

#include "estimation/rotation.h"

#define GRAVITY_M_S2 9.80665F

typedef struct
{
    vector_t force_m_s2;     ///< specific force in body axes: 0, 0, -9.8 at rest and level
    vector_t rate_rad_s;     ///< of the body
    float airspeed_m_s;      ///< true
    float acceleration_m_s2; ///< change of the airspeed
} gravity_input_t;

typedef struct
{
    vector_t down; ///< unit vector in body axes
    float trust;   ///< 1 where what is left is as strong as gravity, 0 where it is far from that
} gravity_t;

gravity_t gravity_felt(const gravity_input_t* input);

#endif
