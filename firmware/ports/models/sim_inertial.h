/// Models of the inertial sensors and the magnetometer: bias, drift with temperature, noise, and a delay of one step.
#ifndef SIM_INERTIAL_H
#define SIM_INERTIAL_H

#include <stdbool.h>

#include "comms/protocol_gen.h"
#include "estimation/magnetic_field.h"
#include "sim_noise.h"
#include "sim_truth.h"

typedef struct
{
    sim_noise_t noise;
    float gyro_bias_rad_s[3]; ///< of this board (from its seed), changing slowly
    float acc_bias_m_s2[3];
    float mag_bias[3];
    magnetic_field_t magnetic; ///< where the aircraft is
    float airspeed_m_s;        ///< these three: of the last step, for the path's acceleration
    float climb_m_s;
    float track_deg;
    float path_age_s; ///< since the path last changed
    bool has_path;
    float acceleration_m_s2[3]; ///< of the path: ahead, right, down
    float gyro_drift_rad_s[3];  ///< added once the board is warm
    float age_s;                ///< since it was switched on
    message_inertial_t sampled; ///< put out in the next step
    bool has_sampled;
} sim_inertial_t;

void sim_inertial_init(sim_inertial_t* model, uint32_t seed);

/// One step of `dt_s` (> 0). Returns the sample of the step before.
void sim_inertial_read(sim_inertial_t* model, const sim_truth_t* truth, float dt_s, message_inertial_t* inertial);

#endif
