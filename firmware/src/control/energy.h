/// Altitude and speed by total energy: the throttle sets how quickly height and speed together grow, the pitch how the
/// climb follows the altitude. Where the throttle is at its end, the speed comes before the altitude.
///
/// Altitudes ft, climb m/s up inside, angles deg (pitch up, roll right +), speeds kt indicated. Source: Lambregts,
/// "Vertical flight path and speed control autopilot design using total energy principles", 1983.
#ifndef CONTROL_ENERGY_H
#define CONTROL_ENERGY_H

#include <stdbool.h>

typedef struct
{
    float k_climb_per_s;      ///< climb per altitude error
    float k_path;             ///< path angle per path angle error
    float k_int_path_per_s;   ///< pitch per path angle error and second
    float k_pitch;            ///< elevator command per rad of pitch error
    float k_accelerate_per_s; ///< acceleration per speed error
    float k_feed_s_per_m;     ///< throttle per m/s of wanted energy rate, as height
    float k_energy_s_per_m;   ///< the same per error of it
    float k_int_energy_per_m; ///< that per second
    float climb_limit_ft_min; ///< up
    float sink_limit_ft_min;  ///< down, > 0
    float load_limit_g;       ///< how far the load factor may be pulled or pushed from that of the turn
} energy_gains_t;

typedef struct
{
    float pitch_trim_deg; ///< pitch less path angle
    float pitch_d_deg;    ///< wanted pitch
    float climb_d_m_s;    ///< wanted climb
    float throttle_trim;  ///< integral, 0..1
    float throttle;       ///< 0..1
    float speed_m_s;      ///< smoothed, for the acceleration
    float acceleration_m_s2;
    float lack_kt;   ///< smoothed speed error, + too slow
    bool is_limited; ///< the engine gives less than altitude and speed need, or the descent is too steep for it
} energy_state_t;

typedef struct
{
    float altitude_ft;
    float speed_kt;
} energy_target_t;

typedef struct
{
    float altitude_ft;
    float vvi_ft_min;
    float pitch_deg;
    float roll_deg;
    float speed_kt;
    float rate_per_command_rad_s; ///< pitch rate that a full elevator command asks for
    bool frozen;                  ///< integrals keep their value
} energy_input_t;

typedef struct
{
    float elevator; ///< command
    float throttle; ///< 0..1
} energy_command_t;

/// Begin from the present attitude, speed and throttle.
void energy_engage(energy_state_t* state, const energy_input_t* input, float throttle);

/// One step of `dt_s` (>= 0).
energy_command_t energy_update(energy_state_t* state, const energy_gains_t* gains, const energy_target_t* target,
                               const energy_input_t* input, float dt_s);

#endif
