#include "flight/failsafe.h"

#include "common/limit.h"

static const float longest_s = 3600.0F; ///< longer durations are not counted
static const float tolerance_s = 1e-4F; ///< for rounding errors in a sum of steps

const failsafe_row_t failsafe_table[failsafe_count] = {
    [failsafe_simulator_silent] = {"simulator silent", 500, failsafe_flies_on, failsafe_neutral_surfaces},
    [failsafe_receiver_silent] = {"receiver silent", 500, failsafe_flies_on, failsafe_lets_stick_go},
    [failsafe_rates_unknown] = {"rates unknown", 200, failsafe_neutral_surfaces, failsafe_goes_undamped},
    [failsafe_attitude_unknown] = {"attitude unknown", 200, failsafe_neutral_surfaces, failsafe_flies_on},
    [failsafe_altitude_unknown] = {"altitude unknown", 0, failsafe_keeps_altitude, failsafe_flies_on},
};

const surfaces_t failsafe_surfaces = {.elevator = 0.0F, .aileron = 0.0F, .rudder = 0.0F, .throttle = 0.0F};

void failsafe_note(failsafe_t* failsafe, failsafe_cause_t cause, bool is_there, float dt_s)
{
    float* const lasted_s = &failsafe->lasted_s[cause];
    *lasted_s = is_there ? limit_to(*lasted_s + dt_s, 0.0F, longest_s) : 0.0F;
}

bool failsafe_is_active(const failsafe_t* failsafe, failsafe_cause_t cause)
{
    return failsafe->lasted_s[cause] > 0.0F &&
           failsafe->lasted_s[cause] + tolerance_s >= (float)failsafe_table[cause].after_ms / 1000.0F;
}

failsafe_action_t failsafe_action(const failsafe_t* failsafe, failsafe_cause_t cause, bool autopilot)
{
    if (!failsafe_is_active(failsafe, cause))
    {
        return failsafe_flies_on;
    }
    return autopilot ? failsafe_table[cause].autopilot : failsafe_table[cause].pilot;
}
