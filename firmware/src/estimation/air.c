#include "estimation/air.h"

#include <math.h>

static const float sea_level_pa = 101325.0F;
static const float sea_level_sound_m_s = 340.294F;

// Temperature falls by 6.5 K a km from 288.15 K, so p/p0 = (1 - h / 44330.8 m) ^ 5.25588 and
// rho/rho0 = (p/p0) ^ (4.25588 / 5.25588).
static const float height_scale_m = 44330.8F;
static const float height_exponent = 0.190263F;
static const float density_exponent = 0.809737F;

float air_altitude_m(float static_pa)
{
    return height_scale_m * (1.0F - powf(static_pa / sea_level_pa, height_exponent));
}

float air_calibrated_speed_m_s(float pitot_pa)
{
    // Compressible: a0 sqrt(5 ((1 + q / p0) ^ (2/7) - 1)), with expm1 and log1p, because a small q is lost when 1 is
    // added to it.
    const float compression = expm1f(2.0F / 7.0F * log1pf(fabsf(pitot_pa) / sea_level_pa));
    return copysignf(sea_level_sound_m_s * sqrtf(5.0F * compression), pitot_pa);
}

float air_true_speed_m_s(float calibrated_m_s, float static_pa)
{
    return calibrated_m_s / sqrtf(powf(static_pa / sea_level_pa, density_exponent));
}
