/// Models of the inertial sensors, the magnetometer and the attitude estimate made of them.
#ifndef SIM_INERTIAL_H
#define SIM_INERTIAL_H

#include <stdbool.h>

#include "comms/protocol_gen.h"
#include "sim_noise.h"
#include "sim_truth.h"

typedef struct
{
    sim_noise_t noise;
    float gyro_bias_rad_s[3]; ///< of this board (its seed), wandering slowly
    float acc_bias_m_s2[3];
    float mag_bias[3];
    float airspeed_m_s; ///< these three: of the last step, for the path's acceleration
    float climb_m_s;
    float track_deg;
    bool has_path;
    float acceleration_m_s2[3]; ///< of the path: ahead, aside, down
    message_ahrs_t estimate;    ///< the filter's attitude, behind the true one
    float drift_deg[3];         ///< its yaw, pitch and roll error
    bool has_estimate;
} sim_inertial_t;

void sim_inertial_init(sim_inertial_t* model, uint32_t seed);

/// One step of `dt_s` (> 0).
void sim_inertial_read(sim_inertial_t* model, const sim_truth_t* truth, float dt_s, message_inertial_t* inertial,
                       message_ahrs_t* ahrs);

#endif
