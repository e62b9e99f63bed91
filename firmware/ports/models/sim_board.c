#include "sim_board.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "common/angle.h"
#include "common/limit.h"
#include "common/units.h"
#include "flight/board_sensors.h"
#include "flight/hil_loop.h"
#include "sim_air.h"
#include "sim_gps.h"
#include "sim_inertial.h"
#include "sim_motion.h"

static const float still_after_s = 1.0F;    ///< with simulator information older than this, the aircraft stands still
static const float receiver_steps = 512.0F; ///< a receiver counts its pulses' lengths, so its channels change in steps
static const float receiver_noise = 0.001F;

/// Gran Canaria (GCLP), at the beginning of runway 03, heading along it.
static const sim_truth_t parked = {
    .latitude_deg = 27.9319, .longitude_deg = -15.3866, .altitude_m = 23.8F, .yaw_deg = 28.0F, .track_deg = 28.0F};

static struct
{
    sim_truth_t truth;
    command_xplane_info_t stick;  ///< the newest command 50: the stick, and what the next one is compared with
    float throttle;               ///< of the simulated motor
    float servo_throttle;         ///< of the real one
    message_servos_in_t switches; ///< of the transmitter, by receiver channel; its sticks follow `stick`
    bool is_transmitter_off;
    bool is_observed;
    float age_s; ///< of the newest simulator information that was no repeat
    sim_motion_t motion;
    sim_noise_t noise;
    sim_inertial_t inertial;
    sim_air_t air;
    sim_gps_t gps;
} sim;

static void observe(void* context, const command_xplane_info_t* info, float throttle)
{
    (void)context;
    const bool is_paused = sim.is_observed && hil_loop_repeats(&sim.stick, info);
    sim.stick = *info;
    sim.throttle = throttle;
    if (is_paused)
    {
        // it ages until the aircraft stands still, so that no gyro turns an aircraft that does not turn
        return;
    }
    sim.truth = (sim_truth_t){
        .latitude_deg = (double)info->latitude_deg,
        .longitude_deg = (double)info->longitude_deg,
        .altitude_m = info->altitude_ft * M_PER_FT,
        .climb_m_s = info->vvi_ft_min * M_S_PER_FT_MIN,
        .airspeed_m_s = info->speed_kt * M_S_PER_KT,
        .yaw_deg = angle_wrap_360(info->yaw_deg),
        .pitch_deg = info->pitch_deg,
        .roll_deg = info->roll_deg,
        .ground_speed_m_s = sim.truth.ground_speed_m_s,
        .track_deg = sim.truth.track_deg,
        .p_rad_s = info->gx_rad_s,
        .q_rad_s = info->gy_rad_s,
        .r_rad_s = info->gz_rad_s,
    };
    sim_motion_follow(&sim.motion, &sim.truth);
    sim.age_s = 0.0F;
    sim.is_observed = true;
}

/// One channel as the receiver measures it.
static float received(float position, float minimum)
{
    const float noisy = limit_to(position, minimum, 1.0F) + sim_noise_normal(&sim.noise, receiver_noise);
    const float steps = (float)(int)(noisy * receiver_steps + (noisy < 0.0F ? -0.5F : 0.5F));
    return limit_to(steps / receiver_steps, minimum, 1.0F);
}

static void read_receiver(message_servos_in_t* receiver)
{
    const size_t channels = sizeof receiver->channel / sizeof receiver->channel[0];
    for (size_t i = 0; i < channels && sim.is_transmitter_off; i++)
    {
        receiver->channel[i] = NAN;
    }
    if (sim.is_transmitter_off)
    {
        return;
    }
    for (size_t i = 0; i < channels; i++)
    {
        receiver->channel[i] = received(sim.switches.channel[i], -1.0F);
    }
    receiver->channel[rc_channel_aileron] = received(sim.stick.aileron, -1.0F);
    receiver->channel[rc_channel_elevator] = received(sim.stick.elevator, -1.0F);
    receiver->channel[rc_channel_throttle] = received(sim.stick.throttle, 0.0F);
    receiver->channel[rc_channel_rudder] = received(sim.stick.rudder, -1.0F);
}

static void read_all(void* context, float dt_s, sensors_reading_t* reading)
{
    (void)context;
    sim.age_s = limit_to(sim.age_s + dt_s, 0.0F, 2.0F * still_after_s);
    const bool is_flying = sim.is_observed && sim.age_s < still_after_s;
    if (!is_flying)
    {
        sim.truth.climb_m_s = 0.0F;
        sim.truth.ground_speed_m_s = 0.0F;
        sim.truth.p_rad_s = 0.0F;
        sim.truth.q_rad_s = 0.0F;
        sim.truth.r_rad_s = 0.0F;
    }
    sim_inertial_read(&sim.inertial, &sim.truth, dt_s, &reading->inertial);
    sim_air_read(&sim.air, &sim.truth, is_flying ? sim.throttle : sim.servo_throttle, dt_s, &reading->analog);
    reading->gps = sim_gps_read(&sim.gps, &sim.truth, dt_s);
    read_receiver(&reading->receiver);
}

static void set_switch(void* context, int32_t channel, float position)
{
    (void)context;
    if (channel == sensors_transmitter)
    {
        sim.is_transmitter_off = position <= 0.0F;
    }
    else
    {
        sim.switches.channel[channel] = position;
    }
}

sensors_t sim_board_sensors(uint32_t seed)
{
    memset(&sim, 0, sizeof sim);
    sim.truth = parked;
    sim.switches.channel[rc_channel_autopilot] = -1.0F;
    sim.switches.channel[rc_channel_autotrim] = -1.0F;
    // Each model has its own noise, so that an additional call of one does not change the others.
    sim_noise_init(&sim.noise, seed);
    sim_inertial_init(&sim.inertial, seed + 1U);
    sim_air_init(&sim.air, seed + 2U);
    sim_gps_init(&sim.gps, seed + 3U);
    return (sensors_t){.context = NULL, .read = read_all, .observe = observe, .set_switch = set_switch};
}

static void write_servos(void* context, const float* positions, size_t count)
{
    (void)context;
    if (count > rc_channel_throttle)
    {
        sim.servo_throttle = limit_to(positions[rc_channel_throttle], 0.0F, 1.0F);
    }
}

servos_t sim_board_servos(void)
{
    return (servos_t){.context = NULL, .write = write_servos};
}
