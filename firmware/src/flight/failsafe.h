/// The failsafes as data: the cause, how long it has to last, and what the board does then with the autopilot on and
/// with a pilot at the stick. `README.md` explains them.
#ifndef FLIGHT_FAILSAFE_H
#define FLIGHT_FAILSAFE_H

#include <stdbool.h>
#include <stdint.h>

#include "control/surfaces.h"

typedef enum
{
    failsafe_simulator_silent, ///< no command 50: neither stick nor state of the simulated aircraft
    failsafe_receiver_silent,  ///< no channels of the pilot's transmitter
    failsafe_rates_unknown,    ///< no gyro
    failsafe_attitude_unknown, ///< neither pitch, roll nor a direction
    failsafe_altitude_unknown, ///< neither barometer nor GPS
    failsafe_count
} failsafe_cause_t;

typedef enum
{
    failsafe_flies_on,         ///< with the remaining measurements
    failsafe_keeps_altitude,   ///< the autopilot flies as if the altitude were the wanted one: level, as trimmed
    failsafe_lets_stick_go,    ///< the stick counts as `failsafe_surfaces`
    failsafe_goes_undamped,    ///< the stick moves the surfaces directly
    failsafe_neutral_surfaces, ///< `failsafe_surfaces`, until the cause is gone
    failsafe_action_count
} failsafe_action_t;

typedef struct
{
    const char* name; ///< for the shell
    uint32_t after_ms;
    failsafe_action_t autopilot;
    failsafe_action_t pilot;
} failsafe_row_t;

/// In the order of `failsafe_cause_t`.
extern const failsafe_row_t failsafe_table[failsafe_count];

/// Surfaces of an aircraft that nobody commands any more: neutral, without throttle, so that it glides.
extern const surfaces_t failsafe_surfaces;

/// How long each cause has lasted.
typedef struct
{
    float lasted_s[failsafe_count];
} failsafe_t;

/// Note whether the cause is present, `dt_s` (>= 0) after the last call. A cause that ends is forgotten at once.
void failsafe_note(failsafe_t* failsafe, failsafe_cause_t cause, bool is_there, float dt_s);

/// Whether it has lasted long enough to act.
bool failsafe_is_active(const failsafe_t* failsafe, failsafe_cause_t cause);

/// What the board has to do now because of `cause`.
failsafe_action_t failsafe_action(const failsafe_t* failsafe, failsafe_cause_t cause, bool autopilot);

#endif
