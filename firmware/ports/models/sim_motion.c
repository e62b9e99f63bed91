#include "sim_motion.h"

#include <math.h>
#include <string.h>

#include "common/angle.h"
#include "navigation/geodesy.h"

static const double rad_per_deg = 0.017453292519943295;

static const uint32_t commands_per_place = 10;
static const float jump_m = 1000.0F;  ///< no aircraft flies that far in ten commands: the simulator moved it elsewhere
static const float standing_m = 1.0F; ///< a shorter way may be rounding: positions are 32-bit floats of degrees
static const float tropopause_m = 11000.0F;

static float north_m(const sim_motion_place_t* from, const sim_motion_place_t* to)
{
    return (float)((to->latitude_deg - from->latitude_deg) * GEODESY_M_PER_DEG);
}

static float east_m(const sim_motion_place_t* from, const sim_motion_place_t* to)
{
    return (float)((to->longitude_deg - from->longitude_deg) * GEODESY_M_PER_DEG * cos(to->latitude_deg * rad_per_deg));
}

static float distance_m(const sim_motion_place_t* from, const sim_motion_place_t* to)
{
    return hypotf(north_m(from, to), east_m(from, to));
}

/// The horizontal part of the true airspeed, in the standard atmosphere.
static float calm_ground_speed_m_s(const sim_truth_t* truth)
{
    const float altitude_m = fminf(fmaxf(truth->altitude_m, 0.0F), tropopause_m);
    const float density_ratio = powf(1.0F - 2.25577e-5F * altitude_m, 4.25588F);
    const float true_m_s = truth->airspeed_m_s / sqrtf(density_ratio);
    return sqrtf(fmaxf(0.0F, true_m_s * true_m_s - truth->climb_m_s * truth->climb_m_s));
}

static void remember(sim_motion_t* motion, const sim_motion_place_t* place)
{
    memmove(motion->places + 1, motion->places, sizeof motion->places - sizeof motion->places[0]);
    motion->places[0] = *place;
    motion->places_held += motion->places_held < sim_motion_places ? 1U : 0U;
    motion->told = 0U;
}

void sim_motion_follow(sim_motion_t* motion, sim_truth_t* truth)
{
    const sim_motion_place_t here = {truth->latitude_deg, truth->longitude_deg};
    if (motion->places_held == 0U || distance_m(&motion->places[0], &here) > jump_m)
    {
        motion->places_held = 0U;
        remember(motion, &here);
        truth->ground_speed_m_s = 0.0F;
        truth->track_deg = truth->yaw_deg;
        return;
    }
    const sim_motion_place_t* const oldest = &motion->places[motion->places_held - 1U];
    if (distance_m(oldest, &here) > standing_m)
    {
        truth->ground_speed_m_s = calm_ground_speed_m_s(truth);
        truth->track_deg = angle_wrap_360(angle_to_deg(atan2f(east_m(oldest, &here), north_m(oldest, &here))));
    }
    else
    {
        truth->ground_speed_m_s = 0.0F;
    }
    motion->told++;
    if (motion->told >= commands_per_place)
    {
        remember(motion, &here);
    }
}
