/// Model of a GPS receiver: five solutions a second, each put out a fifth of a second late, with an error that wanders.
/// Speed and track are measured directly, as a receiver does by the Doppler effect, and not from two positions and the
/// time between them: the board's time is not the simulator's (see `sim_motion.h`).
#ifndef SIM_GPS_H
#define SIM_GPS_H

#include <stdbool.h>

#include "comms/protocol_gen.h"
#include "sim_noise.h"
#include "sim_truth.h"

typedef struct
{
    sim_noise_t noise;
    float north_error_m;
    float east_error_m;
    float up_error_m;
    float satellites_wander; ///< rounded and added to the usual number
    float age_s;             ///< of the newest solution
    message_gps_t computed;  ///< the newest solution, put out when the next one is computed
    message_gps_t put_out;
    bool has_solution;
} sim_gps_t;

void sim_gps_init(sim_gps_t* model, uint32_t seed);

/// The newest solution that was put out, `dt_s` (> 0) after the last call.
message_gps_t sim_gps_read(sim_gps_t* model, const sim_truth_t* truth, float dt_s);

#endif
