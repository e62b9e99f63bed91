/// Holds a line over the ground by banking: a vector field leads onto it, and the bank follows the field's course.
///
/// Angles deg (roll right +, courses clockwise from true north), distances m, speeds m/s. Source: Nelson, Barber,
/// McLain and Beard, "Vector field path following for small unmanned air vehicles", 2006.
#ifndef CONTROL_LINE_FOLLOW_H
#define CONTROL_LINE_FOLLOW_H

#include <stdbool.h>

typedef struct
{
    float bank_limit_deg;
    float approach_time_s;  ///< in which a small distance from the line shrinks to a third
    float k_course_per_s;   ///< turn rate per course error
    float k_bank;           ///< aileron command per rad of bank error
    float k_int_bank_per_s; ///< share of it that is added each second
} line_follow_gains_t;

typedef struct
{
    float roll_d_deg;       ///< wanted bank, which moves no faster than an aircraft rolls
    float aileron_integral; ///< command that holds the bank against a lopsided aircraft
} line_follow_state_t;

typedef struct
{
    float course_deg;      ///< of the line
    float right_m;         ///< of the line is right of it, +
    float curvature_per_m; ///< of the line, + to the right
} line_follow_target_t;

typedef struct
{
    float track_deg; ///< over the ground
    float ground_speed_m_s;
    float roll_deg;
    bool frozen; ///< the integral keeps its value
} line_follow_input_t;

/// Begin from the present bank.
void line_follow_engage(line_follow_state_t* state, float roll_deg);

/// One step of `dt_s` (>= 0). Returns the aileron command.
float line_follow_update(line_follow_state_t* state, const line_follow_gains_t* gains,
                         const line_follow_target_t* target, const line_follow_input_t* input, float dt_s);

#endif
