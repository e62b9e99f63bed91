/// True position and motion of the modelled aircraft, which the sensors measure with their errors.
#ifndef SIM_TRUTH_H
#define SIM_TRUTH_H

/// Body rates P, Q, R; angles and signs as in the telemetry.
typedef struct
{
    double latitude_deg;
    double longitude_deg;
    float altitude_m; ///< above mean sea level
    float climb_m_s;
    float airspeed_m_s; ///< indicated
    float yaw_deg;      ///< true heading, or the ground track if the simulator sends that, 0..360
    float pitch_deg;
    float roll_deg;
    float ground_speed_m_s;
    float track_deg; ///< of the path over the ground, 0..360
    float p_rad_s;
    float q_rad_s;
    float r_rad_s;
} sim_truth_t;

#endif
