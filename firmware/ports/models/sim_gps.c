#include "sim_gps.h"

#include <math.h>
#include <string.h>

#include "common/angle.h"

static const float kt_per_m_s = 1.943844F;
static const double m_per_deg = 111195.0; ///< of latitude, on the mean sphere
static const double rad_per_deg = 0.017453292519943295;
static const float period_s = 0.2F;

static const float horizontal_error_m = 1.2F;
static const float vertical_error_m = 2.5F;
static const float error_time_s = 60.0F;
static const float speed_noise_kt = 0.15F;
static const float moving_kt = 2.0F; ///< slower than that, a track means nothing
static const float jump_m = 1000.0F; ///< a way in one period that nothing flies: the simulator was put elsewhere

static const int usual_satellites = 10;

void sim_gps_init(sim_gps_t* model, uint32_t seed)
{
    memset(model, 0, sizeof *model);
    sim_noise_init(&model->noise, seed);
}

/// The number as the receiver's ASCII digits: units in the low byte, tens in the next.
static int32_t satellite_digits(int count)
{
    const int tens = count / 10;
    return ('0' + count % 10) | (tens > 0 ? ('0' + tens) << 8 : 0);
}

static float north_m(const sim_gps_place_t* from, const sim_gps_place_t* to)
{
    return (float)((to->latitude_deg - from->latitude_deg) * m_per_deg);
}

static float east_m(const sim_gps_place_t* from, const sim_gps_place_t* to)
{
    return (float)((to->longitude_deg - from->longitude_deg) * m_per_deg * cos(to->latitude_deg * rad_per_deg));
}

static void remember(sim_gps_t* model, const sim_gps_place_t* place)
{
    if (model->places_held > 0 && hypotf(north_m(&model->places[0], place), east_m(&model->places[0], place)) > jump_m)
    {
        model->places_held = 0;
    }
    memmove(model->places + 1, model->places, sizeof model->places - sizeof model->places[0]);
    model->places[0] = *place;
    model->places_held += model->places_held < sim_gps_places ? 1U : 0U;
}

/// Ground speed from the way of up to a second; sets the track while moving.
static float ground_speed_kt(sim_gps_t* model, const sim_truth_t* truth)
{
    const size_t periods = model->places_held - 1;
    if (periods == 0)
    {
        model->heading_deg = truth->yaw_deg;
        return 0.0F;
    }
    const float north = north_m(&model->places[periods], &model->places[0]);
    const float east = east_m(&model->places[periods], &model->places[0]);
    const float speed_kt = hypotf(north, east) / ((float)periods * period_s) * kt_per_m_s;
    if (speed_kt > moving_kt)
    {
        model->heading_deg = angle_wrap_360(angle_to_deg(atan2f(east, north)));
    }
    return speed_kt;
}

static message_gps_t solve(sim_gps_t* model, const sim_truth_t* truth)
{
    sim_noise_t* const noise = &model->noise;
    const sim_gps_place_t place = {truth->latitude_deg, truth->longitude_deg};
    remember(model, &place);
    sim_noise_wander(noise, &model->north_error_m, horizontal_error_m, error_time_s, period_s);
    sim_noise_wander(noise, &model->east_error_m, horizontal_error_m, error_time_s, period_s);
    sim_noise_wander(noise, &model->up_error_m, vertical_error_m, error_time_s, period_s);
    sim_noise_wander(noise, &model->satellites_wander, 0.8F, error_time_s, period_s);
    const float speed_kt = ground_speed_kt(model, truth) + sim_noise_normal(noise, speed_noise_kt);
    const double east_m_per_deg = m_per_deg * cos(place.latitude_deg * rad_per_deg);
    return (message_gps_t){
        .latitude_deg = (float)(place.latitude_deg + (double)model->north_error_m / m_per_deg),
        .longitude_deg = (float)(place.longitude_deg + (double)model->east_error_m / fmax(east_m_per_deg, 1.0)),
        .altitude_m = truth->altitude_m + model->up_error_m,
        .speed_kt = fmaxf(0.0F, speed_kt),
        .heading_deg = model->heading_deg,
        .satellites = satellite_digits(usual_satellites + (int)lroundf(model->satellites_wander)),
        .fix = '1',
        .valid = 'A',
    };
}

message_gps_t sim_gps_read(sim_gps_t* model, const sim_truth_t* truth, float dt_s)
{
    model->age_s += dt_s;
    if (!model->has_solution)
    {
        model->computed = solve(model, truth);
        model->put_out = model->computed;
        model->age_s = 0.0F;
        model->has_solution = true;
    }
    // Half a step of slack: the ages are sums of rounded steps.
    if (model->age_s + dt_s / 2.0F >= period_s)
    {
        model->age_s = 0.0F;
        model->put_out = model->computed;
        model->computed = solve(model, truth);
    }
    return model->put_out;
}
