/// Where down is, by the accelerometer: its reading minus the accelerations of the flight itself.
///
/// In a coordinated turn the felt force stays in the aircraft's own z axis, so an accelerometer alone would take every
/// turn for level flight. The air is assumed to come from ahead: then the path turns as fast as the body does.
#ifndef ESTIMATION_GRAVITY_H
#define ESTIMATION_GRAVITY_H

#include "estimation/rotation.h"

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
    float trust;   ///< 1 where the remaining force is as strong as gravity, 0 where it differs much
} gravity_t;

gravity_t gravity_felt(const gravity_input_t* input);

#endif
