#include "epf_estimation.h"

#include <stdlib.h>

estimator_t* epf_estimation_new(void)
{
    estimator_t* const estimator = malloc(sizeof *estimator);
    if (estimator != NULL)
    {
        estimator_init(estimator);
    }
    return estimator;
}

void epf_estimation_free(estimator_t* estimator)
{
    free(estimator);
}

void epf_estimation_locate(estimator_t* estimator, float latitude_deg, float longitude_deg)
{
    estimator_locate(estimator, latitude_deg, longitude_deg);
}

void epf_estimation_step(estimator_t* estimator, const estimator_samples_t* samples, float dt_s, estimate_t* estimate)
{
    *estimate = estimator_update(estimator, samples, dt_s);
}

uint32_t epf_estimation_refused(const estimator_t* estimator, uint32_t sensor)
{
    return sensor < estimator_sensor_count ? estimator->refused[sensor] : 0U;
}

void epf_magnetic_field(float latitude_deg, float longitude_deg, vector_t* field_nt)
{
    *field_nt = magnetic_field_at(latitude_deg, longitude_deg);
}
