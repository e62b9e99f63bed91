#include "estimation/magnetic_field.h"

#include <math.h>
#include <stddef.h>

#include "common/angle.h"
#include "estimation/wmm_gen.h"

static const float equator_m = 6378137.0F;                ///< WGS 84
static const float eccentricity_squared = 6.69437999e-3F; ///< WGS 84
static const float reference_m = 6371200.0F;              ///< radius that the model's coefficients hold for
static const float recomputed_after_deg = 0.05F;          ///< 6 km; the declination changes by 0.02 deg at most there

/// A point of the ellipsoid as seen from the centre of the earth.
typedef struct
{
    float sin_latitude;
    float cos_latitude;
    float lower_rad;     ///< geodetic less geocentric latitude
    float closeness;     ///< the model's radius divided by the point's
    float longitude_rad; ///< east positive
} place_t;

/// Schmidt semi-normalised Legendre function of the colatitude.
typedef struct
{
    float value;
    float slope;    ///< derivative by the colatitude
    float quotient; ///< value divided by the sine of the colatitude (not in order 0), finite at the poles as well
} legendre_t;

static place_t place_of(float latitude_deg, float longitude_deg)
{
    const float latitude_rad = angle_to_rad(latitude_deg);
    const float sin_geodetic = sinf(latitude_rad);
    const float normal_m = equator_m / sqrtf(1.0F - eccentricity_squared * sin_geodetic * sin_geodetic);
    const float from_axis_m = normal_m * cosf(latitude_rad);
    const float above_equator_m = normal_m * (1.0F - eccentricity_squared) * sin_geodetic;
    const float radius_m = hypotf(from_axis_m, above_equator_m);
    return (place_t){
        .sin_latitude = above_equator_m / radius_m,
        .cos_latitude = from_axis_m / radius_m,
        .lower_rad = latitude_rad - atan2f(above_equator_m, from_axis_m),
        .closeness = reference_m / radius_m,
        .longitude_rad = angle_to_rad(longitude_deg),
    };
}

/// The function whose degree is its order, from the one before it.
static legendre_t next_order(const legendre_t* before, int order, const place_t* place)
{
    const float share = order > 1 ? sqrtf(1.0F - 0.5F / (float)order) : 1.0F;
    return (legendre_t){
        .value = share * place->cos_latitude * before->value,
        .slope = share * (place->cos_latitude * before->slope + place->sin_latitude * before->value),
        .quotient = order > 1 ? share * place->cos_latitude * before->quotient : 1.0F,
    };
}

/// The function of the next degree in the same order, from the two before it.
static legendre_t next_degree(const legendre_t* last, const legendre_t* before, int degree, int order,
                              const place_t* place)
{
    const float n = (float)degree;
    const float m = (float)order;
    const float divisor = 1.0F / sqrtf(n * n - m * m);
    const float ahead = (2.0F * n - 1.0F) * divisor;
    const float behind = sqrtf((n - 1.0F) * (n - 1.0F) - m * m) * divisor;
    return (legendre_t){
        .value = ahead * place->sin_latitude * last->value - behind * before->value,
        .slope =
            ahead * (place->sin_latitude * last->slope - place->cos_latitude * last->value) - behind * before->slope,
        .quotient = ahead * place->sin_latitude * last->quotient - behind * before->quotient,
    };
}

/// Field in geocentric axes (north, east, down).
static vector_t geocentric_nt(const place_t* place)
{
    vector_t sum = {0};
    legendre_t diagonal = {.value = 1.0F};
    float strength = place->closeness * place->closeness;
    const wmm_coefficients_t* pair = wmm_coefficients;
    for (int order = 0; order <= WMM_DEGREE; order++)
    {
        if (order > 0)
        {
            diagonal = next_order(&diagonal, order, place);
            strength *= place->closeness;
        }
        const float cosine = cosf((float)order * place->longitude_rad);
        const float sine = sinf((float)order * place->longitude_rad);
        legendre_t before = {0};
        legendre_t function = diagonal;
        float power = strength;
        for (int degree = order; degree <= WMM_DEGREE; degree++)
        {
            if (degree > order)
            {
                const legendre_t next = next_degree(&function, &before, degree, order, place);
                before = function;
                function = next;
                power *= place->closeness;
            }
            if (degree > 0)
            {
                const float along = pair->g * cosine + pair->h * sine;
                const float across = pair->g * sine - pair->h * cosine;
                sum.x += power * along * function.slope;
                sum.y += power * across * function.quotient * (float)order;
                sum.z -= power * along * function.value * ((float)degree + 1.0F);
                pair++;
            }
        }
    }
    return sum;
}

vector_t magnetic_field_at(float latitude_deg, float longitude_deg)
{
    const place_t place = place_of(latitude_deg, longitude_deg);
    const vector_t geocentric = geocentric_nt(&place);
    const float cosine = cosf(place.lower_rad);
    const float sine = sinf(place.lower_rad);
    return (vector_t){
        .x = geocentric.x * cosine + geocentric.z * sine,
        .y = geocentric.y,
        .z = geocentric.z * cosine - geocentric.x * sine,
    };
}

void magnetic_field_move(magnetic_field_t* magnetic, float latitude_deg, float longitude_deg)
{
    if (magnetic->is_known && fabsf(latitude_deg - magnetic->latitude_deg) < recomputed_after_deg &&
        fabsf(longitude_deg - magnetic->longitude_deg) < recomputed_after_deg)
    {
        return;
    }
    *magnetic = (magnetic_field_t){
        .is_known = true,
        .latitude_deg = latitude_deg,
        .longitude_deg = longitude_deg,
        .field_nt = magnetic_field_at(latitude_deg, longitude_deg),
    };
}

float magnetic_field_declination_deg(const magnetic_field_t* magnetic)
{
    return magnetic->is_known ? angle_to_deg(atan2f(magnetic->field_nt.y, magnetic->field_nt.x)) : NAN;
}
